#!/usr/bin/env python3
"""Doxygen's input filter: the comments of a public header, as Doxygen reads them.

usage: tools/docs/api_comments.py HEADER

The comment at a header's top becomes the text of a group, named by the header. A comment on lines of its own belongs to
what follows, one behind a declaration to that declaration. Code is not changed, nor is the number of lines.
"""
import pathlib
import re
import sys


def as_text(text):
    """What Doxygen would take for a command or a tag, as plain text."""
    parts = re.split(r"(`[^`]*`)", text)
    parts = [p if p.startswith("`") else re.sub(r"(?<![\\\w])[@\\](?=\w)", r"\\\g<0>", p).replace("<", "\\<").replace("#", "\\#")
             for p in parts]
    return "".join(parts)


def split_comment(line):
    """(code, column of the comment or None, text) of a line; // inside a string is no comment."""
    quoted = False
    for i, c in enumerate(line):
        if c == '"' and line[i - 1] != "\\":
            quoted = not quoted
        elif c == "/" and not quoted and line.startswith("//", i):
            return line[:i], i, line[i + 2:]
    return line, None, ""


def convert(name, text):
    out, behind, top = [], None, True
    lines = text.split("\n")
    depth_of_body = next((i for i, line in enumerate(lines) if re.match(r"(namespace|extern \"C\"|#include|#define X|#ifdef)", line)), 0)
    for number, line in enumerate(lines):
        code, column, comment = split_comment(line)
        if column is None:
            out.append(line)
            behind = None
            top = top and not line.strip()
        elif comment.startswith((" clang-format", "---")):
            out.append(code.rstrip())
        elif code.strip():
            out.append(f"{code}///<{as_text(comment)}")
            behind = column
        elif behind == column:  # goes on with the comment above it
            out.append(f"{code}///<{as_text(comment)}")
        else:
            behind = None
            start = top and number == 0
            title = as_text(comment).strip()
            out.append(f"/// @file\n/// @brief {title}" if start else f"{code}///{as_text(comment)}")
    return "\n".join(out)


def main():
    path = pathlib.Path(sys.argv[1])
    sys.stdout.write(convert(path.stem, path.read_text()))


if __name__ == "__main__":
    main()
