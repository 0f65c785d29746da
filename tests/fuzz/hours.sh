#!/usr/bin/env bash
# tests/fuzz/hours.sh — sums tests/fuzz/hours.tsv; docs/reliability.md has its inputs and findings.
set -euo pipefail
cd "$(dirname "$0")"
echo "| target | CPU hours | inputs | edges covered | findings |"
echo "|---|---|---|---|---|"
awk -F'\t' '{ cpu[$3] += $4; inputs[$3] += $5; if ($6 > edges[$3]) edges[$3] = $6; found[$3] += $7 }
    END { for (t in cpu) printf "| `%s` | %.2f | %d | %d | %d |\n", t, cpu[t] / 3600, inputs[t], edges[t], found[t] }' hours.tsv | sort
awk -F'\t' '{ cpu += $4; inputs += $5; found += $7 }
    END { printf "| together | %.2f | %d | | %d |\n", cpu / 3600, inputs, found }' hours.tsv
