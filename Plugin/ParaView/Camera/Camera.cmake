# SPDX-License-Identifier: BSD-3-Clause
# The class that resets the camera, if ParaView was built with Qt. Appends to `panel`.
if(PARAVIEW_USE_QT)
  paraview_plugin_add_auto_start(
    CLASS_NAME pqUnitCamera
    INTERFACES interfaces
    SOURCES sources)
  set(unit_camera_sources Camera/pqUnitCamera.cxx Camera/pqUnitCamera.h)
  list(APPEND panel UI_INTERFACES ${interfaces} SOURCES ${sources} ${unit_camera_sources})
endif()

function(palpate_finish_unit_camera)
  if(PARAVIEW_USE_QT)
    target_include_directories(Palpate PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/Camera")
    set_property(SOURCE ${unit_camera_sources} APPEND PROPERTY COMPILE_OPTIONS
      -Wall -Wextra -Wshadow -Wformat=2 $<$<BOOL:${PALPATE_WERROR}>:-Werror>)
  endif()
endfunction()
