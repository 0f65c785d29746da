#!/usr/bin/env bash
# tests/prose.sh [--count | room…] — lists the comments of these rooms that begin with a preposition, as FILE:LINE: and the
# comment's first words; exits 1 if there is one. Without a room it takes all of them. --count prints how many each folder of
# sdk and plugin_api has.
#
# A comment says what a function returns or computes, or what a value is, in a sentence that has a verb or in a noun with
# its unit. One that begins "Of", "For" or "In" leaves the reader to guess what it is of.
set -euo pipefail
cd "$(dirname "$0")/.."
all="plugin_api sdk"
exec python3 - ${@:-$all} <<'PYTHON'
import collections
import pathlib
import re
import sys

PREPOSITIONS = """about above across after against along among around as at before behind below beneath beside besides between
    beyond by despite during except for from in inside into near of off on onto over past since through to toward towards
    under until unto up upon with within without""".split()
BARE = re.compile(r"/[*/][*!]*[\s*]*(%s)\b[^\n]*" % "|".join(PREPOSITIONS), re.I)
TOKEN = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)


def findings(path):
    text = path.read_text(encoding="utf-8")
    for token in TOKEN.finditer(text):
        bare = BARE.match(token[0])
        if bare:
            words = " ".join(re.sub(r"[\s*/]+", " ", token[0]).split()[:8])
            yield f"{path}:{text.count(chr(10), 0, token.start()) + 1}: {words}"


def sources(room):
    return sorted(path for path in pathlib.Path(room).rglob("*") if path.suffix in (".c", ".h", ".cpp", ".def"))


rooms = " ".join(sys.argv[1:]).split()
if rooms == ["--count"]:
    counts = collections.Counter(str(path.parent) for room in ("sdk", "plugin_api") for path in sources(room) for _ in findings(path))
    for folder, count in sorted(counts.items()):
        print(f"{count:5} {folder}")
    print(f"{sum(counts.values()):5} together")
    sys.exit()
found = [line for room in rooms for path in sources(room) for line in findings(path)]
if found:
    print("\n".join(found))
    sys.exit(f"tests/prose.sh: {len(found)} comments begin with a preposition")
PYTHON
