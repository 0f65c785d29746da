#!/usr/bin/env bash
# tests/literals.sh [folder…] — lists numeric literals that have no name, as FILE:LINE:LITERAL; exits 1 if there is one.
#
# Allowed without a name: 0, 1, 2, 3 and 0.5 with any suffix; preprocessor lines; enum bodies; initialisers of constants
# (`static const`); strings; and the lines of, or right below, a comment that contains "literal:" and a reason.
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- sdk/kinematics sdk/segmentation
exec python3 - "$@" <<'PYTHON'
import pathlib
import re
import sys

ALLOWED = {0.0, 0.5, 1.0, 2.0, 3.0}
TOKEN = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'', re.S)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", re.M)
ENUM = re.compile(r"\benum\b[^{;()]*\{[^}]*\}", re.S)
CONSTANT = re.compile(r"\bstatic\s+const\b[^;{=()]*(?:\([^)]*\)[^;{=()]*)?=", re.S)
NUMBER = re.compile(r"(?<![\w.])(?:0[xX][0-9a-fA-F]+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)[uUlLfF]*(?![\w.])")


def blank(text):
    """Replaces everything but the line ends by spaces."""
    return re.sub(r"[^\n]", " ", text)


def without_constants(text):
    """Blanks the initialisers of `static const` variables, up to the semicolon."""
    at = 0
    while found := CONSTANT.search(text, at):
        at = text.find(";", found.end())
        at = len(text) if at < 0 else at
        text = text[:found.end()] + blank(text[found.end():at]) + text[at:]
    return text


def value(literal):
    if literal[:2].lower() == "0x":
        return float(int(literal.rstrip("uUlL"), 16))
    return float(literal.rstrip("uUlLfF"))


def literals(path):
    text = path.read_text()
    excused = set()
    for comment in TOKEN.finditer(text):
        if comment[0].startswith("/*") and "literal:" in comment[0]:
            last = text.count("\n", 0, comment.end()) + 1
            before = text[text.rfind("\n", 0, comment.start()) + 1:comment.start()]
            excused.add(last if before.strip() else last + 1)
    text = TOKEN.sub(lambda m: blank(m[0]), text)
    text = DIRECTIVE.sub(lambda m: blank(m[0]), text)
    text = without_constants(ENUM.sub(lambda m: blank(m[0]), text))
    for number in NUMBER.finditer(text):
        line = text.count("\n", 0, number.start()) + 1
        if value(number[0]) not in ALLOWED and line not in excused:
            yield line, number[0]


found = 0
for folder in sys.argv[1:]:
    root = pathlib.Path(folder)
    for path in sorted(root.rglob("*.[ch]") if root.is_dir() else [root]):
        for line, literal in literals(path):
            print(f"{path}:{line}:{literal}")
            found += 1
sys.exit(found > 0)
PYTHON
