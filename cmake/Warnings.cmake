# marrow_warnings(TARGET): the warnings that Marrow's own code is held to, never its dependencies'.
function(marrow_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
    -Wold-style-cast -Wundef -Wcast-align)
  # Clang counts double{x} as implicit.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wdouble-promotion)
  endif()
  # GCC 12 sees overlapping copies in std::string's operator+ where there are none (GCC bug 105329, mended in 13).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
  if(MARROW_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
