# SPDX-License-Identifier: BSD-3-Clause
# Installs the CMake package. find_package(Palpate) finds the VTK modules, and
# find_package(Palpate COMPONENTS Contact Haptics) finds only kernels, without VTK.
include(CMakePackageConfigHelpers)

set(palpate_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/palpate")
install(EXPORT PalpateKernels
  NAMESPACE Palpate::
  FILE PalpateKernels-targets.cmake
  DESTINATION "${palpate_cmake_dir}"
  COMPONENT development)
export(EXPORT PalpateKernels
  NAMESPACE Palpate::
  FILE "${CMAKE_BINARY_DIR}/${palpate_cmake_dir}/PalpateKernels-targets.cmake")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/PalpateConfig.cmake.in" "${CMAKE_BINARY_DIR}/PalpateConfig.cmake"
  INSTALL_DESTINATION "${palpate_cmake_dir}")
write_basic_package_version_file("${CMAKE_BINARY_DIR}/PalpateConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_BINARY_DIR}/PalpateConfig.cmake" "${CMAKE_BINARY_DIR}/PalpateConfigVersion.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/FindCHOLMOD.cmake" "${CMAKE_CURRENT_LIST_DIR}/PalpatePythonTargets.cmake"
  DESTINATION "${palpate_cmake_dir}"
  COMPONENT development)
if(PALPATE_WITH_VTK AND PROJECT_IS_TOP_LEVEL)
  include(PalpatePackage)
endif()
