# What is installed: the program, its cases, its documents. The program finds the cases beside
# itself, at ../share/pmr/cases, so that a prefix may be moved as a whole.
include(GNUInstallDirs)
install(TARGETS pmr RUNTIME DESTINATION bin)
install(DIRECTORY cases DESTINATION share/pmr)
install(DIRECTORY docs DESTINATION share/doc/pmr)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION share/doc/pmr)
install(FILES LICENSE DESTINATION share/doc/pmr RENAME copyright)

# A Debian package: cpack -G DEB --config BUILD/CPackConfig.cmake, or make deb.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the PMR authors <pmr@localhost>" CACHE STRING
    "Who answers for the package, as Debian's Maintainer field wants it")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "slurm-client, paraview")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulator of a reactor of mixed hot granular beds")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Particle Mix Reactor computes, particle by particle, how hot inert beads and
granules of a redox oxide fall, mix, exchange heat and release oxygen:
discrete-element mechanics, conduction, rarefied gas, traced radiation, and
equilibrium and kinetics of the oxide in one implicit system.
.
It needs a processor with AVX2 and FMA.")
include(CPack)
