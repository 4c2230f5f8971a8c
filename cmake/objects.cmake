# Compiles for systems whose headers cannot be had here, to objects that nothing links: MARROW_TARGET is Clang's name of
# the system, MARROW_HEADERS where a GNU C and C++ library for the same processor stands in for its own.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET ${MARROW_TARGET})
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES MARROW_TARGET MARROW_HEADERS)
get_filename_component(triple ${MARROW_HEADERS} NAME)
# What GNU's headers must not say here: Android passes floats as whole numbers, for which they want a header that is
# empty; Darwin's 64-bit numbers are another type, which the compiler's own header knows, and its compilers have a
# keyword that is a macro there. GNU compilers define _GNU_SOURCE for C++.
set(stand_in ${CMAKE_BINARY_DIR}/stand_in)
execute_process(COMMAND clang++-19 -print-resource-dir OUTPUT_VARIABLE resources OUTPUT_STRIP_TRAILING_WHITESPACE)
file(WRITE ${stand_in}/gnu/stubs-soft.h "")
file(WRITE ${stand_in}/stdint.h "#pragma once
#undef __STDC_HOSTED__
#define __STDC_HOSTED__ 0
#include \"${resources}/include/stdint.h\"
#undef __STDC_HOSTED__
#define __STDC_HOSTED__ 1
#undef __int_least64_t
#undef __uint_least64_t
#undef __int_least32_t
#undef __uint_least32_t
#undef __int_least16_t
#undef __uint_least16_t
#undef __int_least8_t
#undef __uint_least8_t
")
foreach(header intn uintn)
  file(WRITE ${stand_in}/bits/stdint-${header}.h "#include <stdint.h>\n")
endforeach()
set(CMAKE_CXX_FLAGS_INIT "-D_GNU_SOURCE -U__nonnull -nostdlibinc -isystem ${stand_in} \
-isystem ${MARROW_HEADERS}/include/c++/12 -isystem ${MARROW_HEADERS}/include/c++/12/${triple} \
-isystem ${MARROW_HEADERS}/include")
