# marrow_warnings(TARGET): the warnings that Marrow's own code is held to, never its dependencies'.
function(marrow_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
    -Wold-style-cast -Wundef -Wcast-align -Wdouble-promotion)
  if(MARROW_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
