# The same character by C and by C++: packed with either codec, and not packed.
foreach(codec none draco meshopt)
  set(file ${FOLDER}/newt_${codec}.mrw)
  execute_process(COMMAND ${MARROW} cook ${SAMPLE} --mesh-codec ${codec} --clip-codec raw -o ${file}
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${C} ${file} OUTPUT_VARIABLE by_c COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CPP} ${file} OUTPUT_VARIABLE by_cpp COMMAND_ERROR_IS_FATAL ANY)
  if(NOT by_c STREQUAL "9 refused, 7 told\n${by_cpp}" OR NOT by_cpp MATCHES "^[0-9a-f]+\n$")
    message(FATAL_ERROR "${codec}: C says ${by_c}, C++ ${by_cpp}")
  endif()
  message("${codec}: ${by_cpp}")
endforeach()
