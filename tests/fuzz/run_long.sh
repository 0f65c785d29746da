#!/usr/bin/env bash
# tests/fuzz/run_long.sh WORK [ROUNDS [SECONDS [target…]]] — fuzzes every target in turn, for SECONDS each (default 300), ROUNDS
# times (default 0: until it is killed). Run it again with the same WORK to go on: the inputs found so far stay there.
#
# Takes the programs of `scripts/build fuzz`, and begins with the inputs of tests/fuzz/corpus. Leaves in WORK:
#   corpus/TARGET      inputs that reached something new; tests/fuzz/corpus.sh adds those that are worth keeping
#   findings/TARGET-*  inputs that crashed, hung or took too much memory; each fails again by `build/fuzz/fuzz/TARGET FILE`
#   logs/TARGET        what libFuzzer said last
# Appends a line a slice to tests/fuzz/hours.tsv (tests/fuzz/hours.sh sums them): date, commit, target, CPU seconds, inputs,
# edges covered, findings.
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$1 rounds=${2:-0} seconds=${3:-300}
shift; shift $(($# < 2 ? $# : 2))
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=($(basename -s .c tests/fuzz/fuzz_*.c))
log=tests/fuzz/hours.tsv
# Bounds of one input: s under sanitizers on a busy machine, where a second without them is the aim; MB.
time_limit=10 memory_limit=1024
export ASAN_OPTIONS=allocator_may_return_null=1:detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1
mkdir -p "$work/findings" "$work/logs"

# A process that was stopped for a while seems to hang: only what fails once more is a finding.
count_findings() {
    local target=$1 mark=$2 found=0 file
    while IFS= read -r file; do
        if timeout 60 "build/fuzz/fuzz/$target" -timeout=$time_limit -rss_limit_mb=$memory_limit "$file" > /dev/null 2>&1; then
            rm "$file"
        else
            found=$((found + 1))
        fi
    done < <(find "$work/findings" -name "$target-*" -newer "$mark")
    echo $found
}

fuzz() {
    local target=$1 corpus=$work/corpus/$1 output=$work/logs/$1 mark=$work/mark options=() times
    mkdir -p "$corpus"
    touch "$mark"
    [ ! -e "tests/fuzz/$target.dict" ] || options+=("-dict=tests/fuzz/$target.dict")
    TIMEFORMAT='%U %S'
    times=$( { time "build/fuzz/fuzz/$target" -max_total_time="$seconds" -timeout=$time_limit -rss_limit_mb=$memory_limit \
        -print_final_stats=1 -reload=0 -artifact_prefix="$work/findings/$target-" "${options[@]}" "$corpus" \
        "build/fuzz/corpus/$target" > "$output" 2>&1 || true; } 2>&1 )
    printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$(date -u +%FT%TZ)" "$(git rev-parse --short HEAD)" "$target" \
        "$(awk '{ print int($1 + $2) }' <<< "$times")" "$(awk '/^stat::number_of_executed_units/ { n = $2 } END { print n + 0 }' "$output")" \
        "$(grep -o 'cov: [0-9]*' "$output" | awk '{ n = $2 } END { print n + 0 }')" "$(count_findings "$target" "$mark")" >> "$log"
}

[ -x "build/fuzz/fuzz/${targets[0]}" ] || { echo "$0: scripts/build fuzz first" >&2; exit 1; }
tests/fuzz/corpus.sh unpack "${targets[@]}"
before=$(find "$work/findings" -type f | wc -l)
for ((round = 1; rounds == 0 || round <= rounds; round++)); do
    for target in "${targets[@]}"; do fuzz "$target"; done
done
after=$(find "$work/findings" -type f | wc -l)
[ "$after" = "$before" ] || { echo "$((after - before)) findings in $work/findings" >&2; exit 1; }
