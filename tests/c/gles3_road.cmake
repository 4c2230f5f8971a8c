# The same pictures by C and by C++.
set(file ${FOLDER}/newt_on_gpu.mrw)
execute_process(COMMAND ${MARROW} cook ${SAMPLE} --mesh-codec none --clip-codec raw -o ${file} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${C} ${file} OUTPUT_VARIABLE by_c COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CPP} ${file} OUTPUT_VARIABLE by_cpp COMMAND_ERROR_IS_FATAL ANY)
if(NOT by_c STREQUAL by_cpp OR NOT by_cpp MATCHES "crowd: [0-9a-f]+, [0-9]+ pixels\n.*of 5 tried\n")
  message(FATAL_ERROR "C says\n${by_c}C++\n${by_cpp}")
endif()
message("${by_cpp}")
