#!/usr/bin/env bash
# tests/mutations.sh — makes one mistake at a time in a copy of the tree and says which quick test notices it. Each row:
# what is wrong; the file; a sed expression that makes it wrong; the test programs that are run. A mistake that no test
# notices fails the check, and so does an expression that changes nothing. Needs a built release configuration.
set -euo pipefail
cd "$(dirname "$0")/.."
features=sdk/kinematics/features analysis=sdk/kinematics/analysis
mutations=(
    "the sweep's collision test inverted|$features/sweep_features.c|s/= meets\[i\]/= !meets[i]/|test_golden_features"
    "the limit sweep's collision test inverted|sdk/kinematics/limits/sweep.c|s/hits += meets\[i\]/hits += !meets[i]/|test_limits"
    "relative features against the wrong type|$features/candidate_features.c|s/best\[!type\]/best[type]/|test_golden_features"
    "the protrusion never found|$analysis/protrusions.c|s/\(define MIN_PROTRUSION_POINTS\) 8 /\1 9999/|test_golden_features"
    "the network-free share .2 -> .9|sdk/kinematics/ranking/ranker.c|s/\(define NETWORK_FREE_SHARE\) 0.2f/\1 0.9f/|test_ranker test_golden_features"
    "the drag's cone .8 -> .95|sdk/kinematics/candidates/candidates.c|s/\(define NEAR_DRAG_COSINE\) 0.8f/\1 0.95f/|test_candidates"
    "the widest gaps' share 32 -> 4|$analysis/protrusions.c|s/\(define WIDEST_SHARE\) 32/\1 4/|test_golden_features"
    "the usual opening a third of a turn|sdk/kinematics/limits/limits.c|s/\(define USUAL_OPENING\) DMI_HALF_PI_F/\1 2.0943951f/|test_limits"
    "a sign in a feature|$features/cheap_features.c|s/\(SECTION_THIN_OFFSET\] = clamp(\)away/\1-away/|test_golden_features"
    "two columns of the table swapped|$features/feature_table.def|s/FEATURE(HAS_DRAG, DRAG/FEATURE(SWAPPED, DRAG/; s/FEATURE(HAS_NETWORK, NETWORK/FEATURE(HAS_DRAG, NETWORK/; s/FEATURE(SWAPPED/FEATURE(HAS_NETWORK/|test_feature_table test_golden_features"
)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
{ git ls-files && git ls-files --others --exclude-standard; } | tar -cf - -T - 2> /dev/null | tar -xf - -C "$work"
cp -a --parents build/obj build/release/lib build/release/tests build/*.flags build/*.sources "$work" 2> /dev/null || true
cd "$work"

# Builds and runs the tests; prints the name of the first that fails. One that does not compile counts as noticed.
noticed_by() {
    # shellcheck disable=SC2086
    if ! scripts/build release $1 > build.log 2>&1; then echo "the compiler"; return; fi
    for test in $1; do
        CMOCKA_MESSAGE_OUTPUT=stdout "build/release/tests/$test" > test.log 2>&1 || { echo "$test"; return; }
    done
}

survived=0
all=$(printf '%s\n' "${mutations[@]}" | cut -d'|' -f4 | tr ' ' '\n' | sort -u | tr '\n' ' ')
by=$(noticed_by "$all")
[ -z "$by" ] || { echo "without any mistake $by fails" >&2; cat ./*.log >&2; exit 1; }
for row in "${mutations[@]}"; do
    IFS='|' read -r what file expression tests <<< "$row"
    cp "$file" original
    sed -i "$expression" "$file"
    if cmp -s "$file" original; then by="changes nothing"; else by=$(noticed_by "$tests"); fi
    case $by in
        "" | "the compiler" | "changes nothing") survived=$((survived + 1)); verdict="NOT NOTICED ${by:+($by)}" ;;
        *) verdict="noticed by $by" ;;
    esac
    printf '%-45s %s\n' "$what" "$verdict"
    cp original "$file"
    touch "$file"
done
exit $((survived > 0))
