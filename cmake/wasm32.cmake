# Cross-builds for WebAssembly by Clang with WASI's C library, and runs programs in node, see tools/wasi.mjs.
# MARROW_WASM_SIMD=ON: with the 128-bit SIMD that browsers have had since 2021.
set(CMAKE_SYSTEM_NAME WASI)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
find_program(CMAKE_AR NAMES llvm-ar-19 llvm-ar REQUIRED)
find_program(CMAKE_RANLIB NAMES llvm-ranlib-19 llvm-ranlib REQUIRED)
set(CMAKE_CXX_FLAGS_INIT -fno-exceptions)
if(MARROW_WASM_SIMD)
  string(APPEND CMAKE_CXX_FLAGS_INIT " -msimd128")
endif()
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES MARROW_WASM_SIMD)
set(CMAKE_CROSSCOMPILING_EMULATOR node --no-warnings --experimental-wasi-unstable-preview1
  ${CMAKE_CURRENT_LIST_DIR}/../tools/wasi.mjs)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
