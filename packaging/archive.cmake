# The CMakeLists.txt of a release archive: add_subdirectory and FetchContent give the same targets as find_package.
cmake_minimum_required(VERSION 3.16)
project(dragmesh LANGUAGES NONE)
include(${CMAKE_CURRENT_SOURCE_DIR}/lib/cmake/dragmesh/dragmeshConfig.cmake)
