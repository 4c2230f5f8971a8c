# marrow_library(NAME [EXCEPTIONS] [NEEDS names…] [PACKAGES packages…] [LIBRARIES names…] [HEADERS files…] SOURCES files…)
#
# The library marrow_NAME, called marrow::NAME here, in a game's build and by find_package. It is static, or shared where
# BUILD_SHARED_LIBS says so, and is installed as the component marrow_NAME, with a file for pkg-config.
# NEEDS: Marrow's libraries that it is used with. PACKAGES: what find_package must find for its users; each has a target
# PACKAGE::PACKAGE, to which the library is linked. LIBRARIES: what the linker knows these as, and others.
include(GNUInstallDirs)

# While the major number is 0, a new minor one may break programs.
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(MARROW_SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set(MARROW_COMPATIBILITY SameMinorVersion)
else()
  set(MARROW_SOVERSION ${PROJECT_VERSION_MAJOR})
  set(MARROW_COMPATIBILITY SameMajorVersion)
endif()

function(marrow_library name)
  cmake_parse_arguments(PARSE_ARGV 1 its "EXCEPTIONS" "" "NEEDS;PACKAGES;LIBRARIES;HEADERS;SOURCES")
  set(target marrow_${name})
  add_library(${target} ${its_SOURCES})
  add_library(marrow::${name} ALIAS ${target})
  # Static code may end up in a game's shared library. What is internal is hidden in both kinds.
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON VERSION ${PROJECT_VERSION} SOVERSION ${MARROW_SOVERSION}
    INSTALL_RPATH "$<IF:$<PLATFORM_ID:Darwin>,@loader_path,$ORIGIN>")
  if(BUILD_SHARED_LIBS)
    target_compile_definitions(${target} PRIVATE MARROW_BUILDS_SHARED)
    if(UNIX AND NOT APPLE)
      # A library that calls what another one hides does not link.
      target_link_options(${target} PRIVATE -Wl,-Bsymbolic-functions -Wl,-z,defs
        -Wl,--version-script=${PROJECT_SOURCE_DIR}/cmake/exports.map)
      set_target_properties(${target} PROPERTIES LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/exports.map)
    endif()
  endif()
  if(NOT MARROW_INSTALL AND NOT PROJECT_IS_TOP_LEVEL)
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
  target_compile_features(${target} PUBLIC cxx_std_20)
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/include)
    target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>)
  endif()
  target_include_directories(${target} PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/runtime)
  if(NOT MARROW_CALL_ERRORS)
    target_compile_definitions(${target} PUBLIC $<BUILD_INTERFACE:MARROW_CALL_ERRORS=0>)
  endif()
  if(MARROW_ZONES)
    target_compile_definitions(${target} PRIVATE MARROW_ZONES=1)
  endif()
  if(MARROW_SIMD STREQUAL "scalar")
    target_compile_definitions(${target} PUBLIC $<BUILD_INTERFACE:MARROW_SCALAR=1>)
  endif()
  if(its_EXCEPTIONS)
    marrow_same_bits(${target})
  else()
    marrow_runtime_flags(${target})
  endif()
  marrow_warnings(${target})
  list(TRANSFORM its_NEEDS PREPEND marrow_ OUTPUT_VARIABLE needs)
  target_link_libraries(${target} PUBLIC ${needs})
  foreach(package ${its_PACKAGES})
    target_link_libraries(${target} PRIVATE ${package}::${package})
  endforeach()
  marrow_install_library(${name} "${its_NEEDS}" "${its_PACKAGES}" "${its_LIBRARIES}" "${its_HEADERS}")
endfunction()
