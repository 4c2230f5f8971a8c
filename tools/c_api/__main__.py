"""Makes what C, Rust, C# and JavaScript call from runtime/c/api.txt.

usage: python3 tools/c_api [--check]      --check: writes nothing; exit code 1 if a file is not what it would write
"""
import pathlib
import re
import sys
import zlib

import description
import to_c
import to_cpp
import to_csharp
import to_rust
import to_script
import to_tests

ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = ROOT / 'runtime/include/marrow'


def abi_of(text):
    """A checksum of all that programs are compiled against: of rows, not of remarks."""
    rows = [re.sub(r'\s+', ' ', line) for line in text.splitlines() if line.strip() and not line.startswith(('#', 'no '))]
    return zlib.crc32('\n'.join(rows).encode())


def heading(lines):
    out = []
    for line in lines:
        if not line.startswith('//'):
            break
        out.append(line[2:].strip() if not line.startswith('//   ') else line[3:].rstrip())
    return out


def made():
    """Every file, by its path."""
    text = (ROOT / 'runtime/c/api.txt').read_text()
    rows = description.read_rows(text)
    lines = {}
    def read_header(name):
        if name not in lines:
            lines[name] = (INCLUDE / name).read_text().splitlines()
        return lines[name]
    description.add_docs(rows, read_header)
    for row in rows:
        may_be_null = [name for name, t in row.fields if t.optional and t.form != '[]' and row.kind == 'fn' and t.name != 'f32']
        if may_be_null:
            row.doc = row.doc + ['May be null: ' + ', '.join(may_be_null) + '.']
    headings = {name: heading(read_header(name)) for name in {r.header for r in rows}}
    abi = abi_of(text)
    writer = to_cpp.Writer(rows)
    return {
        'runtime/include/marrow/c.h': to_c.header(rows, abi, headings),
        'runtime/c/wrappers.cpp': writer.source('wrappers.cpp'),
        'runtime/c/c_draco.cpp': writer.source('c_draco.cpp'),
        'runtime/c/c_meshopt.cpp': writer.source('c_meshopt.cpp'),
        'runtime/c/layouts.cpp': writer.layouts(),
        'runtime/c/exports.txt': to_script.exports(rows),
        'runtime/c/bindings/rust/marrow.rs': to_rust.made(rows, abi),
        'runtime/c/bindings/csharp/Marrow.cs': to_csharp.made(rows, abi),
        'runtime/c/bindings/typescript/tables.mjs': to_script.tables(rows, abi),
        'runtime/c/bindings/typescript/marrow.d.ts': to_script.types(rows),
        'tests/c/bad_calls.h': to_tests.rows_of_calls(rows, lambda r: r.source == 'wrappers.cpp'),
    }


def main():
    check = sys.argv[1:] == ['--check']
    if sys.argv[1:] and not check:
        raise SystemExit(__doc__)
    wrong = 0
    for path, text in made().items():
        file = ROOT / path
        if check and (not file.exists() or file.read_text() != text):
            print(f'{path}: is not what the description says: run python3 tools/c_api', file=sys.stderr)
            wrong = 1
        elif not check:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
    return wrong


sys.exit(main())
