# SPDX-License-Identifier: BSD-3-Clause
# Makes two Debian packages of the build, for the system on which it was built (./run package): palpate for users, and
# palpate-dev for developers. They contain the install components runtime, python, plugin and development. The component
# Debian contains the files that only a package has; cmake --install does not install it by default.
# Plugin/Package/README.md gives the reasons.
set(palpate_package_dir "${PROJECT_SOURCE_DIR}/Plugin/Package")
set(palpate_doc_dir "${CMAKE_INSTALL_DATADIR}/doc")

if(NOT TARGET palpate OR CMAKE_CROSSCOMPILING OR PALPATE_SANITIZE)
  return()
endif()

# --- Integration of the program: man page, completion, menu
set(palpate_described "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_DATADIR}/described")
add_custom_command(
  OUTPUT "${palpate_described}/palpate.1.gz" "${palpate_described}/palpate"
  COMMAND /usr/bin/python3 "${palpate_package_dir}/describe_options.py"
    $<TARGET_FILE:palpate> "${PROJECT_VERSION}" "${palpate_described}"
  DEPENDS palpate "${palpate_package_dir}/describe_options.py" "${palpate_package_dir}/palpate.1.in"
  COMMENT "Man page and completion from palpate --help"
  VERBATIM)
add_custom_target(palpateDescribed ALL
  DEPENDS "${palpate_described}/palpate.1.gz" "${palpate_described}/palpate")
# All components that are packed; tests are not.
add_custom_target(palpatePacked DEPENDS palpateDescribed)
foreach(target IN ITEMS Palpate palpatePython palpateModules)
  if(TARGET ${target})
    add_dependencies(palpatePacked ${target})
  endif()
