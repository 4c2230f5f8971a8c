# The programs in examples do what they say with the sample, and the documents show them as they are built.
function(expect_shown document program)
  file(READ ${SOURCE}/${document} text)
  file(READ ${SOURCE}/tests/examples/${program} wanted)
  string(REGEX REPLACE ".*\\." "" language ${program})
  string(FIND "${text}" "```${language}\n${wanted}```" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "${program} in ${document} differs from tests/examples/${program}")
  endif()
endfunction()

# FILES: a list
function(expect_printed program files pattern)
  execute_process(COMMAND ${program} ${files} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "${program} printed: ${text}")
  endif()
  message("${text}")
endfunction()

# ARGN: what comes after the file
function(expect_missing program)
  execute_process(COMMAND ${program} nowhere.mrw ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE error)
  if(code EQUAL 0 OR NOT error MATCHES "nowhere\\.mrw: No such file or directory")
    message(FATAL_ERROR "${program} says of a file that is not there: ${code} ${text}${error}")
  endif()
endfunction()

expect_shown(README.md play.cpp)
expect_shown(docs/c.md play.c)
expect_shown(docs/c.md draw.c)
expect_shown(docs/threads.md jobs.cpp)
set(sample ${FOLDER}/examples)
execute_process(COMMAND ${MARROW} sample -o ${sample}.glb COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${MARROW} cook ${sample}.glb --clip-codec raw -o ${sample}.mrw COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${MARROW} cook ${sample}.glb --clip-codec raw --mesh-codec none -o ${sample}_plain.mrw
  COMMAND_ERROR_IS_FATAL ANY)
expect_printed(${PLAY} ${sample}_plain.mrw "^vertex 0 at -?[0-9.e-]+ -?[0-9.e-]+ -?[0-9.e-]+ m\n$")
expect_printed(${PLAY_C} ${sample}.mrw "^[a-z]+: vertex 0 at -?[0-9.e-]+ -?[0-9.e-]+ -?[0-9.e-]+ m\n$")
foreach(program ${PLAY} ${PLAY_C} ${CROWD} ${DRAW} ${DRAW_C})
  expect_missing(${program})
endforeach()
expect_missing(${JOBS} nowhere.mrw)
expect_printed(${CROWD} ${sample}_plain.mrw "^100 characters, 200 feet on the ground\n$")
execute_process(COMMAND ${MARROW} cook ${sample}.glb --clip-codec raw --mesh-codec meshopt -o ${sample}_fast.mrw
  COMMAND_ERROR_IS_FATAL ANY)
expect_printed(${JOBS} "${sample}.mrw;${sample}_fast.mrw"
  "^200 characters; the other file took [1-9][0-9]* steps, the longest [0-9.]+ ms, and their place in frame [0-9]+\n$")
if(DRAW)  # as large before the context is lost as after
  expect_printed(${DRAW} ${sample}_plain.mrw "^frame 0: 2[0-9]+ pixels\nframe 29: 2[0-9]+ pixels\nframe 58: 2[0-9]+ pixels\n$")
  expect_printed(${DRAW_C} ${sample}_plain.mrw "^[1-9] meshes, 2[0-9]+ pixels\n$")
endif()

# One program is any character: four rigs, each asked to go 1 m/s faster a second for 4 s, which is 7.97 m; the fox, in
# centimetres, hardly ends its first step, and is not heard.
if(DEFINED ENV{MARROW_ASSETS})
  set(ASSETS $ENV{MARROW_ASSETS})
endif()
set(steps "left_[a-z]+ at .*right_[a-z]+ at .*")
set(steps_of_Fox ".*")
function(expect_hero rig)
  if(NOT EXISTS ${ASSETS}/${rig}.glb)
    message("hero: skipped, as there is no ${ASSETS}/${rig}.glb")
    return()
  endif()
  execute_process(COMMAND ${MARROW} cook ${ASSETS}/${rig}.glb --root *=ground --mesh-codec none --images none
    -o ${sample}_hero.mrw COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET ERROR_QUIET)
  expect_printed(${HERO} "${sample}_hero.mrw;${ARGN}" "${steps${heard}}went 7\\.[79][0-9] m\n$")
endfunction()

# The same character by a graph.
file(READ ${SOURCE}/tests/examples/behave.anim.toml graph)
function(expect_behaviour rig idle walk run strike)
  if(NOT EXISTS ${ASSETS}/${rig}.glb)
    message("behave: skipped, as there is no ${ASSETS}/${rig}.glb")
    return()
  endif()
  set(text "${graph}")
  foreach(clip idle walk run strike)
    string(REPLACE "pose = \"${clip}\"" "pose = <${clip}>" text "${text}")
  endforeach()
  foreach(clip idle walk run strike)
    string(REPLACE "<${clip}>" "\"${${clip}}\"" text "${text}")
  endforeach()
  file(WRITE ${sample}_behave.anim.toml "${text}")
  execute_process(COMMAND ${MARROW} cook ${ASSETS}/${rig}.glb --graph ${sample}_behave.anim.toml --root *=ground
    --mesh-codec none --images none -o ${sample}_behave.mrw COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET ERROR_QUIET)
  expect_printed(${BEHAVE} ${sample}_behave.mrw "${steps${heard}}went (7\\.[79]|8\\.0)[0-9] m\n$")
endfunction()
foreach(expect expect_hero expect_behaviour)
  cmake_language(CALL ${expect} pab pab_crossarms pab_walk_raw pab_run_raw pab_crackhead)
  cmake_language(CALL ${expect} KayKit_Knight Idle Walking_A Running_A 1H_Melee_Attack_Chop)
  cmake_language(CALL ${expect} godot_robot idle run walk shooting)  # as fast as their feet go
  set(heard _of_Fox)
  cmake_language(CALL ${expect} Fox Survey Walk Run Survey)
  set(heard)
endforeach()

# The cooker as a library writes what the program writes, and says how far it has come.
execute_process(COMMAND ${COOK_IN_MEMORY} ${sample}.glb ${sample}_in_memory.mrw OUTPUT_VARIABLE told COMMAND_ERROR_IS_FATAL ANY)
if(NOT told MATCHES "^read 0/0\nprepare 0/0\nmesh 0/0\nclip 0/0\nclip 1/[0-9]+\n.*write 0/0\n[0-9]+ bytes, [0-9]+ warnings\n$")
  message(FATAL_ERROR "cook_in_memory says: ${told}")
endif()
execute_process(COMMAND ${MARROW} cook ${sample}.glb --mesh-codec meshopt --lod 0.5 -o ${sample}_by_program.mrw
  COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET ERROR_QUIET)
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${sample}_in_memory.mrw ${sample}_by_program.mrw
  COMMAND_ERROR_IS_FATAL ANY)
