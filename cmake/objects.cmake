# Compiles for systems whose headers cannot be had here, to objects that nothing links: MARROW_TARGET is Clang's name of
# the system, MARROW_HEADERS where a GNU C and C++ library for the same processor stands in for its own.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET ${MARROW_TARGET})
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES MARROW_TARGET MARROW_HEADERS)
get_filename_component(triple ${MARROW_HEADERS} NAME)
# Darwin's compilers know a keyword that GNU's headers use for a macro; Android's floats are passed as ints, for which
# GNU's headers want one that is empty.
file(WRITE ${CMAKE_BINARY_DIR}/stand_in/gnu/stubs-soft.h "")
set(CMAKE_CXX_FLAGS_INIT "-U__nonnull -nostdlibinc -isystem ${CMAKE_BINARY_DIR}/stand_in \
-isystem ${MARROW_HEADERS}/include/c++/12 -isystem ${MARROW_HEADERS}/include/c++/12/${triple} \
-isystem ${MARROW_HEADERS}/include")
