#!/usr/bin/env bash
# tests/docs.sh — checks the documentation: no line is longer than 120 characters outside tables and fenced code,
# every relative link names a file or folder that exists, so does every path in code style outside docs/research, and
# code that names its file (```c FILE, ```cpp FILE …) stands in it, line by line.
set -euo pipefail
cd "$(dirname "$0")/.."
files=$(find docs -name '*.md'; find samples bindings -name README.md; ls README.md CHANGELOG.md CONTRIBUTING.md sdk/models/README.md \
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

# Capitals stand for a name that the reader fills in; training/runs is made by training.
gone=$(grep -noE '`(sdk|plugin_api|training|tests|scripts|docs|samples|bindings)/[a-z0-9_./-]+`' $files | tr -d '`' |
    while IFS=: read -r file line path; do
        case $file:$path in docs/research/* | *:training/runs*) continue ;; esac
        [ -e "$path" ] || echo "$file:$line: $path does not exist"
    done)

# Blanks aside: code is set shorter on a page than in its file.
invented=$(awk '/^```(c|cpp|csharp|rust|python|lua|js) / { source = $2; next } /^```/ { source = "" } source && NF { print FILENAME "\t" source "\t" $0 }' $files |
    while IFS=$'\t' read -r page source line; do
        grep -qxF -- "$(sed 's/[[:blank:]]//g' <<< "$line")" <(sed 's/[[:blank:]]//g' "$source") ||
            echo "$page: not in $source: $line"
    done)

[ -z "$long$broken$gone$invented" ] && exit 0
printf '%s\n' "$long" "$broken" "$gone" "$invented" | grep . >&2
exit 1
