# `cmake --install`: the program, libtyndall.so with its headers, and what find_package(tyndall) and pkg-config read. Kernels are inside the library: no source is needed.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
install(TARGETS tyndall_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(TARGETS tyndall_library EXPORT tyndall LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/host/include/tyndall DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_BINARY_DIR}/man/tyndall.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
install(FILES ${PROJECT_BINARY_DIR}/completion/tyndall DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions OPTIONAL)
install(FILES ${PROJECT_BINARY_DIR}/completion/tyndall.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d OPTIONAL)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/host/examples DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/tyndall)
install(EXPORT tyndall NAMESPACE tyndall:: FILE tyndall-targets.cmake DESTINATION ${package_folder})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/tyndall-config.cmake.in ${PROJECT_BINARY_DIR}/tyndall-config.cmake INSTALL_DESTINATION ${package_folder})
# Before 1.0 every minor version may change the C++ interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tyndall-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/tyndall-config.cmake ${PROJECT_BINARY_DIR}/tyndall-config-version.cmake DESTINATION ${package_folder})

file(RELATIVE_PATH prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)  # so that the folder can be moved
configure_file(${CMAKE_CURRENT_LIST_DIR}/tyndall.pc.in ${PROJECT_BINARY_DIR}/tyndall.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/tyndall.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
