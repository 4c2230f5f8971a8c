"""Makes what C, Rust, C# and JavaScript call from runtime/c/api.txt and gles3.txt.

usage: python3 tools/c_api [--check | --exports FOLDER]
--check: writes nothing; exit code 1 if a file is not what it would write
--exports: prints the functions that libraries export, by the headers in the folder, as often as they have overloads
"""
import pathlib
import sys
import zlib

import description
import headers
import to_c
import to_cpp
import to_csharp
import to_rust
import to_script
import to_tests

ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = ROOT / 'runtime/include/marrow'
NO_FUNCTIONS = {'c.h', 'c_gles3.h', 'glm.h', 'marrow.h', 'span.h'}  # that C would have


class Part:
    """A library for C with its description: files and functions begin with its prefix."""

    def __init__(self, name, file, prefix, above, read_header):
        self.prefix = prefix
        self.header = f'{name}.h'
        self.wrappers = f'{prefix}wrappers.cpp'
        self.rows = description.read_rows(ROOT / file, above, self.wrappers, read_header)
        headers.complete(self.rows, above, read_header)
        self.abi = abi_of(above + self.rows)
        headers.add_docs(self.rows, read_header)
        for row in self.rows:
            may_be_null = [name for name, t in row.fields
                           if t.optional and t.form != '[]' and row.kind == 'fn' and t.name != 'f32']
            if may_be_null:
                row.doc = row.doc + ['May be null: ' + ', '.join(may_be_null) + '.']


def abi_of(rows):
    """A checksum of all that programs are compiled against."""
    told = [(r.kind, r.name, r.type, r.value, r.values, r.fields, r.flags) for r in rows if r.kind != 'no']
    return zlib.crc32(repr(told).encode())


def heading(lines):
    out = []
    for line in lines:
        if not line.startswith('//'):
            break
        out.append(line[2:].strip() if not line.startswith('//   ') else line[3:].rstrip())
    return out


def made():
    """Every file, by its path."""
    lines = {}
    def read_header(name):
        if name not in lines:
            lines[name] = (INCLUDE / name).read_text().splitlines()
        return lines[name]
    c = Part('c', 'runtime/c/api.txt', '', [], read_header)
    gles3 = Part('c_gles3', 'runtime/c/gles3.txt', 'gles3_', c.rows, read_header)
    parts, rows = [c, gles3], c.rows + gles3.rows
    headers.expect_all_functions(rows, read_header, sorted({p.name for p in INCLUDE.glob('*.h')} - NO_FUNCTIONS))
    structs = {r.name for r in rows if r.kind == 'struct'}
    headings = {name: heading(read_header(name)) for name in {r.header for r in rows}}
    out = {
        'runtime/c/c_draco.cpp': to_cpp.Writer(c, rows).source('c_draco.cpp'),
        'runtime/c/c_meshopt.cpp': to_cpp.Writer(c, rows).source('c_meshopt.cpp'),
        'runtime/c/bindings/rust/marrow.rs': to_rust.made(rows, parts),
        'runtime/c/bindings/csharp/Marrow.cs': to_csharp.made(rows, parts),
        'runtime/c/bindings/typescript/tables.mjs': to_script.tables(rows, parts),
        'runtime/c/bindings/typescript/marrow.d.ts': to_script.types(rows, parts),
    }
    for part in parts:
        writer = to_cpp.Writer(part, rows)
        out[f'runtime/include/marrow/{part.header}'] = to_c.header(part, structs, headings)
        out[f'runtime/c/{part.wrappers}'] = writer.source(part.wrappers)
        out[f'runtime/c/{part.prefix}layouts.cpp'] = writer.layouts()
        out[f'runtime/c/{part.prefix}exports.txt'] = to_script.exports(part)
        out[f'tests/c/{part.prefix}bad_calls.h'] = to_tests.rows_of_calls(part, rows)
    return out


def exports(folder):
    return sorted(name for path in pathlib.Path(folder).glob('*.h')
                  for name, exported, _ in headers.functions_of(path.read_text().splitlines()) if exported)


def main():
    if len(sys.argv) == 3 and sys.argv[1] == '--exports':
        print(*exports(sys.argv[2]), sep='\n')
        return 0
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
