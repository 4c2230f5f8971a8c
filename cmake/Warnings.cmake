# marrow_warnings(TARGET): the warnings that Marrow's own code is held to, never its dependencies'.
function(marrow_warnings target)
  if(MSVC)
    # cl and clang-cl, with their own names for them. 4324: padding by alignas; 4201: nameless structs; 5030: attributes
    # of GCC's, which are hints.
    target_compile_options(${target} PRIVATE /W4 /permissive- /utf-8 /wd4324 /wd4201 /wd5030)
    if(MARROW_WERROR)
      target_compile_options(${target} PRIVATE /WX)
    endif()
    return()
  endif()
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
    -Wold-style-cast -Wundef)
  # Clang counts double{x} as implicit.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wdouble-promotion)
  endif()
  # GCC for 32-bit ARM warns of every cast from bytes, which is how a file is used in place; load() checks boundaries.
  if(NOT (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND MARROW_ON_ARM32))
    target_compile_options(${target} PRIVATE -Wcast-align)
  endif()
  # GCC 12 sees overlapping copies in std::string's operator+ where there are none (GCC bug 105329, mended in 13).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
  if(MARROW_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

include(CheckCXXSymbolExists)
check_cxx_symbol_exists(__arm__ cstddef MARROW_ON_ARM32)
