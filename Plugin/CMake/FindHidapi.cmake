# SPDX-License-Identifier: BSD-3-Clause
# Finds hidapi. On Linux it is the variant for hidraw, which several processes may open at the same time.
find_path(HIDAPI_INCLUDE_DIR NAMES hidapi.h PATH_SUFFIXES hidapi)
find_library(HIDAPI_LIBRARY NAMES hidapi-hidraw hidapi)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Hidapi REQUIRED_VARS HIDAPI_LIBRARY HIDAPI_INCLUDE_DIR)
mark_as_advanced(HIDAPI_INCLUDE_DIR HIDAPI_LIBRARY)
