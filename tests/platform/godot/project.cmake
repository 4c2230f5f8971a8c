# Adds the targets of targets.cmake to platform/godot, as CMAKE_PROJECT_marrow_godot_INCLUDE: one build of the runtime
# serves the page's commands and the tests.
enable_language(C)
cmake_language(EVAL CODE "cmake_language(DEFER CALL include [[${CMAKE_CURRENT_LIST_DIR}/targets.cmake]])")
