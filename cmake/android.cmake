# Builds for Android 21 without its kit: Debian's clang-19, lld-19 and libc++'s headers; GNU's headers of the same
# processor stand in for Android's C library, and libraries of tools/packaging/android/stubs.txt for what it exports.
#   MARROW_ABI     arm64-v8a, armeabi-v7a or x86_64
#   MARROW_STUBS   the folder of the ABI's libraries, which tools/packaging/android/make_stubs.sh makes
# Where there is an NDK take its own toolchain file: headers that stand in may lie about what Marrow does not use.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_C_COMPILER clang-19)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_AR llvm-ar-19)
set(CMAKE_RANLIB llvm-ranlib-19)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES MARROW_ABI MARROW_STUBS)
if(MARROW_ABI STREQUAL "arm64-v8a")
  set(CMAKE_SYSTEM_PROCESSOR aarch64)
  set(target aarch64-linux-android21)
  set(headers "-isystem /usr/aarch64-linux-gnu/include")
elseif(MARROW_ABI STREQUAL "armeabi-v7a")
  set(CMAKE_SYSTEM_PROCESSOR armv7-a)
  set(target armv7a-linux-androideabi21)
  set(headers "-isystem /usr/arm-linux-gnueabi/include")
elseif(MARROW_ABI STREQUAL "x86_64")
  set(CMAKE_SYSTEM_PROCESSOR x86_64)
  set(target x86_64-linux-android21)
  set(headers "-isystem /usr/include/x86_64-linux-gnu -isystem /usr/include")
else()
  message(FATAL_ERROR "MARROW_ABI is arm64-v8a, armeabi-v7a or x86_64, not \"${MARROW_ABI}\"")
endif()
get_filename_component(stand_ins ${CMAKE_CURRENT_LIST_DIR}/../tests/platform/android/headers ABSOLUTE)
foreach(language C CXX)
  set(CMAKE_${language}_COMPILER_TARGET ${target})
  set(CMAKE_${language}_FLAGS_INIT "-nostdlibinc -isystem ${stand_ins} -isystem ${MARROW_STUBS}/include ${headers}")
endforeach()
string(PREPEND CMAKE_CXX_FLAGS_INIT "-nostdinc++ -isystem /usr/lib/llvm-19/include/c++/v1 ")
# No code of a compiler's library runs before or behind Marrow's, and 64-bit systems may have pages of 16 KB.
string(CONCAT CMAKE_SHARED_LINKER_FLAGS_INIT "-fuse-ld=lld-19 -nostdlib -L${MARROW_STUBS} -lc -lm "
  "-Wl,-z,max-page-size=16384 -Wl,-z,defs -Wl,--no-rosegment -Wl,--gc-sections")
if(MARROW_ABI STREQUAL "armeabi-v7a")
  # What the processor cannot divide, by the compiler's library for the same calling convention.
  file(GLOB helpers /usr/lib/gcc-cross/arm-linux-gnueabi/*/libgcc.a)
  string(APPEND CMAKE_SHARED_LINKER_FLAGS_INIT " -Wl,--exclude-libs,libgcc.a")
  set(CMAKE_C_STANDARD_LIBRARIES "${helpers}")
  set(CMAKE_CXX_STANDARD_LIBRARIES "${helpers}")
endif()
