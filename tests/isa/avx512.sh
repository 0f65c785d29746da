#!/usr/bin/env bash
# tests/isa/avx512.sh — runs the AVX-512 kernels on a machine with AVX2 alone: their intrinsics emulated by SIMDe,
# everything else as it is, tested against the scalar kernels and PyTorch's answers; the fixed scene has the same bits by
# AVX2 and AVX-512, and nearly by scalar kernels. Says nothing of speed. Needs build/release.
set -euo pipefail
cd "$(dirname "$0")/../.."
grep -qw avx2 /proc/cpuinfo || { echo "no AVX2 here: skipped"; exit 0; }
out=build/avx512 cc=gcc
mkdir -p "$out/obj"
command -v ccache > /dev/null && cc="ccache gcc"
flags="-std=gnu17 -O2 -ffp-contract=off -D_GNU_SOURCE -w -DDM_BUILDING -Iplugin_api/include -Isdk -Itests/include -Isamples/common -Itraining/generator -Ithird_party"
compile() { # SOURCE
    local emulate=
    case $1 in */gemm_avx512.c|*/apply_points.c) emulate="-mavx2 -mfma -include tests/isa/emulate_avx512.h" ;; esac
    $cc $flags $emulate -DDM_TEST_ROOM="\"avx512\"" -c "$1" -o "$out/obj/$(basename "$1" .c).o"
}
export -f compile
export cc flags out
rm -f "$out"/obj/*.o "$out/libcore.a"
{ find sdk plugin_api/src build/embed -name '*.c' | sort; echo third_party/cjson/cJSON.c; } | xargs -P "$(nproc)" -I{} bash -c 'compile {}'
ar rcs "$out/libcore.a" "$out"/obj/*.o
for source in tests/isa/cpu_*.c tests/abi/caller.c; do compile "$source"; done
for test in test_gemm test_layers test_dual_quat test_golden_kpp test_golden_vae; do
    compile tests/*/"$test".c
    $cc "$out/obj/$test.o" "$out/obj/cpu_avx512.o" "$out/libcore.a" -Wl,--wrap=dmi_cpu_best_isa -lcmocka -lm \
        -o "$out/$test"
    echo "== avx512 $test"
    CMOCKA_MESSAGE_OUTPUT=stdout "$out/$test"
done
apart=1e-3 # relative: sums in another order; measured: 3e-4
for isa in avx512 scalar; do
    $cc "$out/obj/caller.o" "$out/obj/cpu_$isa.o" "$out/libcore.a" -Wl,--wrap=dmi_cpu_best_isa -ldl -lm -lpthread -o "$out/caller_$isa"
done
$cc "$out/obj/caller.o" "$out/libcore.a" -ldl -lm -lpthread -o "$out/caller_avx2"
for isa in avx512 avx2; do tests/e2e/determinism.sh against "$isa" 0 "$out/caller_$isa"; done
tests/e2e/determinism.sh against scalar $apart "$out/caller_scalar"
