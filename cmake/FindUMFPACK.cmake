# Of SuiteSparse 5, as CHOLMOD. Defines UMFPACK::UMFPACK.
find_path(UMFPACK_INCLUDE_DIR umfpack.h PATH_SUFFIXES suitesparse)
find_library(UMFPACK_LIBRARY umfpack)
find_library(UMFPACK_OPENBLAS_LIBRARY openblas)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(UMFPACK REQUIRED_VARS UMFPACK_LIBRARY UMFPACK_INCLUDE_DIR
                                                        UMFPACK_OPENBLAS_LIBRARY)
if(UMFPACK_FOUND AND NOT TARGET UMFPACK::UMFPACK)
  add_library(UMFPACK::UMFPACK INTERFACE IMPORTED)
  target_include_directories(UMFPACK::UMFPACK SYSTEM INTERFACE ${UMFPACK_INCLUDE_DIR})
  target_link_libraries(UMFPACK::UMFPACK INTERFACE ${UMFPACK_LIBRARY} ${UMFPACK_OPENBLAS_LIBRARY})
endif()
mark_as_advanced(UMFPACK_INCLUDE_DIR UMFPACK_LIBRARY UMFPACK_OPENBLAS_LIBRARY)
