#!/usr/bin/env bash
# tests/fuzz/corpus.sh unpack [TARGET…]     unpacks the inputs of these targets, or of all, into build/fuzz/corpus/TARGET
# tests/fuzz/corpus.sh add TARGET FILE…     adds these files to the target's archive, each under its own name
# tests/fuzz/corpus.sh pack TARGET FOLDER   makes the target's archive anew from the files of FOLDER
#
# tests/fuzz/corpus/TARGET.tar.gz holds the inputs of a fuzz target. The same files give the same archive, whoever packs
# them and when: entries are sorted and carry no owner, time or mode of their own.
set -euo pipefail
here=$(dirname "$(realpath "$0")")
unpacked=$(realpath -m "$here/../../build/fuzz/corpus")

# A run beside this one sees the folder whole: the inputs are unpacked beside it and moved there.
unpack() { # TARGET
    local work
    mkdir -p "$unpacked"
    work=$(mktemp -d "$unpacked/.XXXXXX")
    tar -xzf "$here/corpus/$1.tar.gz" -C "$work"
    rm -rf "${unpacked:?}/$1"
    mv -T "$work" "$unpacked/$1"
}

pack() { # TARGET FOLDER
    local archive=$here/corpus/$1.tar.gz
    (cd "$2" && find . -type f -printf '%P\0') | LC_ALL=C sort -z |
        tar -C "$2" --format=ustar --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=644 --no-recursion --null -T - -cf - |
        gzip -9n > "$archive.new"
    mv "$archive.new" "$archive"
}

command=${1:-}
shift || true
case $command in
unpack)
    [ $# -gt 0 ] || set -- $(basename -s .tar.gz "$here"/corpus/*.tar.gz)
    for target; do unpack "$target"; done ;;
add)
    target=$1; shift
    unpack "$target"
    cp -- "$@" "$unpacked/$target/"
    pack "$target" "$unpacked/$target" ;;
pack) pack "$1" "$2" ;;
*) sed -n '2,4s/^# //p' "$0" >&2; exit 2 ;;
esac
