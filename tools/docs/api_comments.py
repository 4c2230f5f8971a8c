#!/usr/bin/env python3
"""The public headers, as Doxygen reads them.

usage: tools/docs/api_comments.py HEADER     (Doxygen's input filter)
       tools/docs/api_comments.py --inputs STAGES.dox   (writes the stages, prints all inputs in order)

Each header is a group, of which its comment at the top is the text. A comment on lines of its own belongs to what
follows, one behind a declaration to that declaration. Code is not changed.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
STAGES = {
    "everywhere": ("Everywhere: status, memory, versions", "version status call_error zones span block pose math api marrow owned glm"),
    "files": ("Files", "unpack draco meshopt file skeleton roles clip mesh material clip_pack"),
    "poses": ("Poses", "playback clip_motion pose_map events root_motion phase blend_space sample blend transition local_to_model curve outfit character graph animator"),
    "reaching": ("Reaching: inverse kinematics, limits, springs", "limits ik ik_solve feet springs debug_lines"),
    "skinning": ("Skinning", "example_space morph palette bounds skin"),
    "gles": ("OpenGL ES", "gles3 gles3_skinner gles3_crowd gles3_self_test gles3_functions egl"),
    "clang": ("For C and other languages", "c c_gles3"),
}

MAIN_PAGE = """/** @mainpage
The public headers, grouped as the <a href="modules.html">stages</a> are. Every function says what goes in and out, in
which units and spaces, what fails and what it costs. <a href="../index.html">The manual</a> says how they are used.
*/"""


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


def stage(name):
    return next((key for key, (_, headers) in STAGES.items() if name in headers.split()), None)


def heading(name, comment):
    """The header's group: its first sentence is the title."""
    text = " ".join(comment).split(". ", 1)[0].rstrip(".")
    group = f"header_{name}"
    return [f"/// @file\n/// @brief {text}.\n", f"/// @defgroup {group} {name}.h: {text}\n/// @ingroup {stage(name)}",
            *[f"/// {line}" for line in comment]]


def convert(name, text):
    text = re.sub(r"\n  union \{\n(.*?)\n  \};\n", r"\n\1\n", text, flags=re.S)  # Doxygen 1.9 links to nameless ones wrongly
    lines = text.split("\n")
    top = next(i for i, line in enumerate(lines) if not line.startswith("//"))
    out = heading(name, [as_text(line[2:].strip()) for line in lines[:top]])
    behind, opened, notes, before = None, False, [], ""
    for line in lines[top:]:
        code, column, comment = split_comment(line)
        if re.fullmatch(r"typedef struct (\w+) \1;", line) or comment.startswith((" clang-format", " ---")):
            continue  # the comment above such a line is the struct's
        if opened and re.match(r"}  // namespace|#ifdef __cplusplus", line):
            out.append("/// @}")
            opened = False
        if column is not None and not code.strip():
            if behind == column:  # goes on with the comment behind the line above
                out.insert(len(out) - 1, f"///{as_text(comment)}")
            else:
                notes = notes + [f"///{as_text(comment)}"] if before == "comment" else [f"///{as_text(comment)}"]
                out.append(notes[-1])
                before = "comment"
            continue
        behind = column
        note = as_text(comment) if column is not None else default_note(line)
        alike = re.match(r"\s*(MARROW_API|[\w:]+ \w+\(.*\{ return|(const )?[a-z]\w+\*? mrw_\w+\()", code) and before == "function"
        of = next((kind for kind in ("#define", "inline constexpr") if code.startswith(kind)), None)
        if (alike or of and of == before) and not note:
            out += notes  # functions, macros and constants one below the other share the comment above them
        for part in declarators(code):
            out += [f"///{note}"] * bool(note) + [part]
        function = re.search(r"\)( const| MRW_NODISCARD)*;|\{ return .*\}$", code.rstrip())
        before = of if of else "function" if function else "open" if before == "open" or re.match(r"\s*MARROW_API|(const )?[a-z]\w+\*? mrw_\w+\(", code) else ""
        if re.match(r'namespace [\w:]+ {|extern "C" {', line):
            out.append(f"/// @addtogroup header_{name}\n/// @{{")
            opened = True
    return "\n".join(out)


def declarators(code):
    """`int a = 1, b = 2;` as `int a = 1;` and `int b = 2;`."""
    value = r"(?: = (?:\{[^}]*\}|[^,({]+))?"
    one = r"[A-Za-z_]\w*(?:\[\w+\])*" + value
    match = re.fullmatch(rf"(\s*)((?:const )?[\w:<> ]+[*&]? )({one}(?:, {one})+);\s*", code)
    if not match or match.group(2).strip() in ("return", "using"):
        return [code]
    return [f"{match.group(1)}{match.group(2)}{part};" for part in re.split(r", (?=[A-Za-z_]\w*(?:\[|,|$| =))", match.group(3))]


def default_note(line):
    """What is said of what is alike everywhere, above all in C, where a span is two members."""
    for pattern, note in {r"\s*(std::)?uint\d+_t reserved\b": " 0.",
                          r"void mrw_\w+_init\(": " Sets defaults.",
                          r"  size_t \w+_count;": " How many there are of the member above.",
                          r"  size_t \w+_bytes;": " How many bytes there are of the member above.",
                          r"  (const )?\w+\* data;": " The first of them.",
                          r"  size_t size;": " How many there are.",
                          r"struct mrw_(block|bytes|\w+_list) \{": " A list: a pointer and a count.",
                          r"  ((uint32_t|size_t) (numbers|words)\[|const void\* (block|sections);|void\* user;)": " Marrow's own.",
                          r"typedef .*\(\*\w+\)\(": " A function of the caller's."}.items():
        if re.match(pattern, line):
            return note
    return ""


def inputs():
    """Every header's path, by stages. A header without a stage ends the program."""
    found = {path.stem: path for folder in ("runtime/include/marrow", "platform/egl/include/marrow") for path in (ROOT / folder).glob("*.h")}
    named = [name for _, headers in STAGES.values() for name in headers.split()]
    if sorted(named) != sorted(found):
        raise SystemExit(f"api_comments: STAGES and the headers differ in {sorted(set(named) ^ set(found))}")
    return [found[name] for name in named]


def main():
    if sys.argv[1] == "--inputs":
        groups = "\n".join(f"/// @defgroup {key} {title}" for key, (title, _) in STAGES.items())
        pathlib.Path(sys.argv[2]).write_text(f"{MAIN_PAGE}\n{groups}\n")
        print(" ".join([sys.argv[2], *[str(path.relative_to(ROOT)) for path in inputs()]]))
        return
    path = pathlib.Path(sys.argv[1])
    sys.stdout.write(path.read_text() if stage(path.stem) is None else convert(path.stem, path.read_text()))


if __name__ == "__main__":
    main()
