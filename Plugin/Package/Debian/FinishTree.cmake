# SPDX-License-Identifier: BSD-3-Clause
# Adapts the files that CPack packs to Debian. Below /usr the loader finds the libraries without run paths; therefore
# the run paths, which make an installation relocatable, are removed. Only the plugin keeps one, for the library in its
# own folder.
file(GLOB archives "${CPACK_TEMPORARY_DIRECTORY}/palpate-dev/usr/lib*/*/libpalpate*CS.a") # made by ParaView and not needed
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
