# SPDX-License-Identifier: BSD-3-Clause
# Since Debian 13, paraview-dev names Python modules that do not exist, such as vtkCommonCore.so. The file is called
# vtkCommonCore.cpython-313-x86_64-linux-gnu.so. CMake then fails in find_package().

# palpate_read_python_targets(FILE ...): if an import file (…Python-targets.cmake) names files that do not exist, includes
# a corrected copy in the build folder, which names the existing files and does not check them. Must be called before
# find_package(), because a later import file does not change targets that are already defined.
function(palpate_read_python_targets)
  foreach(file IN LISTS ARGN)
    _palpate_read_python_targets("${file}")
  endforeach()
endfunction()

function(_palpate_read_python_targets file)
  get_filename_component(folder "${file}" DIRECTORY)
  get_filename_component(name "${file}" NAME_WE)
  file(GLOB parts "${folder}/${name}-*.cmake") # one part per build type contains the paths of the modules
  get_filename_component(root "${folder}" REALPATH)
  while(NOT root MATCHES "/lib[^/]*$" AND NOT root STREQUAL "/")
    get_filename_component(root "${root}" DIRECTORY)
  endwhile()
  get_filename_component(root "${root}" DIRECTORY) # the prefix of the import file
  set(copy "${CMAKE_BINARY_DIR}/python-targets")
  set(faulty FALSE)
  foreach(part IN LISTS parts)
    file(READ "${part}" text)
    string(REGEX MATCHALL "IMPORTED_LOCATION[A-Z_]* \"[^\"]*\"" locations "${text}")
    foreach(location IN LISTS locations)
      string(REGEX REPLACE ".*\"(.*)\"" "\\1" module "${location}")
      string(REPLACE "\${_IMPORT_PREFIX}" "${root}" path "${module}")
      if(NOT EXISTS "${path}")
        set(faulty TRUE)
        string(REGEX REPLACE "\\.so$" ".cpython-*.so" pattern "${path}")
        file(GLOB found "${pattern}")
        if(found)
          list(GET found 0 path)
        endif()
        string(REPLACE "\"${module}\"" "\"${path}\"" text "${text}")
      endif()
    endforeach()
    get_filename_component(part "${part}" NAME)
    string(REGEX REPLACE "list\\(APPEND _cmake_import_check_[^)]*\\)\n" "" text "${text}")
    file(WRITE "${copy}/${part}" "${text}")
  endforeach()
  if(faulty)
    message(STATUS "${file} names Python modules that are not there; mended in ${copy}")
    file(READ "${file}" text)
    string(REPLACE "PREFIX \"\${CMAKE_CURRENT_LIST_FILE}\"" "PREFIX \"${file}\"" text "${text}")
    file(WRITE "${copy}/${name}.cmake" "${text}")
    include("${copy}/${name}.cmake")
  endif()
endfunction()
