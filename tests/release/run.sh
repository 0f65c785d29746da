#!/usr/bin/env bash
# tests/release/run.sh — makes the release of this machine, of the source and of each language, twice, with the same bytes; builds hosts with
# it (hosts.sh), and the library from the unpacked source by CMakeLists.txt: the same answers, the same exports.
set -euo pipefail
cd "$(dirname "$0")/../.."
if ! grep -q '^VERSION_ID="12"' /etc/os-release; then
    echo "release: not tried, archives are made on Debian 12: later systems make libraries that need their own glibc"
    exit
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
dist=$PWD/build/dist
case $(uname -m) in aarch64) platform=linux-arm64 ;; *) platform=linux-x64 ;; esac
rm -rf "$dist"
scripts/release $platform source rust unity unreal love wheel blender > "$work/release.log"
cp "$dist/SHA256SUMS" "$work/first"
scripts/release $platform source rust unity unreal love wheel > "$work/release.log"
cmp "$dist/SHA256SUMS" "$work/first"
(cd "$dist" && sha256sum --quiet -c SHA256SUMS)
binaries=$(echo "$dist"/dragmesh-*-$platform.tar.gz) source=$(echo "$dist"/dragmesh-*-source.tar.gz)
tests/release/hosts.sh "$binaries" "$work/binaries"

# The sample that needs packages besides, in the archive as its page says; tinygltf once as a library, once as a header.
unpacked=$work/binaries/$(basename "$binaries" .tar.gz)
for without in '' TinyGLTF; do
    cmake -Wno-dev -S "$unpacked/samples/13_whole_host" -B "$work/whole$without" ${without:+-DCMAKE_DISABLE_FIND_PACKAGE_$without=ON} > "$work/whole.log"
    cmake --build "$work/whole$without" >> "$work/whole.log" || { cat "$work/whole.log" >&2; exit 1; }
    (cd "$unpacked" && "$work/whole$without/whole_host") | cmp - <(build/release/samples/sample_whole_host)
done

# An engine that fetches the source; installed, it is found like a release.
mkdir "$work/engine"
cat > "$work/engine/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.16)
project(engine LANGUAGES C)
include(FetchContent)
set(DRAGMESH_GLTF ON)
FetchContent_Declare(dragmesh URL file://$source)
FetchContent_MakeAvailable(dragmesh)
add_executable(engine \${dragmesh_SOURCE_DIR}/samples/01_hello_drag/main.c)
target_link_libraries(engine PRIVATE dragmesh::dragmesh dragmesh::gltf)
END
{
    cmake -Wno-dev -S "$work/engine" -B "$work/engine/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER=clang
    cmake --build "$work/engine/build" -j"${JOBS:-$(nproc)}"
    cmake --install "$work/engine/build" --prefix "$work/prefix"
} > "$work/engine.log" 2>&1 || { cat "$work/engine.log" >&2; exit 1; }
"$work/engine/build/engine" sdk/models | cmp - "$work/binaries/pkg_config.txt"
gcc -std=c17 -O1 -Iplugin_api/include -Isamples/common tests/abi/caller.c -o "$work/caller" -L"$work/prefix/lib" -ldragmesh -lpthread \
    "-Wl,-rpath,$work/prefix/lib"
tests/e2e/determinism.sh against "clang, by CMake" 0 "$work/caller"
for library in libdragmesh libdragmesh_gltf; do
    diff <(nm -D --defined-only build/release/$library.so | cut -d' ' -f3 | sort) \
        <(nm -D --defined-only "$work/prefix/lib/$library.so" | cut -d' ' -f3 | sort)
done
cmake -S samples/01_hello_drag -B "$work/found" -DCMAKE_PREFIX_PATH="$work/prefix" > "$work/found.log"
cmake --build "$work/found" >> "$work/found.log"
"$work/found/hello_drag" sdk/models | cmp - "$work/binaries/pkg_config.txt"
echo "release: $(basename "$binaries") and $(basename "$source") serve every host, byte by byte the same when made again"
