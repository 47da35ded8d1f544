# Headers under include/rfm with their paths, static libraries, the program, and the package
# `find_package(rfm)` with the targets rfm::core … rfm::solvers, rfm::output, rfm::problems.

include(CMakePackageConfigHelpers)

set(rfm_folders core basis quadrature solution_structures solvers problems)
set(rfm_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/rfm)

foreach(folder IN LISTS rfm_folders)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rfm FILES_MATCHING PATTERN "*.hpp"
          PATTERN "gallery" EXCLUDE PATTERN "examples" EXCLUDE)
  set_target_properties(rfm_${folder} PROPERTIES EXPORT_NAME ${folder})
endforeach()
set_target_properties(rfm_output PROPERTIES EXPORT_NAME output)
set_target_properties(rfm_flags PROPERTIES EXPORT_NAME flags)

install(TARGETS rfm_flags rfm_core rfm_basis rfm_quadrature rfm_solution_structures rfm_solvers
                rfm_output rfm_problems
        EXPORT rfmTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS rfm-solve RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT rfmTargets NAMESPACE rfm:: DESTINATION ${rfm_package_folder})

configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/rfmConfig.cmake.in ${PROJECT_BINARY_DIR}/rfmConfig.cmake
  INSTALL_DESTINATION ${rfm_package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rfmConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/rfmConfig.cmake ${PROJECT_BINARY_DIR}/rfmConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/FindCHOLMOD.cmake
              ${PROJECT_SOURCE_DIR}/cmake/FindSPQR.cmake
              ${PROJECT_SOURCE_DIR}/cmake/FindUMFPACK.cmake DESTINATION ${rfm_package_folder})
