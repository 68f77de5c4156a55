# A port for vcpkg, which make dist fills in: vcpkg install ssgi --overlay-ports=PATH/TO/dist/vcpkg
vcpkg_download_distfile(ARCHIVE URLS "@URL@/ssgi-@VERSION@.tar.gz" FILENAME "ssgi-@VERSION@.tar.gz" SHA512 @SHA512@)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}")
vcpkg_cmake_install()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug")
vcpkg_fixup_pkgconfig()
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
