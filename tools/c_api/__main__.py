"""Makes what C, Rust, C# and JavaScript call from runtime/c/api.txt and gles3.txt.

usage: python3 tools/c_api [--check | --bindings FOLDER | --tests FOLDER | --exports FOLDER]
Without options it writes what games compile, which is committed: the headers of C and their wrappers.
--check: writes nothing; exit code 1 if one of those is not what it would write
--bindings: writes what Rust, C# and JavaScript call by into the folder
--tests: writes there what the tests compile: checks of layouts, and a call of each function
--exports: prints the functions that libraries export, by the headers in the folder, as often as they have overloads
"""
import pathlib
import sys
import zlib

import c_words
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
NO_FUNCTIONS = {'c.h', 'c_gles3.h', 'glm.h', 'marrow.h', 'owned.h', 'span.h'}  # that C would have


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


class Api:
    """Both libraries, and the files that come of them."""

    def __init__(self):
        lines = {}
        def read_header(name):
            if name not in lines:
                lines[name] = (INCLUDE / name).read_text().splitlines()
            return lines[name]
        c = Part('c', 'runtime/c/api.txt', '', [], read_header)
        gles3 = Part('c_gles3', 'runtime/c/gles3.txt', 'gles3_', c.rows, read_header)
        self.parts, self.rows = [c, gles3], c.rows + gles3.rows
        headers.expect_all_functions(self.rows, read_header, sorted({p.name for p in INCLUDE.glob('*.h')} - NO_FUNCTIONS))
        self.headings = {name: heading(read_header(name)) for name in {r.header for r in self.rows}}

    def committed(self):
        """Every file that a game's build compiles, by its path."""
        structs = {r.name for r in self.rows if r.kind == 'struct'}
        out = {}
        for part in self.parts:
            words = c_words.Words(part, self.parts)
            out[f'runtime/include/marrow/{part.header}'] = to_c.header(part, structs, self.headings, words)
            for name in sorted({r.source for r in part.rows if r.kind == 'fn'}):
                out[f'runtime/c/{name}'] = to_cpp.Writer(part, self.rows).source(name)
        return out

    def bindings(self):
        return {
            'marrow.rs': to_rust.made(self.rows, self.parts),
            'Marrow.cs': to_csharp.made(self.rows, self.parts),
            'marrow.mjs': (ROOT / 'runtime/c/marrow.mjs').read_text(),
            'gl.mjs': (ROOT / 'platform/web/gl.mjs').read_text(),
            'marrow.d.ts': to_script.types(self.rows, self.parts),
            'tables.mjs': to_script.tables(self.rows, self.parts),
        }

    def tests(self):
        out = {}
        for part in self.parts:
            out[f'{part.prefix}layouts.cpp'] = to_cpp.Writer(part, self.rows).layouts()
            out[f'{part.prefix}bad_calls.h'] = to_tests.rows_of_calls(part, self.rows)
        return out


def exports(folder):
    return sorted(name for path in pathlib.Path(folder).glob('*.h')
                  for name, exported, _ in headers.functions_of(path.read_text().splitlines()) if exported)


def write(folder, files):
    for path, text in files.items():
        file = pathlib.Path(folder) / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return 0


def check(files):
    wrong = [path for path, text in files.items() if not (ROOT / path).exists() or (ROOT / path).read_text() != text]
    for path in wrong:
        print(f'{path}: is not what the description says: run python3 tools/c_api', file=sys.stderr)
    return 1 if wrong else 0


def main(words):
    option = words[0] if words else ''
    if len(words) != {'': 0, '--check': 1, '--bindings': 2, '--tests': 2, '--exports': 2}.get(option):
        raise SystemExit(__doc__)
    if option == '--exports':
        print(*exports(words[1]), sep='\n')
        return 0
    api = Api()
    if option == '--check':
        return check(api.committed())
    if option == '--bindings':
        return write(words[1], api.bindings())
    return write(words[1], api.tests()) if option == '--tests' else write(ROOT, api.committed())


sys.exit(main(sys.argv[1:]))
