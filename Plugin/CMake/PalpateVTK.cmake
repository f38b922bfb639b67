# SPDX-License-Identifier: BSD-3-Clause
# Finds VTK (that of ParaView if ParaView is installed), and builds Palpate's VTK modules and their Python
# wrapping. Only Plugin/ParaView may need ParaView itself.
option(PALPATE_USE_PARAVIEW "Take VTK from an installed ParaView" ON)
option(PALPATE_BUILD_PLUGIN "Build ParaView's plugin; its VTK alone needs far fewer packages" ON)
include(PalpatePythonTargets)

set(palpate_packages "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake") # the folder on Debian
set(palpate_vtk_found OFF)
set(palpate_vtk_of_paraview)
if(PALPATE_USE_PARAVIEW)
  file(GLOB palpate_vtk_of_paraview "${palpate_packages}/paraview-*/vtk")
  file(GLOB palpate_python_targets "${palpate_packages}/paraview-*/vtk/VTKPython-targets.cmake")
  if(NOT palpate_python_targets) # since version 6, Debian's ParaView uses plain VTK
    file(GLOB palpate_python_targets "${palpate_packages}/vtk-*/VTKPython-targets.cmake")
  endif()
  file(GLOB palpate_paraview_targets "${palpate_packages}/paraview-*/ParaViewPython*-targets.cmake")
  palpate_read_python_targets(${palpate_python_targets} ${palpate_paraview_targets})
endif()
if(PALPATE_USE_PARAVIEW AND PALPATE_BUILD_PLUGIN)
  find_package(ParaView 5.11 QUIET)
  if(ParaView_FOUND)
    set(palpate_vtk_found ON)
    message(STATUS "VTK ${VTK_VERSION} of ParaView ${ParaView_VERSION}")
  else()
    message(STATUS "ParaView not found: no plugin (${ParaView_NOT_FOUND_MESSAGE})")
  endif()
endif()
if(NOT palpate_vtk_found)
  find_package(VTK 9.1 REQUIRED HINTS ${palpate_vtk_of_paraview}
    COMPONENTS
      ChartsCore CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem
      CommonTransforms FiltersCore FiltersExtraction FiltersGeneral FiltersGeometry FiltersModeling FiltersPoints
      FiltersSources IOImage IOLegacy IOPLY IOXML IOXMLParser ImagingCore ImagingGeneral InteractionStyle
      RenderingAnnotation RenderingContext2D RenderingContextOpenGL2 RenderingCore RenderingFreeType
      RenderingOpenGL2 ViewsContext2D
    OPTIONAL_COMPONENTS
      Python PythonInterpreter TestingCore TestingRendering WrappingPythonCore)
  message(STATUS "VTK ${VTK_VERSION} in ${VTK_DIR}")
endif()
find_package(CLI11 REQUIRED)

vtk_module_find_modules(palpate_module_files
  "${CMAKE_CURRENT_SOURCE_DIR}/Filters" "${CMAKE_CURRENT_SOURCE_DIR}/Interactors")
set(palpate_left_out)
if(NOT PALPATE_WITH_SOLIDS)
  list(APPEND palpate_left_out Palpate::SolidResponse)
endif()
if(NOT PALPATE_WITH_IDENTIFICATION)
  list(APPEND palpate_left_out Palpate::MeasuredResponse)
endif()
if(NOT PALPATE_WITH_COMPARISON)
  list(APPEND palpate_left_out Palpate::Comparison)
endif()
vtk_module_scan(
  MODULE_FILES ${palpate_module_files}
  REJECT_MODULES ${palpate_left_out}
  PROVIDES_MODULES palpate_modules
  WANT_BY_DEFAULT ON
  ENABLE_TESTS OFF)
vtk_module_build(
  MODULES ${palpate_modules}
  TEST_DIRECTORY_NAME NONE
  PACKAGE Palpate
  INSTALL_EXPORT Palpate
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/palpate"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/palpate"
  LIBRARY_NAME_SUFFIX "")
foreach(palpate_module IN LISTS palpate_modules)
  _vtk_module_real_target(palpate_target ${palpate_module})
  palpate_warnings(${palpate_target})
  palpate_group_sources(${palpate_target})
  palpate_version_library(${palpate_target})
  set_target_properties(${palpate_target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if(PALPATE_DIRECT_CALLS)
    target_link_options(${palpate_target} PRIVATE -Wl,-z,defs) # a module uses only exported symbols of the libraries
  endif()
endforeach()

add_custom_target(palpatePython) # the Python package, as far as this VTK permits
foreach(target IN ITEMS palpateMesher palpateStrain palpateTransports)
  if(TARGET ${target})
    add_dependencies(palpatePython ${target})
  endif()
endforeach()
set(PALPATE_WITH_PYTHON OFF)
if(TARGET VTK::WrappingPythonCore AND TARGET Python3::Module)
  set(PALPATE_WITH_PYTHON ON)
endif()
if(PALPATE_WITH_PYTHON)
  block() # installed modules in palpate/ find the libraries
  file(RELATIVE_PATH palpate_python_to_lib "/${PALPATE_INSTALL_PYTHONDIR}/palpate" "/${CMAKE_INSTALL_LIBDIR}")
  list(APPEND CMAKE_INSTALL_RPATH "$ORIGIN/${palpate_python_to_lib}")
  vtk_module_wrap_python(
    MODULES ${palpate_modules}
    TARGET Palpate::Python
    PYTHON_PACKAGE "palpate"
    MODULE_DESTINATION "${PALPATE_INSTALL_PYTHONDIR}"
    CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/palpate"
    BUILD_STATIC OFF
    INSTALL_HEADERS OFF)
  endblock()
  foreach(palpate_module IN LISTS palpate_modules)
    string(REPLACE "::" "" palpate_target "${palpate_module}Python")
    string(REGEX REPLACE "^P" "p" palpate_target "${palpate_target}")
    add_dependencies(palpatePython ${palpate_target})
    set_target_properties(${palpate_target} PROPERTIES UNITY_BUILD ${PALPATE_GROUP_SOURCES} UNITY_BUILD_BATCH_SIZE 8)
    target_compile_options(${palpate_target} PRIVATE -O1) # the code only passes arguments
  endforeach()
else()
  message(STATUS "No Python wrapping in this VTK, or no headers of Python: the package 'palpate' is not built")
endif()
