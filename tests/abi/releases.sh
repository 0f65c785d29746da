#!/usr/bin/env bash
# tests/abi/releases.sh [line COMMIT|once] — a release stays what it was. For each version that tests/abi/releases.txt lists:
#
# 1. Its section of CHANGELOG.md is the released one, its frozen header too, and its commit holds both.
# 2. The version of this tree is another one.
#
# The first section of CHANGELOG.md is this tree's. Every other section is of a listed release. A tree that is neither in
# development nor listed is the one that its release is made of.
# line: prints the line of the release that COMMIT made. once: tries no mistakes in copies.
set -euo pipefail
cd "$(dirname "$0")/../.."
list=tests/abi/releases.txt header=plugin_api/include/dragmesh/dragmesh.h
failed=0 count=0
complain() {
    echo "releases: $*" >&2
    failed=1
}
digest() { sha256sum | cut -d' ' -f1; }
headings() { sed -n 's/^## \([^ ]*\) .*/\1/p'; } # the versions that a CHANGELOG on the standard input has sections of
numbers_of() { grep '^#define DM_VERSION_' || true; }
# section_digest VERSION — of its section in a CHANGELOG on the standard input, empty lines at the end left out.
section_digest() {
    local section
    section=$(awk -v heading="## $1 (" '/^## / { on = index($0, heading) == 1 } on')
    digest <<< "$section"
}
# line COMMIT
line() {
    local version
    version=$(git show "$1:CHANGELOG.md" | headings | head -n 1)
    echo "$version $(git rev-parse "$1")" \
        "$(git show "$1:CHANGELOG.md" | section_digest "$version") $(git show "$1:$header" | digest)"
}

mode=${1:-}
if [ "$mode" = line ]; then
    line "$2"
    exit
fi

version=$(scripts/version) numbers=$(scripts/version numbers)
while read -r old commit of_section of_header; do
    count=$((count + 1))
    [ "$old" != "$numbers" ] || complain "the header has version $old again, which has been released"
    [ "$(section_digest "$old" < CHANGELOG.md)" = "$of_section" ] ||
        complain "the section of $old in CHANGELOG.md is not the released one"
    [ "$(digest < "tests/abi/frozen/$old/include/dragmesh/dragmesh.h")" = "$of_header" ] ||
        complain "the frozen header of $old is not the released one"
    git cat-file -e "$commit" 2> /dev/null || continue # an archive or a shallow clone
    [ "$(line "$commit")" = "$old $commit $of_section $of_header" ] || complain "$commit did not release this $old"
done < <(grep -v '^#' $list)

state='in development'
[ "$version" != "$numbers" ] || state='[0-9]{4}-[0-9]{2}-[0-9]{2}'
grep -m 1 '^## ' CHANGELOG.md | grep -qxE "## ${numbers//./\\.} \($state\)" ||
    complain "CHANGELOG.md does not begin with \"## $numbers ($state)\""
for old in $(headings < CHANGELOG.md | tail -n +2); do
    grep -q "^$old " $list || complain "CHANGELOG.md has a section of $old, which $list does not list"
done
# A commit makes a release by changing the header; the next one lists it.
if [ "$version" = "$numbers" ] && cmp -s <(numbers_of < $header) <(git show "HEAD:$header" 2> /dev/null | numbers_of) &&
    [ "$(git log -1 --format=%H -G'^#define DM_VERSION_' -- $header)" != "$(git rev-parse HEAD)" ]; then
    complain "$version was released by an earlier commit, which $list does not list"
fi
[ $failed = 0 ] && [ "$mode" != once ] || exit $failed

# Mistakes, each in a copy, are noticed.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
noticed=0
copied=(CHANGELOG.md $header $list scripts/version tests/abi/releases.sh tests/abi/frozen/*/include/dragmesh/dragmesh.h)
# passes_with FILE SED_EXPRESSION
passes_with() {
    rm -rf "$work/tree" && mkdir "$work/tree"
    cp --parents "${copied[@]}" "$work/tree"
    sed -i "$2" "$work/tree/$1"
    "$work/tree/tests/abi/releases.sh" once > /dev/null 2>&1
}
# notice WHAT FILE SED_EXPRESSION
notice() {
    ! passes_with "$2" "$3" || complain "\"$1\" was not noticed"
    ! cmp -s "$2" "$work/tree/$2" || complain "\"$1\" changes nothing"
    noticed=$((noticed + 1))
}
passes_with CHANGELOG.md '' || complain "an unchanged copy fails"
latest=$(tail -n 1 $list | cut -d' ' -f1)
IFS=. read -r major minor patch <<< "$latest"
notice "an edited section of a release" CHANGELOG.md "/^## $latest /,\$ s/ the / a /"
notice "a section of a release less" CHANGELOG.md "/^## $latest /,\$ d"
notice "an edited header of a release" "tests/abi/frozen/$latest/include/dragmesh/dragmesh.h" 's/NULL/0/'
notice "the version of a release" $header \
    "s/^\(#define DM_VERSION_MAJOR\) .*/\1 $major/; s/^\(#define DM_VERSION_MINOR\) .*/\1 $minor/; s/^\(#define DM_VERSION_PATCH\) .*/\1 $patch/"
notice "a release that is not listed" $list "/^$latest /d"
[ $failed != 0 ] || echo "releases: $count are as they were, this is $version, $noticed mistakes noticed"
exit $failed
