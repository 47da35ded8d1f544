# The flags that every target shares, and the functions that declare libraries and tests.

include(GNUInstallDirs)

add_library(rfm_flags INTERFACE)
target_compile_features(rfm_flags INTERFACE cxx_std_20)
target_include_directories(
  rfm_flags INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/rfm>)
# One -march for all targets: translation units that share inline SIMD code must agree on it.
if(RFM_NATIVE)
  target_compile_options(rfm_flags INTERFACE -march=native)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(rfm_flags INTERFACE -march=x86-64-v3)
endif()
target_compile_options(rfm_flags INTERFACE -fno-math-errno -fno-trapping-math)

add_library(rfm_warnings INTERFACE)
target_compile_options(rfm_warnings INTERFACE -Wall -Wextra -Wpedantic -Wno-psabi)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 sees overlapping copies in std::string's own code (its bug 105651), uninitialized members
  # in moved std::optional and shared_ptr (its bug 105562), and uninitialized registers in its own
  # AVX-512 headers (its bug 105593), which only builds for such a processor meet.
  target_compile_options(rfm_warnings INTERFACE -Wno-restrict -Wno-maybe-uninitialized)
  if(RFM_NATIVE)
    target_compile_options(rfm_warnings INTERFACE -Wno-uninitialized)
  endif()
endif()
if(RFM_WARNINGS_AS_ERRORS)
  target_compile_options(rfm_warnings INTERFACE -Werror)
endif()
if(RFM_SANITIZE)
  target_compile_options(rfm_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer)
  target_link_options(rfm_flags INTERFACE -fsanitize=address,undefined)
endif()

# rfm_library(<folder> SOURCES ... LINKS ... [PRIVATE_LINKS ...]): the static library rfm_<folder>.
function(rfm_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(rfm_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(
    rfm_${name}
    PUBLIC rfm_flags ${ARG_LINKS}
    PRIVATE $<BUILD_INTERFACE:rfm_warnings> ${ARG_PRIVATE_LINKS})
endfunction()

# rfm_unit_tests(<folder> SOURCES ... LINKS ...): one test program per folder of sources. Suites whose
# name begins with Long repeat others with full counts; they are labelled `long`, which scripts/test
# leaves out.
function(rfm_unit_tests name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(rfm_${name}_tests ${ARG_SOURCES})
  target_link_libraries(rfm_${name}_tests PRIVATE ${ARG_LINKS} rfm_warnings GTest::gmock_main)
  gtest_discover_tests(rfm_${name}_tests TEST_PREFIX "${name}/" DISCOVERY_TIMEOUT 60
                       TEST_FILTER "-Long*" PROPERTIES LABELS unit)
  gtest_discover_tests(rfm_${name}_tests TEST_PREFIX "${name}/" DISCOVERY_TIMEOUT 60
                       TEST_FILTER "Long*" TEST_LIST rfm_${name}_long_tests PROPERTIES LABELS long)
endfunction()
