"""check_page.py PAGE FOLDER — whether the lines of each block of the page that names a file (```xml rigged.urdf) stand in that file
of the folder, one after the other, but for blanks. Prints what does not, and exits with 1."""
import pathlib
import re
import sys


def main():
    page, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    failed, blocks = 0, re.findall(r"^```\w+ (rigged\.\w+)\n(.*?)^```", page.read_text(), re.M | re.S)
    for name, lines in blocks:
        text, at = re.sub(r"\s", "", (folder / name).read_bytes().decode(errors="replace")), 0
        for line in filter(None, (re.sub(r"\s", "", line) for line in lines.splitlines())):
            found = text.find(line, at)
            if found < 0:
                print(f"{page}: {name} has no {line}")
                failed += 1
            else:
                at = found + len(line)
    print(f"{page}: {len(blocks)} examples, {failed} lines are not in the files")
    sys.exit(failed > 0 or not blocks)


if __name__ == "__main__":
    main()
