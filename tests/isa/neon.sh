#!/usr/bin/env bash
# tests/isa/neon.sh — builds the networks and the mathematics for 64-bit Arm and runs their tests under qemu: the
# NEON kernels against the scalar ones and against PyTorch's answers. For correctness alone; qemu says nothing of speed.
# Needs build/embed, which scripts/build makes.
set -euo pipefail
cd "$(dirname "$0")/../.."
out=build/neon cc="aarch64-linux-gnu-gcc"
tests="test_gemm test_layers test_weights test_dual_quat test_joint test_motion test_golden_kpp test_golden_vae"
mkdir -p "$out/obj" "$out/debs" "$out/include" "$out/apt/partial"
command -v ccache > /dev/null && cc="ccache $cc"

# The library that tests link, of Arm's Debian: unpacked beside the system, which stays as it is.
if [ ! -d "$out/root" ]; then
    apt="-qq -oAPT::Architecture=arm64 -oAPT::Architectures=arm64 -oDir::State::Lists=$PWD/$out/apt -oDir::Cache::pkgcache= -oDir::Cache::srcpkgcache="
    apt-get $apt -oAPT::Sandbox::User=root update
    (cd "$out/debs" && apt-get $apt -oAPT::Sandbox::User=root download libcmocka0)
    for deb in "$out"/debs/*.deb; do dpkg -x "$deb" "$out/root.new"; done
    mv "$out/root.new" "$out/root"
fi
ln -sfn /usr/include/cmocka.h "$out/include/cmocka.h"

flags="-std=c17 -O2 -ffp-contract=off -D_GNU_SOURCE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Werror"
flags="$flags -Iplugin_api/include -Isdk -Itests/include -Itraining/generator -Ithird_party -isystem $out/include"
compile() { # SOURCE
    $cc $flags -DDM_TEST_ROOM="\"neon\"" -c "$1" -o "$out/obj/$(basename "$1" .c).o"
}
export -f compile
export cc flags out
rm -f "$out"/obj/*.o "$out/libcore.a"
printf '%s\n' sdk/{base,math,mesh,nn,segmentation,kinematics/*,motion}/*.c third_party/cjson/cJSON.c build/embed/*.c | xargs -P "$(nproc)" -I{} bash -c 'compile {}'
ar=aarch64-linux-gnu-ar
$ar rcs "$out/libcore.a" "$out"/obj/*.o

libraries="$out/root/usr/lib/aarch64-linux-gnu"
for test in $tests; do
    compile tests/*/"$test".c
    $cc "$out/obj/$test.o" "$out/libcore.a" "$libraries"/libcmocka.so.0 -lm -o "$out/$test"
    echo "== neon $test"
    CMOCKA_MESSAGE_OUTPUT=stdout qemu-aarch64 -L /usr/aarch64-linux-gnu -E LD_LIBRARY_PATH="$libraries" "$out/$test"
done
