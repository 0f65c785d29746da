#!/usr/bin/env bash
# tests/distribution.sh SUITE [hosts] — the release in build/dist (where scripts/release has made one) with hosts that use it,
# then scripts/demo and scripts/test quick in a bare Debian of that suite (bookworm, trixie …), as root, with debootstrap.
# Leaves the demo's picture and the log in build/distribution/SUITE; exits 0 when all passed. hosts: the release's hosts alone.
#   DM_MIRROR  where packages come from; by default the first of this machine's own apt sources that has the suite
#   DM_CHROOT  folder of the system, kept and used again as it then stands; by default a fresh one that is removed
#   JOBS       how many jobs make runs at once
set -euo pipefail
[ -z "${DM_CHROOT:-}" ] || export DM_CHROOT=$(realpath -m "$DM_CHROOT") # seen from where this was called
[ $# = 1 ] || [ "$#,${2:-}" = 2,hosts ] || { sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2; }
cd "$(dirname "$0")/.."
[ "$(id -u)" = 0 ] || { echo "tests/distribution.sh: needs root, for chroot" >&2; exit 2; }
command -v debootstrap > /dev/null || { echo "tests/distribution.sh: debootstrap is missing" >&2; exit 2; }
# In a mount namespace of its own: nothing stays mounted, however this ends.
[ -n "${DM_UNSHARED:-}" ] || DM_UNSHARED=1 exec unshare --mount --propagation private "$PWD/tests/distribution.sh" "$@"

[ $# = 1 ] || ls build/dist/dragmesh-*-linux-x64.tar.gz > /dev/null # hosts of nothing would all pass
suite=$1 out=$PWD/build/distribution/$1
work=$(mktemp -d)
root=${DM_CHROOT:-$work/root}
release_mounts() { # debootstrap leaves some
    local folder
    for folder in proc sys; do
        while mountpoint -q "$root/$folder"; do umount "$root/$folder"; done
    done
}
leave() {
    release_mounts
    rm -rf --one-file-system "$work"
}
trap leave EXIT
trap 'exit 1' INT TERM
rm -rf "$out" && mkdir -p "$out" "$root"

# Apt's own downloader asks, so that proxies and the like are minded.
find_mirror() {
    local mirror
    for mirror in $(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | sort -u); do
        /usr/lib/apt/apt-helper download-file "${mirror%/}/dists/$suite/InRelease" "$work/release" > "$work/asked" 2>&1 || continue
        echo "$mirror"
        return
    done
    echo "tests/distribution.sh: none of this machine's apt sources has $suite, set DM_MIRROR" >&2
    return 1
}
mirror=${DM_MIRROR:-$(find_mirror)}

if [ ! -e "$root/etc/debian_version" ]; then
    echo "== debootstrap $suite"
    debootstrap --variant=minbase "$suite" "$root" "$mirror" > "$out/debootstrap.log" ||
        { tail "$out/debootstrap.log" >&2; exit 1; }
fi

# This machine's way to the mirror: source, names, proxies, and whether an old snapshot's dates matter.
echo "deb $mirror $suite main" > "$root/etc/apt/sources.list"
apt-config dump | grep -E '^Acquire::(https?|Check-Valid-Until|Check-Date|Retries)' > "$root/etc/apt/apt.conf.d/90host" || true
cp /etc/resolv.conf /etc/hosts "$root/etc/"
[ ! -e /etc/ssl/certs/ca-certificates.crt ] || install -D -m 644 {,"$root"}/etc/ssl/certs/ca-certificates.crt

# The working tree: what git tracks or would track, as it lies there.
rm -rf "$root/dragmesh" && mkdir "$root/dragmesh"
git ls-files -z --cached --others --exclude-standard | while IFS= read -r -d '' file; do
    [ ! -e "$file" ] || printf '%s\0' "$file"
done | tar --null --no-recursion -T - -cf - | tar -C "$root/dragmesh" --no-same-owner -xf -

release_mounts
mount -t proc proc "$root/proc"
failed=()
inside() { # COMMAND…, in the source folder
    echo "== $suite: $*"
    chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 ${JOBS:+JOBS=$JOBS} \
        sh -c 'cd /dragmesh && exec "$@"' sh "$@" || failed+=("$*")
}
packed() { # the release that was made outside, and hosts that know nothing else
    local archive=$1
    cp "$archive" "$root/tmp/"
    chroot "$root" apt-get update -qq
    DEBIAN_FRONTEND=noninteractive chroot "$root" apt-get install -y -qq --no-install-recommends gcc libc6-dev cmake make pkg-config > /dev/null
    inside tests/release/hosts.sh "/tmp/$(basename "$archive")" /tmp/hosts
}
{
    for archive in build/dist/dragmesh-*-linux-x64.tar.gz; do [ ! -e "$archive" ] || packed "$archive"; done
    if [ "${2:-}" != hosts ]; then
        inside scripts/demo
        inside scripts/test quick
    fi
} > >(tee "$out/log") 2>&1
cp "$root"/dragmesh/out/cabinet_open.* "$out/" 2> /dev/null || true
if [ ${#failed[@]} -gt 0 ]; then
    printf "$suite: FAILED: %s\n" "${failed[@]}" >&2
    exit 1
fi
[ "${2:-}" = hosts ] && echo "$suite: the release's hosts build and run" && exit
echo "$suite: scripts/demo and scripts/test quick passed; the picture is build/distribution/$suite/cabinet_open.png"
