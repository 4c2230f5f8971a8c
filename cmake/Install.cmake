# What `cmake --install` puts into place, each library as a component of its own: marrow_runtime, marrow_draco, …,
# marrow_program. Nothing that is installed names a folder of this machine.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(MARROW_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/marrow)
set_property(GLOBAL PROPERTY MARROW_COMPONENTS "")
set_property(GLOBAL PROPERTY MARROW_COMPONENT_NEEDS "")

# The file for pkg-config: `marrow` is the runtime, `marrow-NAME` any other.
function(marrow_write_pc name needs libraries)
  set(PC_NAME marrow-${name})
  if(name STREQUAL "runtime")
    set(PC_NAME marrow)
  endif()
  list(TRANSFORM needs PREPEND marrow-)
  list(TRANSFORM needs REPLACE "^marrow-runtime$" marrow)
  list(JOIN needs " " PC_REQUIRES)
  set(PC_LIBRARIES -lmarrow_${name})
  if(NOT BUILD_SHARED_LIBS)  # a shared one names them itself
    list(TRANSFORM libraries PREPEND " -l")
    string(APPEND PC_LIBRARIES ${libraries})
  endif()
  file(RELATIVE_PATH PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  string(REGEX REPLACE "/$" "" PC_PREFIX ${PC_PREFIX})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/marrow.pc.in ${PROJECT_BINARY_DIR}/package/${PC_NAME}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/package/${PC_NAME}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT marrow_${name})
endfunction()

function(marrow_install_library name needs packages libraries headers)
  if(NOT MARROW_INSTALL)
    return()
  endif()
  foreach(package ${packages})
    get_target_property(found ${package}::${package} IMPORTED)
    if(NOT found)
      message(STATUS "marrow::${name} is built but not installed: ${package} was fetched, and is not installed itself")
      return()
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY MARROW_COMPONENTS ${name})
  set_property(GLOBAL APPEND_STRING PROPERTY MARROW_COMPONENT_NEEDS
    "set(marrow_${name}_needs ${needs})\nset(marrow_${name}_packages ${packages})\n")
  install(TARGETS marrow_${name} EXPORT marrow-${name}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT marrow_${name}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT marrow_${name}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT marrow_${name})
  install(EXPORT marrow-${name} NAMESPACE marrow:: DESTINATION ${MARROW_PACKAGE_DIR} COMPONENT marrow_${name})
  install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/marrow COMPONENT marrow_${name})
  foreach(package ${packages})  # where Debian and vcpkg keep what a library's licence asks to be shown
    find_file(MARROW_LICENCE_${package} NAMES copyright PATHS /usr/share/doc/lib${package}-dev ${${package}_DIR} NO_DEFAULT_PATH)
    mark_as_advanced(MARROW_LICENCE_${package})
    if(MARROW_LICENCE_${package})
      install(FILES ${MARROW_LICENCE_${package}} DESTINATION ${CMAKE_INSTALL_DOCDIR}/licenses RENAME ${package}.txt
        COMPONENT marrow_${name})
    endif()
    if(package STREQUAL "draco" AND EXISTS /usr/share/common-licenses/Apache-2.0)  # to which Debian refers
      install(FILES /usr/share/common-licenses/Apache-2.0 DESTINATION ${CMAKE_INSTALL_DOCDIR}/licenses
        RENAME Apache-2.0.txt COMPONENT marrow_${name})
    endif()
  endforeach()
  marrow_write_pc(${name} "${needs}" "${libraries}")
endfunction()

# After the last library.
function(marrow_install_package)
  if(NOT MARROW_INSTALL)
    return()
  endif()
  get_property(MARROW_COMPONENTS GLOBAL PROPERTY MARROW_COMPONENTS)
  get_property(MARROW_COMPONENT_NEEDS GLOBAL PROPERTY MARROW_COMPONENT_NEEDS)
  set(package ${PROJECT_BINARY_DIR}/package)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/marrow-config.cmake.in ${package}/marrow-config.cmake
    INSTALL_DESTINATION ${MARROW_PACKAGE_DIR})
  write_basic_package_version_file(${package}/marrow-config-version.cmake COMPATIBILITY ${MARROW_COMPATIBILITY})
  install(FILES ${package}/marrow-config.cmake ${package}/marrow-config-version.cmake DESTINATION ${MARROW_PACKAGE_DIR}
    COMPONENT marrow_runtime)
  install(FILES LICENSE CHANGELOG.md THIRD_PARTY.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT marrow_runtime)
  if(MARROW_TOOLS)
    install(TARGETS marrow RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT marrow_program)
  endif()
endfunction()
