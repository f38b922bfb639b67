# SPDX-License-Identifier: BSD-3-Clause
# The help pages for ParaView, with the pictures of the manual, in the order of contents.xml. Without contents.xml,
# ParaView would list the pages by file name, and the index twice. Appends the arguments for paraview_add_plugin() to
# `panel`.
if(PARAVIEW_USE_QT)
  set(help "${CMAKE_CURRENT_BINARY_DIR}/HelpPages")
  set(help_pages)
  file(GLOB help_files CONFIGURE_DEPENDS
    "${CMAKE_CURRENT_SOURCE_DIR}/Help/*.html" "${CMAKE_CURRENT_SOURCE_DIR}/Help/*.css"
    "${PROJECT_SOURCE_DIR}/Data/Pictures/paraview_*.png")
  foreach(file IN LISTS help_files)
    get_filename_component(name "${file}" NAME)
    configure_file("${file}" "${help}/${name}" COPYONLY)
    list(APPEND help_pages "${help}/${name}")
  endforeach()
  set(contents "${CMAKE_CURRENT_SOURCE_DIR}/Help/contents.xml")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${contents}")
  file(READ "${contents}" help_contents)
  list(APPEND panel DOCUMENTATION_TOC "${help_contents}")
  list(APPEND panel DOCUMENTATION_DIR "${help}" DOCUMENTATION_DEPENDENCIES ${help_pages})
endif()
