"""Reads runtime/c/api.txt, which says what it may hold, and others like it."""
import re
from dataclasses import dataclass, field

SCALARS = {  # name: (bytes, C++ type)
    'f32': (4, 'float'), 'f64': (8, 'double'), 'bool': (1, 'bool'), 'byte': (1, 'std::byte'),
    'u8': (1, 'std::uint8_t'), 'u16': (2, 'std::uint16_t'), 'u32': (4, 'std::uint32_t'), 'u64': (8, 'std::uint64_t'),
    'i8': (1, 'std::int8_t'), 'i16': (2, 'std::int16_t'), 'i32': (4, 'std::int32_t'), 'size': (None, 'std::size_t'),
    'char': (1, 'char'),
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
    is_reference: bool = False  # in C++; a pointer in C
    is_callback: bool = False

    @staticmethod
    def read(text):
        m = re.fullmatch(r'(\w+)( mut)?(\*|&|\[\]|(?:\[\d+\])+)?(\?)?', text.strip())
        if not m:
            raise Wrong(f'{text}: not a type')
        form = m[3] or ''
        dims = tuple(int(n) for n in re.findall(r'\d+', form))
        return Type(m[1], bool(m[2]), 'array' if dims else form.replace('&', '*'), dims, bool(m[4]), form == '&')


@dataclass
class Row:
    """A constant, enum, struct, callback, opaque or function; what it does not use is empty."""
    kind: str
    name: str
    cpp: str
    header: str
    type: object = None
    value: str = ''
    values: list = field(default_factory=list)  # of an enum
    fields: list = field(default_factory=list)  # of a struct, or a function's parameters: (name, Type)
    known: dict = field(default_factory=dict)  # types of fields that the header does not tell
    flags: tuple = ()
    method: str = ''  # of which type a function is a member
    is_member: bool = False  # a data member, not a function
    source: str = ''  # where the wrapper stands
    namespace: str = ''
    doc: list = field(default_factory=list)
    beside: list = field(default_factory=list)  # documents of a constant's line
    docs: dict = field(default_factory=dict)  # of fields and enumerators

    def qualified(self):
        return f'{self.namespace}::{self.cpp}' if self.namespace else self.cpp

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
               method=m[1] or '', is_member=m[3] is None, source=m[7] or '')


def read_callback(text, header):
    m = re.fullmatch(r'(\w+)\((.*)\) -> (.*)', text)
    return Row('callback', m[1], m[1], header, Type.read(m[3]) if m[3] != 'void' else None, fields=read_parameters(m[2]))


def read_struct(rest, header):
    m = re.fullmatch(r'(\w+) (\w+(?:<[^>]*>)?)((?: \w+)*)', rest)
    return Row('struct', m[1], m[2], header, flags=tuple(m[3].split()))


def read_constant(rest, header):
    m = re.fullmatch(r'(\w+) (\w+) (\w+)(?: = (.*))?', rest)
    return Row('const', m[1], m[3], header, Type.read(m[2]), m[4] or '')


def read_enum(rest, header):
    m = re.fullmatch(r'(\w+) (\w+) (\w+)(?:: (.*))?', rest)
    return Row('enum', m[1], m[2], header, Type.read(m[3]), values=(m[4] or '').split())


def read_opaque(rest, header):
    return Row('opaque', rest.split()[0], rest.split()[1], header)


def read_no(rest, header):
    name, _, why = rest.partition(': ')
    return Row('no', name, name, header, value=why)


READERS = {'const': read_constant, 'enum': read_enum, 'struct': read_struct, 'callback': read_callback,
           'opaque': read_opaque, 'fn': read_function, 'no': read_no}


def read_field(row, name, text, read_header):
    if text.startswith('= '):
        row.known[name] = Type.read(text[2:])
        return
    def each(m):
        return f'[{int(m[1]) * count_each(read_header(m[2]))}]'
    row.fields.append((name, Type.read(re.sub(r'\[(\d+) each of (\S+)\]', each, text))))


def count_each(lines):
    return sum(len(re.findall(r'\bX\(', line)) for line in lines if not line.startswith('//'))



def resolve(rows, above):
    """Names of types: of the same namespace first."""
    here = {r.name for r in rows}
    callbacks = {r.name for r in rows + above if r.kind == 'callback'}
    for row in rows:
        for t in [row.type] + [t for _, t in row.fields] + list(row.known.values()):
            if t is None:
                continue
            within = f'{row.namespace}_{t.name}'
            t.name = within if row.namespace and within in here else t.name
            t.is_callback = t.name in callbacks
        if row.method and row.namespace:
            row.method = f'{row.namespace}_{row.method}'


def read_rows(file, above, source, read_header):
    """The rows of a description; `above`: those that it may name, `source`: where wrappers stand unless they say so."""
    rows, header, namespace = [], '', ''
    for number, line in enumerate(file.read_text().splitlines(), 1):
        if not line.strip() or line.startswith('#'):
            continue
        word, _, rest = line.strip().partition(' ')
        try:
            if line.startswith('  '):
                read_field(rows[-1], word, rest, read_header)
            elif word == 'header':
                header = rest
            elif word == 'namespace':
                namespace = rest
            elif word in READERS:
                rows.append(READERS[word](rest, header))
                rows[-1].namespace = namespace
                rows[-1].source = rows[-1].source or source
                if namespace and word != 'no':
                    rows[-1].name = f'{namespace}_{rows[-1].name}'
            else:
                raise Wrong('no such row')
        except (Wrong, TypeError, IndexError) as wrong:
            raise SystemExit(f'{file.name}: line {number}: {line.strip()}: {wrong}')
        if rows and any(r.kind == rows[-1].kind and r.name == rows[-1].name for r in rows[:-1]):
            raise SystemExit(f'{file.name}: line {number}: {rows[-1].name}: is there already')
    resolve(rows, above)
    return rows
