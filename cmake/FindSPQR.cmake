# Of SuiteSparse 5, as CHOLMOD. Defines SPQR::SPQR.
find_path(SPQR_INCLUDE_DIR SuiteSparseQR_C.h PATH_SUFFIXES suitesparse)
find_library(SPQR_LIBRARY spqr)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SPQR REQUIRED_VARS SPQR_LIBRARY SPQR_INCLUDE_DIR)
if(SPQR_FOUND AND NOT TARGET SPQR::SPQR)
  add_library(SPQR::SPQR INTERFACE IMPORTED)
  target_include_directories(SPQR::SPQR SYSTEM INTERFACE ${SPQR_INCLUDE_DIR})
  target_link_libraries(SPQR::SPQR INTERFACE ${SPQR_LIBRARY})
endif()
mark_as_advanced(SPQR_INCLUDE_DIR SPQR_LIBRARY)
