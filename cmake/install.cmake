# What `cmake --install` installs. Each part can be installed separately with --component: `command`; `approx`, headers
# and the CMake package; `fit`, which goes on top of approx; `study`, on top of both.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(shadefit_headers ${CMAKE_INSTALL_INCLUDEDIR}/shadefit)
set(shadefit_package ${CMAKE_INSTALL_LIBDIR}/cmake/shadefit)

# One export set per component, so a consumer of approx does not need the dependencies of fit.
function(shadefit_install_library name)
  set_target_properties(shadefit_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(shadefit_${name} INTERFACE $<INSTALL_INTERFACE:${shadefit_headers}>)
  install(TARGETS shadefit_${name} EXPORT shadefit-${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name})
  install(EXPORT shadefit-${name} NAMESPACE shadefit:: DESTINATION ${shadefit_package} COMPONENT ${name})
endfunction()

# All headers of a component's folder but those that match ARGN.
function(shadefit_install_headers name)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${name} DESTINATION ${shadefit_headers} COMPONENT ${name} FILES_MATCHING
    PATTERN "*.hpp" ${ARGN})
endfunction()

shadefit_install_library(approx)
shadefit_install_headers(approx)
# Before 1.0 a minor version may change what a header offers.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/shadefitConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/shadefitConfig.cmake ${PROJECT_BINARY_DIR}/shadefitConfigVersion.cmake
  DESTINATION ${shadefit_package} COMPONENT approx)

if(TARGET shadefit_fit)
  # The folders of the proofs belong to other libraries, and so do these headers.
  set(shadefit_elsewhere better bounds claims input ledger proof rounding format.hpp read_families.hpp read_study_file.hpp toml_reader.hpp gpu_model.hpp rounded_interval.hpp)
  list(TRANSFORM shadefit_elsewhere REPLACE "(.+)" "PATTERN;\\1;EXCLUDE")
  shadefit_install_library(fit)
  shadefit_install_headers(fit ${shadefit_elsewhere})
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/FindCeresHeaders.cmake DESTINATION ${shadefit_package} COMPONENT fit)
endif()
if(TARGET shadefit_study)
  # Its interface, and what that includes.
  shadefit_install_library(study)
  foreach(header IN ITEMS reports/studies/prepare.hpp reports/code/shader_code.hpp fit/proof/constants.hpp)
    cmake_path(GET header PARENT_PATH folder)
    install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${shadefit_headers}/${folder} COMPONENT study)
  endforeach()
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/FindMpfi.cmake DESTINATION ${shadefit_package} COMPONENT study)
endif()
if(TARGET shadefit)
  install(TARGETS shadefit RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT command)
  # The command looks for them beside itself, in ../share.
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/studies DESTINATION ${CMAKE_INSTALL_DATADIR}/shadefit COMPONENT command
    FILES_MATCHING PATTERN "*.toml" PATTERN "*.csv")
  # Debian's zsh looks in a folder of its own.
  set(shadefit_zsh site-functions)
  if(SHADEFIT_PORTABLE)
    set(shadefit_zsh vendor-completions)
  endif()
  # The command writes its own manual page and completions, each time it is linked.
  foreach(page IN ITEMS man=${CMAKE_INSTALL_MANDIR}/man1/shadefit.1 bash=${CMAKE_INSTALL_DATADIR}/bash-completion/completions/shadefit
      zsh=${CMAKE_INSTALL_DATADIR}/zsh/${shadefit_zsh}/_shadefit)
    string(REGEX MATCH "^([a-z]+)=(.*)/([^/]+)$" page "${page}")
    set(made ${PROJECT_BINARY_DIR}/completion/${CMAKE_MATCH_1}/${CMAKE_MATCH_3})
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/completion/${CMAKE_MATCH_1})
    add_custom_command(TARGET shadefit POST_BUILD COMMAND shadefit --completion ${CMAKE_MATCH_1} > ${made} BYPRODUCTS ${made})
    install(FILES ${made} DESTINATION ${CMAKE_MATCH_2} COMPONENT command)
  endforeach()
endif()
