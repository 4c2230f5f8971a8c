"""Whether each block of C++ in docs/platforms/sdl.md stands in a file of platform/sdl, but for its indent.

usage: snippets.py ROOT"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
page = (root / "docs/platforms/sdl.md").read_text()
files = ["\n".join(line.strip() for line in path.read_text().splitlines())
         for path in sorted((root / "platform/sdl").glob("*.*"))]
blocks = re.findall(r"^```cpp\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
if len(blocks) < 15:
    sys.exit(f"docs/platforms/sdl.md: only {len(blocks)} blocks of C++")
for block in blocks:
    if not any("\n".join(line.strip() for line in block.strip().splitlines()) in text for text in files):
        sys.exit("docs/platforms/sdl.md: not in platform/sdl:\n" + block)
print(f"{len(blocks)} blocks of docs/platforms/sdl.md are in platform/sdl")
