"""Reads runtime/c/api.txt, which says what it may hold, and the comments of the C++ headers."""
import re
from dataclasses import dataclass, field

SCALARS = {  # name: (bytes, C++ type)
    'f32': (4, 'float'), 'f64': (8, 'double'), 'bool': (1, 'bool'), 'byte': (1, 'std::byte'),
    'u8': (1, 'std::uint8_t'), 'u16': (2, 'std::uint16_t'), 'u32': (4, 'std::uint32_t'), 'u64': (8, 'std::uint64_t'),
    'i8': (1, 'std::int8_t'), 'i16': (2, 'std::int16_t'), 'i32': (4, 'std::int32_t'), 'size': (None, 'std::size_t'),
}


class Wrong(Exception):
    pass


@dataclass
class Type:
    name: str
    mut: bool = False
    form: str = ''  # '' a value, '*' a pointer, '[]' a pointer and a count, 'array'
    dims: tuple = ()
    optional: bool = False

    @staticmethod
    def read(text):
        m = re.fullmatch(r'(\w+)( mut)?(\*|\[\]|(?:\[\d+\])+)?(\?)?', text.strip())
        if not m:
            raise Wrong(f'{text}: not a type')
        form = m[3] or ''
        dims = tuple(int(n) for n in re.findall(r'\d+', form))
        return Type(m[1], bool(m[2]), 'array' if dims else form, dims, bool(m[4]))


@dataclass
class Row:
    """A constant, enum, struct, opaque or function; what it does not use is empty."""
    kind: str
    name: str
    cpp: str
    header: str
    type: object = None
    value: str = ''
    values: list = field(default_factory=list)  # of an enum
    fields: list = field(default_factory=list)  # of a struct, or a function's parameters: (name, Type)
    flags: tuple = ()
    method: str = ''  # of which type a function is a member
    is_member: bool = False  # a data member, not a function
    source: str = 'wrappers.cpp'
    doc: list = field(default_factory=list)
    docs: dict = field(default_factory=dict)  # of fields and enumerators

    def boundary(self):
        """The boundary that a struct asks for, or 1."""
        return max([int(flag[5:]) for flag in self.flags if flag.startswith('align')], default=1)


def read_parameters(text):
    parts = [p for p in text.split(', ') if p]
    return [(p.split(': ')[0], Type.read(p.split(': ')[1])) for p in parts]


def read_function(text, header):
    m = re.fullmatch(r'(?:(\w+)\.)?(\w+)(\((.*)\))? -> (.*?)(?: as (\w+))?(?: in (\w+\.cpp))?', text)
    if not m:
        raise Wrong(f'{text}: not a function')
    if m[5].endswith(']'):
        raise Wrong(f'{m[5]}: C returns no lists: make a struct of a pointer and a size')
    fields = read_parameters(m[4] or '')
    if m[1]:
        fields.insert(0, (m[1], Type(m[1])))
    name = m[6] or (f'{m[1]}_{m[2]}' if m[1] else m[2])
    return Row('fn', name, m[2], header, Type.read(m[5]) if m[5] != 'void' else None, fields=fields,
               method=m[1] or '', is_member=m[3] is None, source=m[7] or 'wrappers.cpp')


def read_rows(text):
    rows, header = [], ''
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.startswith('#'):
            continue
        word, _, rest = line.strip().partition(' ')
        try:
            if line.startswith('  '):
                rows[-1].fields.append((word, Type.read(rest)))
            elif word == 'header':
                header = rest
            elif word == 'const':
                m = re.fullmatch(r'(\w+) (\w+) (\w+) = (.*)', rest)
                rows.append(Row('const', m[1], m[3], header, Type.read(m[2]), m[4]))
            elif word == 'enum':
                m = re.fullmatch(r'(\w+) (\w+) (\w+): (.*)', rest)
                rows.append(Row('enum', m[1], m[2], header, Type.read(m[3]), values=m[4].split()))
            elif word == 'struct':
                m = re.fullmatch(r'(\w+) (\w+(?:<[^>]*>)?)((?: \w+)*)', rest)
                rows.append(Row('struct', m[1], m[2], header, flags=tuple(m[3].split())))
            elif word == 'opaque':
                rows.append(Row('opaque', rest.split()[0], rest.split()[1], header))
            elif word == 'fn':
                rows.append(read_function(rest, header))
            elif word == 'no':
                rows.append(Row('no', rest.partition(':')[0], rest.partition(':')[0], header, value=rest.partition(': ')[2]))
            else:
                raise Wrong('no such row')
        except (Wrong, TypeError, IndexError) as wrong:
            raise SystemExit(f'api.txt: line {number}: {line.strip()}: {wrong}')
        if rows and any(r.kind == rows[-1].kind and r.name == rows[-1].name for r in rows[:-1]):
            raise SystemExit(f'api.txt: line {number}: {rows[-1].name}: is there already')
    return rows


