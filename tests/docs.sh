#!/usr/bin/env bash
# tests/docs.sh — checks the documentation: no line is longer than 120 characters outside tables and fenced code, every
# relative link names a file or folder that exists, and code that names its file (```c FILE) stands in it, line by line.
set -euo pipefail
cd "$(dirname "$0")/.."
expected="docs/ARCHITECTURE.md CONTRIBUTING.md" # may be linked before they are there
files=$(find docs -name '*.md'; find samples -name README.md; ls README.md CHANGELOG.md sdk/models/README.md \
    training/README.md; if [ -e CONTRIBUTING.md ]; then echo CONTRIBUTING.md; fi)

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
        [ -e "$path" ] || [[ " $expected " == *" $path "* ]] || echo "$file:$line: link to $link, which does not exist"
    done)

# Blanks aside: code is set shorter on a page than in its file.
invented=$(awk '/^```c / { source = $2; next } /^```/ { source = "" } source && NF { print FILENAME "\t" source "\t" $0 }' $files |
    while IFS=$'\t' read -r page source line; do
        sed 's/[[:blank:]]//g' "$source" | grep -qxF -- "$(sed 's/[[:blank:]]//g' <<< "$line")" ||
            echo "$page: not in $source: $line"
    done)

[ -z "$long$broken$invented" ] && exit 0
printf '%s\n' "$long" "$broken" "$invented" | grep . >&2
exit 1
