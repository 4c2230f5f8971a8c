# marrow_embed(TARGET NAME FILE): compiles FILE into TARGET as `extern const unsigned char NAME[]` (zero-terminated) and
# `extern const unsigned long long NAME_size` (without the zero) in namespace marrow::embedded.
set(MARROW_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed.cmake)
function(marrow_embed target name file)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}.embedded.cpp)
  get_filename_component(file ${file} ABSOLUTE)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DIN=${file} -DOUT=${output} -DNAME=${name} -P ${MARROW_EMBED_SCRIPT}
    DEPENDS ${file} ${MARROW_EMBED_SCRIPT}
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
