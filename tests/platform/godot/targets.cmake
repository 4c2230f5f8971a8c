# What tools/check/godot.sh runs: libraries without a codec, under sanitizers, and with headers of another release, and
# the programs that they are held against.
set(here ${CMAKE_CURRENT_LIST_DIR})
set(MARROW_MESHOPT OFF)
marrow_godot_common(lacking_common)
marrow_godot_library(marrow_godot_lacking 3 lacking_common)

set(sanitize -fsanitize=address,undefined -fno-sanitize-recover=all -g -O0)
marrow_godot_common(sanitized_common)
marrow_godot_library(marrow_godot_sanitized 4 sanitized_common)
add_executable(mock_host ${here}/mock_host.cpp ${here}/mock_engine.cpp)
target_compile_features(mock_host PRIVATE cxx_std_20)
target_link_libraries(mock_host PRIVATE ${CMAKE_DL_LIBS})
foreach(target sanitized_common marrow_godot_sanitized mock_host)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Werror ${sanitize})
  target_link_options(${target} PRIVATE ${sanitize})
endforeach()

file(READ ${CMAKE_CURRENT_SOURCE_DIR}/../../runtime/include/marrow/c.h header)
string(REGEX REPLACE "#define MRW_ABI 0x[0-9a-f]+u" "#define MRW_ABI 1u" other "${header}")
file(CONFIGURE OUTPUT other/marrow/c.h CONTENT "${other}" @ONLY)
marrow_godot_common(other_common)
target_include_directories(other_common BEFORE PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/other)
target_compile_options(other_common PRIVATE -O0)
marrow_godot_library(marrow_godot_other 4 other_common)

add_executable(reference ${here}/reference.c)
target_compile_options(reference PRIVATE -std=c99 -pedantic -Wall -Wextra -Werror)
target_link_libraries(reference PRIVATE marrow::c marrow::draco)
foreach(target lacking_common marrow_godot_lacking sanitized_common marrow_godot_sanitized mock_host other_common
    marrow_godot_other reference)
  set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON)
endforeach()
