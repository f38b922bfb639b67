# SPDX-License-Identifier: BSD-3-Clause
# The dock *Live Touch*, which is part of the plugin if ParaView was built with Qt. A ParaView without Qt, such as a
# server on a cluster, gets the plugin without the dock.
set(panel)
if(PARAVIEW_USE_QT)
  paraview_plugin_add_dock_window(
    CLASS_NAME pqLiveTouchPanel
    DOCK_AREA Right
    INTERFACES interfaces
    SOURCES sources)
  set(panel_sources
    Panel/LiveTouchForm.cxx
    Panel/LiveTouchPlace.cxx
    Panel/LiveTouchPreparation.cxx
    Panel/LiveTouchSession.cxx
    Panel/LiveTouchSource.cxx
    Panel/LiveTouchStage.cxx
    Panel/pqForceBar.cxx
    Panel/pqForceBar.h
    Panel/pqLiveTouchPanel.cxx
    Panel/pqLiveTouchPanel.h)
  set(panel UI_INTERFACES ${interfaces} SOURCES ${sources} ${panel_sources})
endif()

function(palpate_finish_panel)
  if(PARAVIEW_USE_QT)
    target_include_directories(Palpate PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/Panel")
    set_property(SOURCE ${panel_sources} APPEND PROPERTY COMPILE_OPTIONS
      -Wall -Wextra -Wshadow -Wformat=2 $<$<BOOL:${PALPATE_WERROR}>:-Werror>)
  endif()
endfunction()
