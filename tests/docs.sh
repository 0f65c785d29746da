#!/usr/bin/env bash
# tests/docs.sh — checks the documentation: no line is longer than 120 characters outside tables and fenced code, and
# every relative link names a file or folder that exists.
set -euo pipefail
cd "$(dirname "$0")/.."
files=$(find docs -name '*.md'; find samples -name README.md; ls README.md CHANGELOG.md CONTRIBUTING.md sdk/models/README.md \
    training/README.md)

# Every byte that does not continue a UTF-8 character counts as one character.
long=$(LC_ALL=C awk 'FNR == 1 { code = 0 }
    /^ *```/ { code = !code }
    { gsub(/[\200-\277]/, "") }
    !code && !/^\|/ && length() > 120 { print FILENAME ":" FNR ": " length() " characters, at most 120" }' $files)

broken=$(awk 'FNR == 1 { code = 0 }
    /^ *```/ { code = !code }
    !code { while (match($0, /\]\([^) ]+\)/)) {
        print FILENAME, FNR, substr($0, RSTART + 2, RLENGTH - 3); $0 = substr($0, RSTART + RLENGTH) } }' $files |
    while read -r file line link; do
        case $link in *://* | mailto:* | \#*) continue ;; esac
        path=$(realpath -m --relative-to=. "$(dirname "$file")/${link%%#*}")
        [ -e "$path" ] || echo "$file:$line: link to $link, which does not exist"
    done)

[ -z "$long$broken" ] && exit 0
printf '%s\n' "$long" "$broken" | grep . >&2
exit 1
