# SPDX-License-Identifier: BSD-3-Clause
# The handle of Touch, if ParaView was built with Qt. Appends the arguments for paraview_add_plugin() to `panel`.
if(PARAVIEW_USE_QT)
  paraview_plugin_add_property_widget(
    KIND GROUP_WIDGET
    TYPE "touch_handle"
    CLASS_NAME pqTouchHandle
    INTERFACES interfaces
    SOURCES sources)
  set(touch_handle_sources Handle/pqTouchHandle.cxx Handle/pqTouchHandle.h)
  list(APPEND panel UI_INTERFACES ${interfaces} SOURCES ${sources} ${touch_handle_sources})
endif()

function(palpate_finish_touch_handle)
  if(PARAVIEW_USE_QT)
    target_include_directories(Palpate PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/Handle")
    target_link_libraries(Palpate PRIVATE ParaView::pqApplicationComponents
      VTK::GUISupportQt) # the headers of ParaView 6 include it without declaring the dependency
    set_property(SOURCE ${touch_handle_sources} APPEND PROPERTY COMPILE_OPTIONS
      -Wall -Wextra -Wshadow -Wformat=2 $<$<BOOL:${PALPATE_WERROR}>:-Werror>)
  endif()
endfunction()
