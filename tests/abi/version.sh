#!/usr/bin/env bash
# tests/abi/version.sh [write] — every package, and every page that names one, has the version of the public header; write: gives
# it to them. The header is the one place where a version is set.
set -euo pipefail
cd "$(dirname "$0")/../.."
version=$(scripts/version) numbers=$(scripts/version numbers) python=$(scripts/version python)
IFS=. read -r major minor patch <<< "$numbers"
any='[0-9]+\.[0-9]+\.[0-9]+(-dev|\.dev0)?'
mode=${1:-check} failed=0 places=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# at FILE SED_SCRIPT [may] — the file is as the script writes it; without "may", the script finds a version there.
at() {
    sed -E "$2" "$1" > "$work/file"
    places=$((places + 1))
    [ "${3:-must}" = may ] || grep -q "$numbers\|$major, $minor, $patch" "$work/file" ||
        { echo "version: $1 names no version any more" >&2; failed=1; }
    cmp -s "$1" "$work/file" && return
    if [ "$mode" = write ]; then
        cat "$work/file" > "$1"
    else
        echo "version: $1 has another version than the header's, $version; \"tests/abi/version.sh write\" mends it:" >&2
        diff "$1" "$work/file" >&2 || true
        failed=1
    fi
}

at packaging/vcpkg/dragmesh/vcpkg.json "s/(\"version-semver\": \")$any/\1$version/"
at bindings/csharp/DragMesh/DragMesh.csproj "s/(<Version>)$any/\1$version/"
at bindings/godot/addons/dragmesh/plugin.cfg "s/^(version=\")$any/\1$version/"
at bindings/js/package.json "s/(\"version\": \")$any/\1$version/"
at bindings/unity/package.json "s/(\"version\": \")$any/\1$version/"
at bindings/unreal/DragMesh/DragMesh.uplugin "s/(\"VersionName\": \")$any/\1$version/"
at bindings/python/pyproject.toml "s/^(version = \")$any/\1$python/"
at bindings/python/dragmesh/__init__.py "s/^(__version__ = \")$any/\1$python/"
at bindings/python/blender/dragmesh_openable/__init__.py "s/(\"version\": \()[0-9]+, [0-9]+, [0-9]+/\1$major, $minor, $patch/"
at bindings/rust/Cargo.lock "s/^(version = \")$any/\1$version/" # both packages are ours
at bindings/rust/dragmesh-sys/Cargo.toml "s/^(version = \")$any/\1$version/"
at bindings/rust/dragmesh/Cargo.toml "s/^((dragmesh-sys = \{ )?version = \")$any/\1$version/"
for page in README.md docs/*.md docs/engines/*.md bindings/*/README.md bindings/*/*/README.md samples/*/CMakeLists.txt; do
    at "$page" "s/(dragmesh(\.unity)?-)$any/\1$version/g; s/(dragmesh-)$any-py3/\1$python-py3/g; s/(find_package\(dragmesh )[0-9]+\.[0-9]+/\1$major.$minor/" may
done
[ "$(grep -c '^name = ' bindings/rust/Cargo.lock)" = 2 ] || { echo "version: bindings/rust/Cargo.lock has packages of others" >&2; failed=1; }
# An odd number is a version in development (DM_VERSION).
[ $((patch % 2)) = 0 ] || { echo "version: the patch number of $numbers is odd" >&2; failed=1; }
[ $failed != 0 ] || echo "version: $version in $places files"
exit $failed
