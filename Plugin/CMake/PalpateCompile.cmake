# SPDX-License-Identifier: BSD-3-Clause
# The settings for all targets: language, output folders, warnings and sanitizers.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Folders below the prefix, which are also used below the build folder. On Debian they are those of Debian's packages
# for any prefix, so that an installation by hand is equal to the packages of ./run package. CMAKE_INSTALL_LIBDIR takes
# precedence.
if(EXISTS "/etc/debian_version" AND CMAKE_LIBRARY_ARCHITECTURE AND CMAKE_INSTALL_LIBDIR STREQUAL "lib")
  set(CMAKE_INSTALL_LIBDIR "lib/${CMAKE_LIBRARY_ARCHITECTURE}")
  set(PALPATE_INSTALL_PYTHONDIR "lib/python3/dist-packages")
else()
  set(PALPATE_INSTALL_PYTHONDIR "${CMAKE_INSTALL_LIBDIR}/python")
endif()
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
file(RELATIVE_PATH palpate_bin_to_lib "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/${palpate_bin_to_lib}")

# The same formula must give the same bits in every kernel. Therefore fused multiply-add is off.
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>)

if(PALPATE_SANITIZE)
  add_compile_options(-fsanitize=${PALPATE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${PALPATE_SANITIZE})
  add_compile_options(-fno-sanitize=object-size,null) # the address sanitizer reports both; saves a fifth of the time
endif()
# Lets libFuzzer observe which branches of a target are taken.
function(palpate_trace_branches target)
  target_compile_options(${target} PRIVATE $<$<BOOL:${PALPATE_BUILD_FUZZERS}>:-fsanitize=fuzzer-no-link>)
endfunction()

# Calls inside a kernel library are direct, not through the table in which another library could replace a function. A
# servo tick makes about a dozen such calls. The exported functions do not change. Not used with sanitizers, which
# replace functions.
set(PALPATE_DIRECT_CALLS "")
if(NOT PALPATE_SANITIZE AND NOT PALPATE_BUILD_FUZZERS)
  include(CheckCXXCompilerFlag)
  include(CheckLinkerFlag)
  check_cxx_compiler_flag(-fno-semantic-interposition PALPATE_HAS_NO_INTERPOSITION)
  check_linker_flag(CXX -Wl,-Bsymbolic-functions PALPATE_HAS_SYMBOLIC_FUNCTIONS)
  if(PALPATE_HAS_NO_INTERPOSITION AND PALPATE_HAS_SYMBOLIC_FUNCTIONS)
    set(PALPATE_DIRECT_CALLS -fno-semantic-interposition)
  endif()
endif()

# Must be called for every target with Palpate's own code, and not for generated wrapper code.
function(palpate_warnings target)
  set(gnu $<CXX_COMPILER_ID:GNU>)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-qual
    -Wformat=2 $<${gnu}:-Wdouble-promotion> $<${gnu}:-Wduplicated-cond> $<${gnu}:-Wlogical-op>
    -Wimplicit-fallthrough
    $<$<BOOL:${PALPATE_WERROR}>:-Werror>)
endfunction()

# Compiles up to twelve sources of a folder as one, because most of the time is spent on headers that all of them
# include. Therefore local names must differ between the files of a folder. Generated sources are not grouped.
option(PALPATE_GROUP_SOURCES "Compile sources in groups; off, a change compiles one file" ON)
function(palpate_group_sources target)
  if(NOT PALPATE_GROUP_SOURCES)
    return()
  endif()
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${folder}")
    cmake_path(IS_PREFIX folder "${source}" is_own)
    if(is_own AND source MATCHES "\\.cxx$")
      cmake_path(RELATIVE_PATH source BASE_DIRECTORY "${folder}" OUTPUT_VARIABLE part)
      cmake_path(GET part PARENT_PATH part)
      math(EXPR count_${part} "0${count_${part}} + 1")
      math(EXPR number "(${count_${part}} - 1) / 12")
      set_source_files_properties("${source}" TARGET_DIRECTORY ${target}
        PROPERTIES UNITY_GROUP "${part}${number}")
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # g++ assumes that a class of one of the files is declared in a header.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# The soname of a library contains the part of the version that changes when programs must be rebuilt: the first two
# numbers before version 1.0, and the first number after that.
set(PALPATE_SOVERSION ${PROJECT_VERSION_MAJOR})
if(PROJECT_VERSION_MAJOR EQUAL 0)
  string(APPEND PALPATE_SOVERSION ".${PROJECT_VERSION_MINOR}")
