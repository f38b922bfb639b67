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

# A file of a page of the manual: the block after "Save this as `NAME`", without its indentation.
function(save_from page name folder)
  file(READ "${MANUAL}/${page}" text)
  if(NOT text MATCHES "Save this as `${name}`[^`]*```[a-z]+\n([^`]*)```")
    message(FATAL_ERROR "${page} has no block to be saved as ${name}")
  endif()
  string(REPLACE "\n   " "\n" code "\n${CMAKE_MATCH_1}")
  file(WRITE "${folder}/${name}" "${code}")
endfunction()

# Configures and builds a folder of WORK as the pages print it.
function(build folder)
  run("${CMAKE_COMMAND}" -G Ninja -S "${folder}" -B "${folder}/build"
    "-DCMAKE_PREFIX_PATH=${prefix};${PREFIX_PATH}" -DCMAKE_BUILD_TYPE=Release)
  run("${CMAKE_COMMAND}" --build "${folder}/build")
endfunction()

# The program of a page is whole, builds as printed, and prints what the page shows.
set(press "${WORK}/press")
save_from(program.md CMakeLists.txt "${press}")
save_from(program.md main.cxx "${press}")
build("${press}")
execute_process(COMMAND "${press}/build/press" OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
# F = 2 a E* δ = 2 · 2 mm · 1 MPa · 0.5 mm. Under the facets of the ball, δ is smaller by 1e-4 of it: three decimals agree.
set(expected "deflection 0.500 mm, force 2.000 N\n")
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "The program of program.md prints\n${printed}instead of\n${expected}")
endif()
file(READ "${MANUAL}/program.md" page)
string(FIND "${page}" "${expected}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "program.md does not show the output of its program:\n${expected}")
endif()

# The page on loops prints only a part of its program, which is whole here.
save_from(loop.md CMakeLists.txt "${WORK}/loop")
file(COPY "${CONSUMERS}/loop/main.cxx" DESTINATION "${WORK}/loop")
build("${WORK}/loop")
run("${WORK}/loop/build/loop" "${WORK}/cylinder.palpate")

foreach(consumer IN ITEMS laws c)
  file(COPY "${CONSUMERS}/${consumer}" DESTINATION "${WORK}")
  build("${WORK}/${consumer}")
  run("${WORK}/${consumer}/build/${consumer}" "${WORK}/cylinder.palpate")
endforeach()

# What needs no VTK must not bring it in.
foreach(consumer IN ITEMS loop laws)
  execute_process(COMMAND ldd "${WORK}/${consumer}/build/${consumer}" OUTPUT_VARIABLE libraries
    COMMAND_ERROR_IS_FATAL ANY)
  if(libraries MATCHES "vtk")
    message(FATAL_ERROR "The program ${consumer}, without VTK, is linked with it:\n${libraries}")
  endif()
endforeach()

# The installed Python package, from its new place.
run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${prefix}/${PYTHON_SUBDIRECTORY}:$ENV{PYTHONPATH}"
  /usr/bin/python3 -c
  "import palpate; t = palpate.vtkContactTool(); t.SetSpecification('flat:2'); assert t.GetForce(1, 1) == 4")
