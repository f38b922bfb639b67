# SPDX-License-Identifier: BSD-3-Clause
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
run("${CMAKE_COMMAND}" --install "${PALPATE_BUILD}" --prefix "${WORK}/first")
file(RENAME "${WORK}/first" "${WORK}/moved")
set(prefix "${WORK}/moved")

# A body for the programs without VTK, by the installed viewer.
run("${prefix}/bin/palpate" --scene cylinder --tool sphere:6.35 --no-curvature --output "${WORK}/session"
  --export "${WORK}/cylinder.palpate")

foreach(consumer IN ITEMS vtk loop laws c)
  run("${CMAKE_COMMAND}" -G Ninja -S "${CONSUMERS}/${consumer}" -B "${WORK}/${consumer}"
    "-DCMAKE_PREFIX_PATH=${prefix};${PREFIX_PATH}" -DCMAKE_BUILD_TYPE=Release)
  run("${CMAKE_COMMAND}" --build "${WORK}/${consumer}")
  run("${WORK}/${consumer}/consumer" "${WORK}/cylinder.palpate")
endforeach()

# What needs no VTK must not bring it in.
foreach(consumer IN ITEMS loop laws)
  execute_process(COMMAND ldd "${WORK}/${consumer}/consumer" OUTPUT_VARIABLE libraries
    COMMAND_ERROR_IS_FATAL ANY)
  if(libraries MATCHES "vtk")
    message(FATAL_ERROR "The program ${consumer}, without VTK, is linked with it:\n${libraries}")
  endif()
endforeach()

# The installed Python package, from its new place.
run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${prefix}/${PYTHON_SUBDIRECTORY}:$ENV{PYTHONPATH}"
  /usr/bin/python3 -c
  "import palpate; t = palpate.vtkContactTool(); t.SetSpecification('flat:2'); assert t.GetForce(1, 1) == 4")
