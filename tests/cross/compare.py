"""Compares two files of the tool number by number: compare.py TOLERANCE A B.

Text (JSON lines): all words alike, numbers that differ by at most TOLERANCE of their size, or TOLERANCE where they are
below 1. Binary glTF: the same for the 32-bit floats of the binary chunk. Prints the greatest difference.
"""
import re
import struct
import sys

NUMBER = re.compile(r"-?\d+\.?\d*(?:[eE][-+]?\d+)?")
GLB_MAGIC, CHUNK_HEADER = b"glTF", 8


def floats_of(data):
    """The binary chunk as floats; what is no number (indices that look like NaN) as 0."""
    json_size = struct.unpack_from("<I", data, 12)[0]
    start = 12 + CHUNK_HEADER + json_size + CHUNK_HEADER
    count = (len(data) - start) // 4
    return [x if x == x and abs(x) < 1e30 else 0.0 for x in struct.unpack_from(f"<{count}f", data, start)]


def read(path):
    data = open(path, "rb").read()
    if data[:4] == GLB_MAGIC:
        return "", floats_of(data)
    text = data.decode()
    return NUMBER.sub("#", text), [float(x) for x in NUMBER.findall(text)]


def main():
    tolerance = float(sys.argv[1])
    (words, here), (other_words, there) = read(sys.argv[2]), read(sys.argv[3])
    if words != other_words or len(here) != len(there):
        sys.exit(f"{sys.argv[2]} and {sys.argv[3]} say different things")
    worst = max((abs(a - b) / max(1.0, abs(a)) for a, b in zip(here, there)), default=0.0)
    print(f"{len(here)} numbers, at most {worst:.1e} apart")
    sys.exit(worst > tolerance)


main()
