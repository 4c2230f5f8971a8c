# What marrow::draco and marrow::meshopt are built on, found or fetched as in Dependencies.cmake.
if(MARROW_COOKER AND CMAKE_SYSTEM_NAME STREQUAL WASI)
  include(cmake/WasmCodecs.cmake)
  return()
endif()
include(FetchContent)
if(MARROW_DRACO)
  FetchContent_Declare(draco GIT_REPOSITORY https://github.com/google/draco.git GIT_TAG 1.5.6 FIND_PACKAGE_ARGS NAMES draco)
  FetchContent_MakeAvailable(draco)
endif()
if(MARROW_MESHOPT OR MARROW_DRACO)  # Draco's triangles are put into an order that GPUs like
  FetchContent_Declare(meshoptimizer GIT_REPOSITORY https://github.com/zeux/meshoptimizer.git GIT_TAG v0.18
    FIND_PACKAGE_ARGS NAMES meshoptimizer)
  FetchContent_MakeAvailable(meshoptimizer)
  if(NOT TARGET meshoptimizer::meshoptimizer)
    add_library(meshoptimizer::meshoptimizer ALIAS meshoptimizer)
  endif()
endif()
