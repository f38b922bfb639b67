# SPDX-License-Identifier: BSD-3-Clause
# What CPack is about to pack, as Debian has it: below /usr the loader finds the libraries by itself, so the run
# paths that make an installation movable go. Only the plugin looks beside itself, for its own library.
file(GLOB archives "${CPACK_TEMPORARY_DIRECTORY}/palpate-dev/usr/lib*/*/libpalpate*CS.a") # ParaView's, of no use
if(archives)
  file(REMOVE ${archives})
endif()
file(GLOB_RECURSE files LIST_DIRECTORIES false "${CPACK_TEMPORARY_DIRECTORY}/*/usr/*")
foreach(file IN LISTS files)
  if(NOT IS_SYMLINK "${file}")
    file(READ "${file}" magic LIMIT 4 HEX)
    if(magic STREQUAL "7f454c46")
      if(file MATCHES "/plugins/.*/Palpate\\.so$")
        file(RPATH_SET FILE "${file}" NEW_RPATH "$ORIGIN")
      else()
        file(RPATH_REMOVE FILE "${file}")
      endif()
    endif()
  endif()
endforeach()
