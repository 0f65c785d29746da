#!/usr/bin/env bash
# tests/python/wheel.sh BUILD_FOLDER — the wheel is built, installed with Debian's numpy, and does there what C does.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$(realpath "${1:-build/release}") root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset PYTHONPATH DRAGMESH_LIBRARY_PATH
/usr/bin/python3 -m venv --system-site-packages "$work/venv"
PYTHON=$work/venv/bin/python3 bindings/python/wheel "$work" "$build"
"$work/venv/bin/pip" install -q --no-index --no-deps "$work"/dragmesh-*-py3-none-linux_*.whl
gcc -std=c17 -Iplugin_api/include -Isamples/common bindings/scenario/scenario.c -o "$work/c" "-L$build" -ldragmesh "-Wl,-rpath,$build"
"$work/c" > "$work/c.txt"
cd / # nothing of the repository is found from here
"$work/venv/bin/python3" -c "import dragmesh, os, sys; sys.exit(not dragmesh.__file__.startswith('$work/') or
    not os.path.exists(os.path.join(os.path.dirname(dragmesh.__file__), 'py.typed')))"
"$work/venv/bin/python3" "$root/bindings/python/tests/scenario.py" > "$work/python.txt"
cmp "$work/c.txt" "$work/python.txt"
"$work/venv/bin/python3" "$root/bindings/python/examples/open_drawer.py" "$root/tests/replay/drawer/object.glb" "$work/open.glb"
mkdir "$work/assets" && cp "$root/tests/replay/chest_lid/object.glb" "$work/assets/"
"$work/venv/bin/python3" -m dragmesh.batch "$work/assets" -j 1
echo "wheel: $(basename "$work"/*.whl), the same $(wc -l < "$work/c.txt") lines as C"
