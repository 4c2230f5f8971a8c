# For kits and other checks that ask whether something builds and runs, not how fast: compiles several files at a time
# with little optimisation, in a third of the time. A toolchain file, so that CMake takes it from the environment, by
# CMAKE_TOOLCHAIN_FILE, while commands stay those of the manual. The bits of poses are the same.
set(CMAKE_UNITY_BUILD ON CACHE BOOL "")
foreach(type RELEASE MINSIZEREL)
  set(CMAKE_C_FLAGS_${type} "-O1 -DNDEBUG" CACHE STRING "")
  set(CMAKE_CXX_FLAGS_${type} "-O1 -DNDEBUG" CACHE STRING "")
endforeach()
