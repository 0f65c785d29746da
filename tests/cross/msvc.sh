#!/usr/bin/env bash
# tests/cross/msvc.sh — what can be said of Microsoft's compiler and linker without them: clang-cl's mode of clang compiles
# the library, and lld-link, by Microsoft's rules, links a host with dragmesh.lib. Needs build/windows (tests/cross/run.sh).
# mingw's headers stand for Microsoft's; they ask for gcc's name and turn attributes off where they see Microsoft's.
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cl="clang --driver-mode=cl --target=x86_64-pc-windows-msvc /std:c17"
headers="-Xclang -fgnuc-version=4.2.1 -U_MSC_VER -Xclang -isystem -Xclang /usr/x86_64-w64-mingw32/include"
includes="-Iplugin_api/include -Isdk -Ithird_party"
mapfile -t sources < <(find sdk plugin_api/src third_party/cjson -maxdepth 3 -name '*.c' -not -name 'embree*' -not -path '*/upstream/*')
printf '%s\0' "${sources[@]}" | xargs -0 -P "$(nproc)" -n 8 \
    $cl $headers $includes /W3 /WX /DDM_BUILDING /DDMI_NO_EMBREE /D_GNU_SOURCE -fsyntax-only
echo "clang-cl: ${#sources[@]} files of the library without a warning"

$cl -Xclang -ffreestanding /GS- /Zl /O1 $includes /c /Fo"$work/host.obj" tests/cross/msvc_host.c
lld-link /nologo /entry:start /subsystem:console /nodefaultlib /out:"$work/host.exe" "$work/host.obj" build/windows/dragmesh.lib
cp build/windows/dragmesh.dll "$work"
WINEPREFIX=$PWD/build/windows/wine WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml,winemenubuilder.exe=" wine "$work/host.exe"
echo "lld-link: a host linked with dragmesh.lib runs"
