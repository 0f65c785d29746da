# Untried: vcpkg was not at hand. An overlay port for a checkout: set DRAGMESH_SOURCE to it, or unpack the release's source.
set(SOURCE_PATH "$ENV{DRAGMESH_SOURCE}")
vcpkg_check_features(OUT_FEATURE_OPTIONS options FEATURES gltf DRAGMESH_GLTF)
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" dynamic shared)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS ${options} -DDRAGMESH_SHARED=${shared})
vcpkg_cmake_install()
vcpkg_copy_pdbs()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/third_party/cjson/upstream/LICENSE"
    "${SOURCE_PATH}/third_party/cglm/LICENSE" "${SOURCE_PATH}/third_party/meshoptimizer/LICENSE.md")
