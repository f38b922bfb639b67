# SPDX-License-Identifier: BSD-3-Clause
# Since Debian 13 paraview-dev names Python modules that are not there: vtkCommonCore.so, where the file is
# vtkCommonCore.cpython-313-x86_64-linux-gnu.so. CMake then ends in find_package().

# palpate_read_python_targets(FILE ...): where an import file (…Python-targets.cmake) names files that are not
# there, reads a copy of it in the build folder, which names those that are and asks for none. To be called
# before find_package(): a second import file leaves alone what the first has defined.
function(palpate_read_python_targets)
  foreach(file IN LISTS ARGN)
    _palpate_read_python_targets("${file}")
  endforeach()
endfunction()

function(_palpate_read_python_targets file)
  get_filename_component(folder "${file}" DIRECTORY)
  get_filename_component(name "${file}" NAME_WE)
  file(GLOB parts "${folder}/${name}-*.cmake") # a part per build type says where the modules are
  get_filename_component(root "${folder}" REALPATH)
  while(NOT root MATCHES "/lib[^/]*$" AND NOT root STREQUAL "/")
    get_filename_component(root "${root}" DIRECTORY)
  endwhile()
  get_filename_component(root "${root}" DIRECTORY) # what the import file calls its prefix
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
