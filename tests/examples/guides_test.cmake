# cookbook_hands, …: programs of guides.cmake. Each prints what its recipes came to.
function(expect_printed program pattern)
  execute_process(COMMAND ${${program}} ${FOLDER}/guides/newt.mrw ${ARGN} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  if(NOT text MATCHES "^${pattern}$")
    message(FATAL_ERROR "${program} printed: ${text}")
  endif()
  message("${text}")
endfunction()
function(expect_missing program)
  execute_process(COMMAND ${${program}} nowhere.mrw ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE error)
  if(code EQUAL 0 OR NOT error MATCHES "nowhere\\.mrw: No such file or directory")
    message(FATAL_ERROR "${program} says of a file that is not there: ${code} ${text}${error}")
  endif()
endfunction()

file(REMOVE_RECURSE ${FOLDER}/guides)
file(MAKE_DIRECTORY ${FOLDER}/guides)
execute_process(COMMAND ${MARROW} sample -o ${FOLDER}/guides/newt.glb COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${MARROW} cook ${FOLDER}/guides/newt.glb --clip-codec raw --mesh-codec none
  -o ${FOLDER}/guides/newt.mrw COMMAND_ERROR_IS_FATAL ANY)

set(near "0\\.[0-4][0-9]")  # mm, or degrees
expect_printed(cookbook_hands "rail: 7[0-9] frames, the hand at most ${near} mm off
pole: the hand ${near} mm off, the elbow [0-9]+ mm from the clip's
wheel: turned by 34 degrees, the hands at most ${near} mm off
hip: the hand at most ${near} mm off
")
expect_printed(cookbook_look "look: the eyes ${near} and ${near} degrees off
weapon: the target seen in 60 frames of 60, the ray ${near} mm off
")
expect_printed(cookbook_legs "stairs: 0\\.[23][0-9] m up, a standing foot at most [0-4]\\.[0-9] mm through a step
seat of 0\\.25 m: ankles and toes at most ${near} mm off
seat of 0\\.32 m: ankles and toes at most ${near} mm off
")
expect_printed(cookbook_body "door: the hand ${near} mm off, the feet at most ${near}, the pelvis [1-9][0-9]* mm down, [0-9]+ iterations
tail: at most ${near} mm off its point, and 1\\.[45][0-9] m/s fast
limits ignored: the hand ${near} mm off, the elbow [5-9][0-9]\\.[0-9] degrees beyond its limit
limits kept: the hand ${near} mm off, the elbow 0\\.0 degrees beyond its limit
")
foreach(program cookbook_hands cookbook_look cookbook_legs cookbook_body moving_frame)
  expect_missing(${program})
endforeach()
expect_printed(moving_frame "44 joints, 40 matrices, vertex 0 at [0-9. -]+ m
")

# What Marrow says of mistakes, as the page quotes it; without names where they are compiled out.
execute_process(COMMAND ${MARROW} cook ${FOLDER}/guides/newt.glb --clip-codec raw -o ${FOLDER}/guides/packed.mrw
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${trouble_trouble} ${FOLDER}/guides/packed.mrw ${FOLDER}/guides/newt.mrw OUTPUT_VARIABLE text
  COMMAND_ERROR_IS_FATAL ANY)
file(READ ${SAID} said)
string(REGEX REPLACE "[a-z_]+\\(\\) wants [^\n]*\n" "" silent "${said}")
if(NOT text STREQUAL said AND NOT text STREQUAL silent)
  message(FATAL_ERROR "trouble printed: ${text}")
endif()

if(DEFINED gles_start)
  foreach(program gles_start gles_passes gles_crowd)
    expect_missing(${program} ${FOLDER}/guides)
  endforeach()
  set(rows "[a-z]+ [^\n]* [0-9.e-]+ m off\n")
  set(end "taken: [a-z]+\nglBindTexture: error 0x0500\n")
  # On a busy machine a path may count as slow.
  expect_printed(gles_start "${rows}${rows}${rows}${rows}${rows}${end}" ${FOLDER}/guides)
  expect_printed(gles_start "as it was\n${end}" ${FOLDER}/guides)
  expect_printed(gles_passes "frame 0: [1-9][0-9]+ pixels, 0 of them moved
frame 1: [1-9][0-9]+ pixels, [1-9][0-9][0-9][0-9]+ of them moved
GL errors: 0
")
  expect_printed(gles_crowd "0\\.0 s: [1-9][0-9]+ pixels, the hand of number 3 at -6\\.1[0-9]+ 0\\.5[0-9]+ 0\\.1[0-9]+
2\\.1 s: [1-9][0-9]+ pixels, the hand of number 3 at -6\\.1[0-9]+ 0\\.4[0-9]+ 0\\.0[0-9]+
3\\.0 s: [1-9][0-9]+ pixels, the hand of number 3 at -6\\.1[0-9]+ 0\\.5[0-9]+ 0\\.0[0-9]+
GL errors: 0
")
endif()