endif()
function(palpate_version_library target)
  set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PALPATE_SOVERSION})
endfunction()

# The folders of the rooms. A header is included by its room and its folder in the room.
set(PALPATE_ROOMS "${PROJECT_SOURCE_DIR}/Filters;${PROJECT_SOURCE_DIR}/Interactors")

# Installs the headers of a room under the path by which they are included: include/palpate/ROOM/FOLDER/NAME.h.
function(palpate_install_headers room)
  foreach(header IN LISTS ARGN)
    get_filename_component(folder "${room}/${header}" DIRECTORY)
    install(FILES ${header} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/palpate/${folder}" COMPONENT development)
  endforeach()
endfunction()

function(palpate_install_former_headers room)
  while(ARGN)
    list(POP_FRONT ARGN former header)
    cmake_path(SET former NORMALIZE "${room}/${former}")
    set(file "${CMAKE_CURRENT_BINARY_DIR}/Former/${former}")
    file(CONFIGURE OUTPUT "${file}"
      CONTENT "// SPDX-License-Identifier: BSD-3-Clause\n#include \"@room@/@header@\"\n" @ONLY)
    get_filename_component(folder "${former}" DIRECTORY)
    install(FILES "${file}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/palpate/${folder}" COMPONENT development)
  endwhile()
endfunction()

# Adds a kernel library, which uses plain C++ and Eigen but not VTK. The sources are NAME.h and NAME.cxx for each of
# CLASSES and PRIVATE_CLASSES, and the files in SOURCES, HEADERS and PRIVATE_HEADERS. A header is included and installed
# by its room and folder, as in "Contact/PackedMesh.h". Only symbols marked by PALPATE_EXPORT in installed headers are
# exported. Private headers are not installed. Tests of private classes link palpate${name}Inside, an archive of the
# same objects.
# FUZZED: a fuzzer tests the library.
# READS_BYTES: the library reads bytes as numbers, so that a sanitizer checks their alignment. In other libraries Eigen
# checks the alignment, because the sanitizer would need another fifth of the time.
# LOADED: the core loads the library by loadModule ("Mechanics/Files/ModuleFile.h") if the program does not link it. The
# library is always shared, and the macro PALPATE_VERSION contains its version.
# FORMER: pairs of a former header and the header that now has its content. Earlier programs still include the former
# header.
# FORMER_FOLDERS: pairs of a former folder of headers and their present folder. Both are relative to the room.
function(palpate_add_kernel name)
  cmake_parse_arguments(arg "FUZZED;READS_BYTES;LOADED" "" "CLASSES;PRIVATE_CLASSES;SOURCES;HEADERS;PRIVATE_HEADERS;FORMER;FORMER_FOLDERS;LINK" ${ARGN})
  set(headers ${arg_HEADERS})
  set(private_headers ${arg_PRIVATE_HEADERS})
  set(sources ${arg_SOURCES})
  foreach(class IN LISTS arg_CLASSES)
    list(APPEND headers ${class}.h)
    list(APPEND sources ${class}.cxx)
  endforeach()
  foreach(class IN LISTS arg_PRIVATE_CLASSES)
    list(APPEND private_headers ${class}.h)
    list(APPEND sources ${class}.cxx)
  endforeach()
  set(folders "") # earlier programs include an installed header by its name alone
  foreach(header IN LISTS headers)
    get_filename_component(folder "${name}/${header}" DIRECTORY)
    list(APPEND folders "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/palpate/${folder}>")
  endforeach()
  list(REMOVE_DUPLICATES folders)
  set(type)
  if(arg_LOADED)
    set(type SHARED)
  endif()
  add_library(palpate${name} ${type} ${sources} ${headers} ${private_headers})
  if(arg_LOADED)
    target_compile_definitions(palpate${name} PRIVATE PALPATE_VERSION="${PROJECT_VERSION}")
  endif()
  add_library(Palpate::${name} ALIAS palpate${name})
  target_include_directories(palpate${name} PUBLIC
    "$<BUILD_INTERFACE:${PALPATE_ROOMS}>"
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/palpate>
    ${folders})
  target_link_libraries(palpate${name} PUBLIC Eigen3::Eigen ${arg_LINK})
  target_compile_features(palpate${name} PUBLIC cxx_std_17)
  set_target_properties(palpate${name} PROPERTIES EXPORT_NAME ${name} WINDOWS_EXPORT_ALL_SYMBOLS ON
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  palpate_warnings(palpate${name})
  palpate_group_sources(palpate${name})
  # g++ 14 gives false warnings about null pointers.
  set(falsely $<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,14>>)
  target_compile_options(palpate${name} PRIVATE
    -Wpedantic $<$<NOT:${falsely}>:-Wnull-dereference> # VTK's headers violate both
    -fno-math-errno # makes a square root one instruction
    ${PALPATE_DIRECT_CALLS})
  if(arg_FUZZED)
    palpate_trace_branches(palpate${name})
  endif()
  if(PALPATE_SANITIZE STREQUAL "thread") # builds only libraries that the tests link
    set_target_properties(palpate${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
  if(PALPATE_SANITIZE AND NOT arg_READS_BYTES)
    target_compile_options(palpate${name} PRIVATE -fno-sanitize=alignment)
  endif()
  if(PALPATE_DIRECT_CALLS)
    target_link_options(palpate${name} PRIVATE -Wl,-Bsymbolic-functions -Wl,-z,defs) # defs: no undefined symbols
  endif()
  palpate_version_library(palpate${name})
  install(TARGETS palpate${name} EXPORT PalpateKernels
    RUNTIME COMPONENT runtime
    LIBRARY COMPONENT runtime NAMELINK_COMPONENT development
    ARCHIVE COMPONENT development)
  palpate_install_headers(${name} ${headers})
  while(arg_FORMER_FOLDERS)
    list(POP_FRONT arg_FORMER_FOLDERS former_folder own_folder)
    foreach(header IN LISTS headers)
      get_filename_component(folder "./${header}" DIRECTORY)
      get_filename_component(header_name "${header}" NAME)
      if(folder STREQUAL "." AND own_folder STREQUAL "." OR folder STREQUAL "./${own_folder}")
        list(APPEND arg_FORMER "${former_folder}/${header_name}" "${header}")
      endif()
    endforeach()
  endwhile()
  palpate_install_former_headers(${name} ${arg_FORMER})

  list(TRANSFORM arg_LINK REPLACE "^Palpate::(.+)$" "palpate\\1Inside" OUTPUT_VARIABLE link)
  add_library(palpate${name}Inside STATIC EXCLUDE_FROM_ALL $<TARGET_OBJECTS:palpate${name}>)
  set_target_properties(palpate${name}Inside PROPERTIES LINKER_LANGUAGE CXX)
  target_include_directories(palpate${name}Inside INTERFACE $<TARGET_PROPERTY:palpate${name},INTERFACE_INCLUDE_DIRECTORIES>)
  target_compile_features(palpate${name}Inside INTERFACE cxx_std_17)
  target_link_libraries(palpate${name}Inside INTERFACE Eigen3::Eigen ${link})
endfunction()
