#!/usr/bin/env bash
# tests/docs.sh — checks the documentation: no line is longer than 120 characters outside tables and fenced code. Every relative
# link names a file or folder that exists and a heading that it has, and every path in code style outside docs/research exists.
# Code that names its file (```c FILE, ```cpp FILE …) stands in it as one piece, and code of docs/engines names a file that a
# test runs. The tables of the scoreboard are those that scripts/scoreboard writes. tests/prose.sh, which this runs too, reads the
# comments.
set -euo pipefail
cd "$(dirname "$0")/.."
files=$(find docs -name '*.md'; find samples bindings -name README.md; ls README.md CHANGELOG.md CONTRIBUTING.md sdk/models/README.md \
    tests/replay/README.md training/README.md packaging/archive.md)

# Every byte that does not continue a UTF-8 character counts as one character.
long=$(LC_ALL=C awk 'FNR == 1 { code = 0 }
    /^ *```/ { code = !code }
    { gsub(/[\200-\277]/, "") }
    !code && !/^\|/ && length() > 120 { print FILENAME ":" FNR ": " length() " characters, at most 120" }' $files)

# The anchors of a page: headings in small letters without punctuation, blanks as hyphens; a heading that comes again has -1.
anchors() { # PAGE
    awk '/^ *```/ { code = !code }
        !code && /^#+ / { sub(/^#+ /, ""); gsub(/\]\([^)]*\)/, ""); s = tolower($0)
            gsub(/[^a-z0-9_ \200-\377-]/, "", s); gsub(/ /, "-", s); print s (n[s]++ ? "-" n[s] - 1 : "") }' "$1"
}

broken=$(awk 'FNR == 1 { code = 0 }
    /^ *```/ { code = !code }
    !code { while (match($0, /\]\([^) ]+\)/)) {
        print FILENAME, FNR, substr($0, RSTART + 2, RLENGTH - 3); $0 = substr($0, RSTART + RLENGTH) } }' $files |
    while read -r file line link; do
        case $link in *://* | mailto:*) continue ;; \#*) path=$file ;;
        *) path=$(realpath -m --relative-to=. "$(dirname "$file")/${link%%#*}") ;; esac
        if [ ! -e "$path" ]; then
            echo "$file:$line: link to $link, which does not exist"
        elif [[ $link == *.md#* || $link == \#* ]] && ! anchors "$path" | grep -qxF -- "${link#*#}"; then
            echo "$file:$line: link to $link, a heading that $path has not"
        fi
    done)

# Capitals stand for a name that the reader fills in; training/runs is made by training.
gone=$(grep -noE '`(sdk|plugin_api|training|tests|scripts|docs|samples|bindings)/[a-z0-9_./-]+`' $files | tr -d '`' |
    while IFS=: read -r file line path; do
        case $file:$path in docs/research/* | *:training/runs*) continue ;; esac
        [ -e "$path" ] || echo "$file:$line: $path does not exist"
    done)

# What stands in a file as it stands on a page, but for blanks, which pages set shorter.
bare() { sed 's/[[:blank:]]//g' | grep . || true; }
language='c|cpp|csharp|rust|python|lua|js|html|cmake|gdscript'
# check_block PAGE LINE LANGUAGE SOURCE CODE — code that names its file is text of it without a gap; that of docs/engines names
# one, and a test runs that file, which it names with or without its ending.
check_block() {
    local page=$1 line=$2 source=$4 code name
    if [ -z "$source" ]; then
        [[ $page != docs/engines/* ]] || echo "$page:$line: $3 that names no file"
        return
    fi
    [ -e "$source" ] || { echo "$page:$line: $source does not exist"; return; }
    code=$'\n'$(bare <<< "$5")$'\n'
    [[ $'\n'$(bare < "$source")$'\n' == *"$code"* ]] || echo "$page:$line: not in $source as it stands there: ${5%%$'\n'*} …"
    name=$(basename "$source")
    [[ $page != docs/engines/* ]] || grep -rqwE "${name//./\\.}|${name%.*}" tests || echo "$page:$line: no test runs $source"
}
blocks() { # PAGE
    local line kind source code number=0 start=0
    while IFS= read -r line || [ -n "$line" ]; do
        number=$((number + 1))
        if [[ $start = 0 && $line =~ ^\`\`\`($language)(\ ([^ ]+))?$ ]]; then
            start=$number kind=${BASH_REMATCH[1]} source=${BASH_REMATCH[3]} code=
        elif [[ $start != 0 && $line = '```' ]]; then
            check_block "$1" $start "$kind" "$source" "$code"
            start=0
        elif [ $start != 0 ]; then
            code+=$line$'\n'
        fi
    done < "$1"
}
invented=$(for page in $files; do blocks "$page"; done)

fragments=$(tests/prose.sh 2>&1 || true; scripts/scoreboard --check 2>&1 || true)

[ -z "$long$broken$gone$invented$fragments" ] && exit 0
printf '%s\n' "$long" "$broken" "$gone" "$invented" "$fragments" | grep . >&2
exit 1
