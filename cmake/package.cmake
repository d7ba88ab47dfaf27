# The release archive and the Debian package, from the same files: .ci/package calls CPack, docs/packaging.md says what is inside.
#
# GMP, MPFR and MPFI are under the LGPL: as shared objects beside the command, a user can exchange them.
set_target_properties(shadefit PROPERTIES INSTALL_RPATH $ORIGIN/../lib/shadefit)
install(TARGETS shadefit RUNTIME_DEPENDENCIES PRE_INCLUDE_REGEXES "lib(gmp|mpfr|mpfi)\\." PRE_EXCLUDE_REGEXES ".*"
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} LIBRARY DESTINATION lib/shadefit COMPONENT command)

# The licences of all that is inside, as Debian states them, and the texts that they name. SOURCES says where the sources are.
set(licences ${CMAKE_INSTALL_DATADIR}/doc/shadefit)
set(inside libboost1.74-dev libceres-dev libcli11-dev libeigen3-dev libfmt-dev libgmp10 libjpeg62-turbo libmpfi0 libmpfr6 libpng16-16
  libstdc++-12-dev libtomlplusplus-dev nlohmann-json3-dev zlib1g)
install(FILES LICENSE RENAME copyright DESTINATION ${licences} COMPONENT command)
foreach(package IN LISTS inside)
  install(FILES /usr/share/doc/${package}/copyright RENAME ${package} DESTINATION ${licences}/licences COMPONENT command)
endforeach()
foreach(text IN ITEMS Apache-2.0 GPL-2 GPL-3 LGPL-2.1 LGPL-3 MPL-2.0)
  install(FILES /usr/share/common-licenses/${text} DESTINATION ${licences}/licences COMPONENT command)
endforeach()
execute_process(COMMAND dpkg-query -W -f "https://snapshot.debian.org/package/\${source:Package}/\${source:Version}/ \${Package}\n" ${inside}
  OUTPUT_VARIABLE sources COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${PROJECT_BINARY_DIR}/SOURCES "${sources}")
install(FILES ${PROJECT_BINARY_DIR}/SOURCES DESTINATION ${licences}/licences COMPONENT command)

set(CPACK_GENERATOR TGZ DEB)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};shadefit;command;/")
set(CPACK_PACKAGE_FILE_NAME shadefit-${PROJECT_VERSION}-linux-x86_64)
set(CPACK_DEBIAN_FILE_NAME shadefit_${PROJECT_VERSION}_amd64.deb)
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The shadefit authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libc6 (>= 2.36)")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS gnuplot)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
include(CPack)
