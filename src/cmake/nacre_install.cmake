# Install and export: the program, the core with its headers, and what find_package(nacre) needs.
#
# The adapters stay private: they are linked into the program, and their headers are not a promise to anybody.
set(nacre_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/nacre")

install(TARGETS nacre EXPORT nacre
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/nacre" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
    FILES_MATCHING PATTERN "*.h")
install(EXPORT nacre NAMESPACE nacre:: FILE nacreTargets.cmake DESTINATION "${nacre_package_dir}")

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/nacreConfig.cmake.in"
    "${PROJECT_BINARY_DIR}/nacreConfig.cmake" INSTALL_DESTINATION "${nacre_package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/nacreConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/nacreConfig.cmake" "${PROJECT_BINARY_DIR}/nacreConfigVersion.cmake"
    DESTINATION "${nacre_package_dir}")

if(TARGET nacre_cli)
    install(TARGETS nacre_cli RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
    if(BUILD_SHARED_LIBS)
        install(TARGETS nacre_io nacre_pipeline LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
        set_target_properties(nacre_cli nacre_pipeline nacre_io nacre PROPERTIES
            INSTALL_RPATH "$ORIGIN;$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
    endif()
endif()

install(FILES "${PROJECT_SOURCE_DIR}/luts/nacre.glsl" "${PROJECT_SOURCE_DIR}/luts/nacre.hlsl"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/nacre" OPTIONAL)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# Sources and licences of the tables that are compiled in.
install(FILES "${PROJECT_SOURCE_DIR}/src/nacre/colour/README.md" DESTINATION "${CMAKE_INSTALL_DOCDIR}" RENAME cie_tables.md)
