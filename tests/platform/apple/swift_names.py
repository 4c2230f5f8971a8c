"""Says which names of the C interface a text uses that its headers do not have.

usage: swift_names.py HEADERS FILE ...
HEADERS: the folder of c.h and c_gles3.h. FILE: Swift, or a page. Exit code: 0 all are there, 1 not.
"""

import pathlib
import re
import sys

NAME = re.compile(r"\b(?:mrw|MRW)_\w+")


def main():
    headers = pathlib.Path(sys.argv[1])
    known = set()
    for header in ("c.h", "c_gles3.h"):
        known |= set(NAME.findall(re.sub(r"//.*|/\*.*?\*/", "", (headers / header).read_text())))
    used = wrong = 0
    for name in sys.argv[2:]:
        for number, line in enumerate(pathlib.Path(name).read_text().splitlines(), 1):
            for word in NAME.findall(line):
                used += 1
                if word not in known:
                    wrong += 1
                    print(f"{name}:{number}: {word} is not in marrow/c.h or marrow/c_gles3.h", file=sys.stderr)
    print(f"{used} names of the C interface in {len(sys.argv) - 2} files, {len(known)} in the headers")
    return 1 if wrong or used == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
