#!/usr/bin/env bash
# tests/engines/trials.sh [PAGE…] — a newcomer of each host: in a bare Debian 12 of its own, with the archives of the release
# alone, runs the commands that docs/engines/PAGE.md gives under "Install" and "First door", with its code saved in the files that
# it names, and expects the words that it says the program ends with. Prints the seconds of the packages' download and
# installation, and those of the rest. As root, with debootstrap; some 400 MB of downloads.
# PAGE: cpp, csharp, rust, love, python, blender, web, or a sample, whose README.md has the same headings: 13_whole_host. All
# unless some are given.
#   DM_DIST  folder of the archives, by default build/dist
#   DM_BASE  folder of a bare Debian 12 to copy, made where there is none; by default one that is removed
set -euo pipefail
[ -z "${DM_BASE:-}" ] || export DM_BASE=$(realpath -m "$DM_BASE")
[ -z "${DM_DIST:-}" ] || export DM_DIST=$(realpath -m "$DM_DIST")
cd "$(dirname "$0")/../.."
[ "$(id -u)" = 0 ] || { echo "trials.sh: needs root, for chroot" >&2; exit 2; }
command -v debootstrap > /dev/null || { echo "trials.sh: debootstrap is missing" >&2; exit 2; }
# In namespaces of its own: nothing stays mounted or runs on, however this ends.
[ -n "${DM_UNSHARED:-}" ] || DM_UNSHARED=1 exec unshare --mount --pid --fork --propagation private "$PWD/tests/engines/trials.sh" "$@"
[ $# -gt 0 ] || set -- cpp csharp rust love python blender web 13_whole_host
numbers=$(scripts/version numbers)
work=$(mktemp -d) failed=0
root=$work/root base=${DM_BASE:-$work/base}
mounts() { # ON|OFF
    local folder
    for folder in proc dev; do
        if [ "$1" = ON ]; then mount --rbind "/$folder" "$root/$folder" && mount --make-rslave "$root/$folder"
        else while mountpoint -q "$root/$folder"; do umount -l "$root/$folder"; done; fi
    done
}
trap 'mounts OFF; rm -rf --one-file-system "$work"' EXIT
trap 'exit 1' INT TERM

if [ ! -e "$base/etc/debian_version" ]; then
    debootstrap --variant=minbase bookworm "$base" "${DM_MIRROR:-http://deb.debian.org/debian}" > "$work/debootstrap.log" ||
        { tail "$work/debootstrap.log" >&2; exit 1; }
fi
cp /etc/resolv.conf /etc/hosts "$base/etc/"
apt-config dump | grep -E '^Acquire::(https?|Check-Valid-Until|Check-Date|Retries)' > "$base/etc/apt/apt.conf.d/90host" || true
# This machine's way to npm, which may lead through a proxy with a certificate of its own.
[ ! -e /etc/ssl/certs/ca-certificates.crt ] || install -D -m 644 /etc/ssl/certs/ca-certificates.crt "$base/etc/ssl/host.crt"
echo "export NODE_EXTRA_CA_CERTS=/etc/ssl/host.crt" > "$work/way"
chroot "$base" apt-get update -qq

# What a reader does with a page, as a script: types the commands, and saves code under the name that the line above it says.
steps() {
    awk '/^## / { here = $0 == "## Install" || $0 == "## First door" }
        !here { next }
        match($0, /ave this as `[^`]+`/) { name = substr($0, RSTART + 13, RLENGTH - 14) }
        /^```$/ && code { if (code == 2) print "END_OF_CODE"; code = 0; next }
        /^```sh$/ { code = 1; next }
        /^```/ && name { print "cat > " name " << \"END_OF_CODE\""; code = 2; name = ""; next }
        /^```/ { code = 3; next }
        code == 1 || code == 2' "$1"
}

for page; do
    text=docs/engines/$page.md
    [ -e "$text" ] || text=samples/$page/README.md
    rm -rf --one-file-system "$root" && cp -a "$base" "$root" && mounts ON
    mkdir "$root/root/trial" && cp "${DM_DIST:-build/dist}"/*dragmesh*-"$numbers"* "$root/root/trial/"
    { # apt's seconds are counted apart
        cat "$work/way"
        echo 'apt() { local from=$SECONDS; command apt-get -qq "$@" > /dev/null; packages=$((packages + SECONDS - from)); }
            export DEBIAN_FRONTEND=noninteractive HOME=/root; packages=0; cd /root/trial'
        steps "$text"
        echo 'echo "trial $packages $((SECONDS - packages))"'
    } > "$root/root/steps"
    chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb bash -eo pipefail /root/steps > "$work/log" 2>&1 || true
    read -r _ packages rest < <(grep '^trial ' "$work/log") || packages=
    said=$(sed -n 's/^It ends with `\([^`]*\)`.*/\1/p' "$text" | head -1)
    if [ -n "$packages" ] && grep -qF "$said" "$work/log"; then
        echo "$page: the door is open after $packages s for packages and $rest s for the rest"
    else
        echo "$page: the page does not lead to an open door" >&2
        tail -n 30 "$work/log" >&2
        failed=1
    fi
    mounts OFF
done
exit $failed
