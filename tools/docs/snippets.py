#!/usr/bin/env python3
"""Finds programs in the manual that no test compiles.

usage: tools/docs/snippets.py [PAGE.md ...]

Each block of code must be lines of one file below tests, platform or tools, one after the other, however far indented.
A line `…` or `// …` in a block stands for any lines. Pages whose
programs a check takes out of them are left to it. Of TOML only graphs are programs. Exit 1 if a block is in no file.
"""
import functools
import re
import sys
import textwrap

import blocks

FOLDERS = ["tests", "platform", "tools", "shaders"]
LANGUAGES = {"cpp": (".cpp", ".h"), "c": (".c", ".h"), "cmake": (".txt", ".cmake", ".sh"), "glsl": (".glsl", ".cpp", ".h"), "js": (".mjs", ".js", ".html", ".cjs"),
             "ts": (".ts",), "rust": (".rs",), "csharp": (".cs",), "swift": (".swift",), "java": (".java",),
             "gdscript": (".gd",), "python": (".py",), "toml": (".toml",)}


@functools.cache
def sources(endings):
    """What stands in the files with these endings, each line without its indentation."""
    found = []
    for folder in FOLDERS:
        for path in (blocks.ROOT / folder).rglob("*"):
            if path.suffix in endings and path.is_file():
                found.append("\n" + "\n".join(line.strip() for line in path.read_text(errors="replace").split("\n")) + "\n")
    return found


def pieces(text):
    """A block's runs of lines between its ellipses."""
    run = []
    for line in text.strip("\n").split("\n") + ["…"]:
        if line.strip() in ("…", "// …", "/* … */", "# …"):
            if run:
                yield "\n" + "\n".join(run) + "\n"
            run = []
        else:
            run.append(line.strip())


def stands_in(text, source):
    at = 0
    for piece in pieces(text):
        at = source.find(piece, at)
        if at < 0:
            return False
        at += len(piece) - 1
    return True


def main():
    missing = 0
    for page in blocks.pages(sys.argv[1:]):
        if blocks.run_by(page):
            continue
        for block in blocks.blocks(page):
            endings = LANGUAGES.get(block.language)
            if endings is None or block.excuse:
                continue
            if block.language == "toml" and not re.search(r"^(\[node\.|state\.|transition)", block.text, re.M):  # settings
                continue
            if not any(stands_in(block.text, source) for source in sources(endings)):
                print(f"{page.relative_to(blocks.ROOT)}:{block.line}: in no file of the tests: "
                      f"{textwrap.shorten(block.text, 60)}", file=sys.stderr)
                missing += 1
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