def comment_above(lines, at):
    """The comment that ends above line `at`, beyond declarations that follow it without a blank line."""
    is_comment = lambda i: i >= 0 and lines[i].lstrip().startswith('//')
    i = at - 1
    while i >= 0 and lines[i].strip() and not is_comment(i) and not lines[i].rstrip().endswith(('{', ':')):
        i -= 1
    out = []
    while is_comment(i):
        out.insert(0, re.sub(r'^\s*// ?', '', lines[i]).rstrip())
        i -= 1
    return out


def trailing_comment(line):
    code, slashes, comment = line.partition('//')
    return code, [comment.strip()] if slashes else []


def body_docs(lines, at, names):
    """What stands beside or above each name in the braces that begin at line `at`."""
    docs, above, last, left = {}, [], None, list(names)
    if '}' in lines[at]:
        return docs
    for line in lines[at + 1:]:
        if re.match(r'(  )?}', line):
            break
        indent = len(line) - len(line.lstrip())
        if line.lstrip().startswith('//'):
            text = re.sub(r'^\s*// ?', '', line).rstrip()
            if indent > 2 and last is not None:
                docs[last].append(text)
            else:
                above.append(text)
            continue
        code, beside = trailing_comment(line)
        declared = re.sub(r'=[^,;]*', '', re.sub(r'\{[^}]*\}', '', code))
        found = [n for n in left if re.search(rf'\b{n}\b', declared)]
        for n in found:
            docs[n] = []
            left.remove(n)
        if found:
            last = found[0]
            docs[last] = above + beside
            above = []
        elif last is not None and beside:
            docs[last] += beside
    return docs


def expect_all_fields(row, lines, at, known):
    """A field that only fills what was padding would change no size: so names are compared, too."""
    for line in lines[at + 1:]:
        if re.match(r'};', line):
            return
        code = trailing_comment(line)[0].strip()
        if code.startswith(('return', 'friend', 'using', 'static_assert')) or '(' in code.split('=')[0]:
            continue
        code = re.sub(r'=[^,;]*', '', re.sub(r'\{[^}]*\}', '', code))
        for name in re.findall(r'([A-Za-z_]\w*)(?:\[[^\]]*\])*\s*(?=[,;])', re.sub(r'<[^>]*>', '', code)):
            if name not in known:
                raise SystemExit(f'{row.header}: {row.cpp}::{name} is not in api.txt')


def add_docs(rows, read_header):
    seen = {}
    for row in rows:
        if row.kind == 'no' or not row.header:
            continue
        lines = read_header(row.header)
        pattern = {
            'const': rf'inline constexpr .*\b{row.cpp}\b|.*\b{row.cpp} = ',
            'enum': rf'enum class (\[\[.*?\]\] )?{row.cpp}\b',
            'struct': rf'(struct|class) ((alignas\(\d+\)|[A-Z_]+) )*{re.escape(row.cpp)} \{{',
            'opaque': rf'struct {row.cpp};',
            'fn': rf'  (?!return|if|for)[\w:&*<> ]+[ *&]{row.cpp}\(' if row.method else rf'[a-zA-Z][\w:&*<> ]*[ *&]{row.cpp}\(',
        }[row.kind]
        places = [i for i, line in enumerate(lines) if re.match(pattern, line)]
        if not places:
            if row.is_member or row.cpp.startswith('Span<') or row.cpp.endswith('Bounds'):
                continue
            raise SystemExit(f'{row.header}: {row.cpp} is in api.txt, but not declared')
        key = (row.header, row.cpp, row.kind)
        at = places[min(seen.get(key, 0), len(places) - 1)]
        seen[key] = seen.get(key, 0) + 1
        row.doc = comment_above(lines, at)
        if row.kind == 'const':
            row.doc += trailing_comment(lines[at])[1]
        if row.kind == 'enum':
            row.docs = body_docs(lines, at, row.values)
        if row.kind == 'struct' and 'private' not in row.flags:
            names = [name for name, _ in row.fields]
            row.docs = body_docs(lines, at, names)
            expect_all_fields(row, lines, at, names + [r.cpp for r in rows if r.is_member and r.method == row.name])