endforeach()
install(FILES "${palpate_described}/palpate.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT runtime)
install(FILES "${palpate_described}/palpate"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT runtime)
install(FILES "${palpate_package_dir}/palpate.desktop"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/applications" COMPONENT runtime)
install(FILES "${palpate_package_dir}/palpate.svg"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps" COMPONENT runtime)

# --- Description of both packages
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "press a tool against a body, see and feel the force")
set(CPACK_PACKAGE_NAME palpate)
set(CPACK_PACKAGE_CONTACT "Palpate maintainers <maintainers@palpate.example>")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_SOURCE_DIR}/build/package")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS "${palpate_package_dir}/Debian/FinishTree.cmake")
set(CPACK_COMPONENTS_ALL runtime python plugin development Debian DebianDevelopment)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
foreach(component IN ITEMS runtime python plugin Debian)
  string(TOUPPER ${component} component)
  set(CPACK_COMPONENT_${component}_GROUP palpate)
endforeach()
foreach(component IN ITEMS DEVELOPMENT DEBIANDEVELOPMENT)
  set(CPACK_COMPONENT_${component}_GROUP palpate-dev)
endforeach()

# --- palpate
find_package(Python3 COMPONENTS Interpreter REQUIRED)
math(EXPR palpate_next_python "${Python3_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PALPATE_PACKAGE_NAME palpate)
set(CPACK_DEBIAN_PALPATE_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PALPATE_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PALPATE_PACKAGE_DEPENDS "python3 (>= 3.${Python3_VERSION_MINOR}~), python3 (<< 3.${palpate_next_python}), python3-numpy")
set(palpate_vtk_dev paraview-dev)
if(ParaView_FOUND OR VTK_DIR MATCHES "paraview")
  string(APPEND CPACK_DEBIAN_PALPATE_PACKAGE_DEPENDS ", paraview, python3-paraview")
endif()
if(NOT VTK_DIR MATCHES "paraview") # before version 6, Debian's ParaView has a VTK of its own
  string(APPEND CPACK_DEBIAN_PALPATE_PACKAGE_DEPENDS ", python3-vtk9")
  set(palpate_vtk_dev libvtk9-dev)
endif()
set(CPACK_DEBIAN_PALPATE_PACKAGE_RECOMMENDS mricron-data)
set(CPACK_DEBIAN_PALPATE_PACKAGE_SUGGESTS "palpate-dev, xvfb")
set(CPACK_DEBIAN_PALPATE_DESCRIPTION
"Palpate pre-computes for each point of a body the force-deflection curve of a
rigid tool pressed there, and from these renders contact forces at haptic
rates.

This package holds the program palpate, its shared libraries, the plugin for
ParaView, which loads by itself, the Python module palpate, and a udev rule
for haptic devices.")

# --- palpate-dev, with the dependencies of its CMake package. A VTK with MPI needs MPI, on which paraview-dev does not
# depend.
set(CPACK_DEBIAN_PALPATE-DEV_PACKAGE_NAME palpate-dev)
set(CPACK_DEBIAN_PALPATE-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PALPATE-DEV_PACKAGE_DEPENDS "palpate (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}), libeigen3-dev, ${palpate_vtk_dev}, mpi-default-dev")
set(CPACK_DEBIAN_PALPATE-DEV_DESCRIPTION
"Palpate pre-computes for each point of a body the force-deflection curve of a
rigid tool pressed there, and from these renders contact forces at haptic
rates.

This package holds the headers for C, C++ and VTK, the CMake package Palpate,
and the sources and the protocol for self-built force devices.")

# --- The list in which ParaView looks for plugins, extended by one line.
set(palpate_diverted "")
if(ParaView_FOUND AND TARGET Palpate)
  set(palpate_paraview_dir "${CMAKE_INSTALL_LIBDIR}/paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
  set(palpate_own_list "/usr/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/palpate.plugins.xml")
  set(palpate_conf "/usr/${palpate_paraview_dir}/paraview.conf")
  set(palpate_lists "")
  if(EXISTS "${palpate_conf}")
    set(palpate_diverted "${palpate_conf}")
    if(EXISTS "${palpate_conf}.distrib") # Palpate is installed on this system
      string(APPEND palpate_conf ".distrib")
    endif()
    file(STRINGS "${palpate_conf}" palpate_lists)
    set(palpate_conf_dir "${palpate_paraview_dir}")
  else()
    file(GLOB palpate_lists "/usr/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/paraview.plugins.xml")
    set(palpate_conf_dir "${CMAKE_INSTALL_BINDIR}")
  endif()
  list(APPEND palpate_lists "${palpate_own_list}")
  list(JOIN palpate_lists "\n" palpate_lists)
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/Debian/paraview.conf" CONTENT "${palpate_lists}\n")
  install(FILES "${CMAKE_BINARY_DIR}/Debian/paraview.conf" DESTINATION "${palpate_conf_dir}"
    COMPONENT Debian EXCLUDE_FROM_ALL)
endif()

# --- Files that Debian requires of a package
string(TIMESTAMP palpate_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file("${palpate_package_dir}/Debian/changelog.in" "${CMAKE_BINARY_DIR}/Debian/changelog.Debian" @ONLY)
find_program(PALPATE_GZIP gzip)
execute_process(COMMAND "${PALPATE_GZIP}" -9nkf "${CMAKE_BINARY_DIR}/Debian/changelog.Debian"
  COMMAND_ERROR_IS_FATAL ANY)
foreach(package IN ITEMS palpate palpate-dev)
  set(component Debian)
  if(package STREQUAL "palpate-dev")
    set(component DebianDevelopment)
  endif()
  install(FILES "${CMAKE_BINARY_DIR}/Debian/changelog.Debian.gz" DESTINATION "${palpate_doc_dir}/${package}"
    COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${palpate_doc_dir}/${package}" RENAME copyright
    COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES "${palpate_package_dir}/Debian/${package}.overrides"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/lintian/overrides" RENAME ${package}
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()
set(palpate_scripts postinst postrm)
if(palpate_diverted)
  list(APPEND palpate_scripts preinst)
  set(palpate_undivert
    "dpkg-divert --package palpate --remove --rename --divert \"${palpate_diverted}.distrib\" \"${palpate_diverted}\"")
else()
  set(palpate_undivert ":") # without a postrm, CPack would add one that calls ldconfig, for which a trigger exists
endif()
foreach(script IN LISTS palpate_scripts)
  configure_file("${palpate_package_dir}/Debian/${script}.in" "${CMAKE_BINARY_DIR}/Debian/${script}" @ONLY
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endforeach()
list(TRANSFORM palpate_scripts PREPEND "${CMAKE_BINARY_DIR}/Debian/")
set(CPACK_DEBIAN_PALPATE_PACKAGE_CONTROL_EXTRA
  ${palpate_scripts} "${palpate_package_dir}/Debian/prerm" "${palpate_package_dir}/Debian/triggers")
include(CPack)
