# Compiles for iOS and macOS by Debian's Clang, where there is no Xcode: see tools/apple.sh. MARROW_TARGET is Clang's
# name of the system, as arm64-apple-ios14.0-simulator. libc++ is LLVM's, the C library's headers are the few declarations in
# tests/platform/apple/headers; what is compiled calls Apple's own.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET ${MARROW_TARGET})
set(CMAKE_AR llvm-ar-19 CACHE STRING "" FORCE)
set(CMAKE_RANLIB llvm-ranlib-19 CACHE STRING "" FORCE)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES MARROW_TARGET)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_FIND_ROOT_PATH ${CMAKE_CURRENT_LIST_DIR}/none)
set(headers ${CMAKE_CURRENT_LIST_DIR}/../tests/platform/apple/headers)
set(CMAKE_CXX_FLAGS_INIT "-nostdinc++ -nostdlibinc -isystem ${headers}/libc++ \
-isystem /usr/lib/llvm-19/include/c++/v1 -isystem ${headers}/c")
