#!/usr/bin/env bash
# tests/cross/run.sh windows|linux-arm64|linux-arm32 — builds for another machine and runs there (under wine or qemu) the
# unit tests, the samples, the tool's tests, and what must come out as here: prepared objects and drags to the bit or, where
# a kernel adds in another order, within TOLERANCE. Needs build/release.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=$1 root=$PWD built=$PWD/build/$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

complain() {
    echo "$target: $*" >&2
    failed=1
}

case $target in
windows)
    # A prefix of our own, without the parts of wine that a program without windows never asks for.
    export WINEPREFIX=$built/wine WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml,winemenubuilder.exe=" WINEPATH=$built
    runner=wine suffix=.exe
    ;;
linux-arm64) runner="qemu-aarch64 -L /usr/aarch64-linux-gnu" suffix= ;;
linux-arm32) runner="qemu-arm -L /usr/arm-linux-gnueabihf" suffix= ;;
*)
    echo "tests/cross/run.sh: no machine '$target'" >&2
    exit 2
    ;;
esac

mapfile -t tests < <(grep -v '^#' "tests/cross/$target.txt")
scripts/build "$target" dragmesh dragmesh_gltf dragmesh_cli "${tests[@]}" $(cd samples && ls -d 0[1-57]_* | sed 's/^.._/sample_/')
[ "$target" != windows ] || wineboot --init > /dev/null 2>&1

run_test() { # NAME
    echo "== $target $1"
    $runner "$built/tests/$1$suffix" > "$work/$1.log" 2>&1 || touch "$work/$1.failed"
    tail -n 3 "$work/$1.log"
}
export -f run_test
export runner built work target suffix
printf '%s\0' "${tests[@]}" | xargs -0 -P "$(nproc)" -I{} bash -c 'run_test {}'
for name in "${tests[@]}"; do
    [ ! -e "$work/$name.failed" ] || { complain "$name fails"; grep -a 'ERROR\|LINE\|FAILED' "$work/$name.log" >&2 || cat "$work/$name.log" >&2; }
done
exit $failed
