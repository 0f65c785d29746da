#!/usr/bin/env bash
# tests/release/hosts.sh ARCHIVE WORK_FOLDER — hosts that find the unpacked release in each of the ways that it offers:
# pkg-config, find_package (shared and static), add_subdirectory, FetchContent. Each builds samples/01_hello_drag, and all
# print the same. Needs a C compiler, cmake and pkg-config, nothing of this repository. For an archive of another machine,
# CC is a compiler for it and EMULATOR the command that runs its programs.
set -euo pipefail
[ $# = 2 ] || { echo "usage: tests/release/hosts.sh ARCHIVE WORK_FOLDER" >&2; exit 2; }
archive=$(realpath "$1") work=$2
mkdir -p "$work" && cd "$work"
tar -xzf "$archive"
root=$PWD/$(basename "$archive" .tar.gz)
hello=$root/samples/01_hello_drag

${EMULATOR:-} "$root/bin/dragmesh" > usage 2>&1 || grep -q infer usage
export PKG_CONFIG_PATH=$root/lib/pkgconfig
${CC:-cc} "$hello/main.c" $(pkg-config --cflags --libs dragmesh) -Wl,-rpath,"$(pkg-config --variable=libdir dragmesh)" -o pkg_config
${EMULATOR:-} ./pkg_config "$(pkg-config --variable=models dragmesh)" > pkg_config.txt
grep -q '^hinge' pkg_config.txt
# The archive's own page; its last command runs what it has built.
if [ -z "${EMULATOR:-}" ]; then
    sed -n '/^```sh$/,/^```$/p' "$root/README.md" | grep -v '^```' > page
    (cd "$root" && bash -e "$OLDPWD/page") > page.log 2>&1 || { cat page.log >&2; exit 1; }
    tail -n "$(wc -l < pkg_config.txt)" page.log | cmp - pkg_config.txt || { echo "hosts.sh: README.md answers otherwise" >&2; exit 1; }
    echo "hosts.sh: the commands of README.md build and run"
fi

# host NAME PROGRAM: builds the CMake project in the folder NAME; runs its program.
host() {
    cmake -Wno-dev -S "$1" -B "$1/build" -DCMAKE_PREFIX_PATH="$root" -DCMAKE_BUILD_TYPE=Release > "$1.log" &&
        cmake --build "$1/build" >> "$1.log" || { cat "$1.log" >&2; exit 1; }
    ${EMULATOR:-} "$1/build/$2" "$root/models" | cmp - pkg_config.txt || { echo "hosts.sh: $1 answers otherwise" >&2; exit 1; }
    echo "hosts.sh: $1 builds and runs"
}
# project NAME CMAKE_LINES TARGET: a host in the folder NAME.
project() {
    mkdir -p "$1"
    printf '%s\n' "cmake_minimum_required(VERSION 3.16)" "project(host LANGUAGES C)" "$2" \
        "add_executable(host $hello/main.c)" "target_link_libraries(host PRIVATE $3)" > "$1/CMakeLists.txt"
    host "$1" host
}
cp -R "$hello" sample
host sample hello_drag
project static "find_package(dragmesh 0.2 REQUIRED)" dragmesh::static
project subdirectory "add_subdirectory($root dragmesh)" dragmesh::dragmesh
project fetch "include(FetchContent)
FetchContent_Declare(dragmesh URL file://$archive)
FetchContent_MakeAvailable(dragmesh)" dragmesh::dragmesh
