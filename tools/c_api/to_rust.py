"""marrow.rs: extern "C" functions and #[repr(C)] structs."""
import re

from layout import Layout
from names import camel, comment, count_of
from to_cpp import MADE

KEYWORDS = {'as', 'box', 'const', 'fn', 'impl', 'in', 'let', 'loop', 'match', 'mod', 'move', 'mut', 'pub', 'ref', 'trait', 'type',
            'use', 'where', 'yield'}
NAMES = {'size': 'usize', 'byte': 'c_void', 'void': 'c_void', 'text': '*const c_char',
         'char': 'c_char', 'code': 'Option<unsafe extern "C" fn()>'}


def safe(name):
    return 'r#' + name if name in KEYWORDS else name


def type_name(name):
    if name in NAMES:
        return NAMES[name]
    return name if re.fullmatch(r'[fiu]\d+|bool', name) else camel(name)


def members(name, t):
    base = type_name(t.name)
    if t.form in ('*', '[]'):
        out = [f'{safe(name)}: *{"mut" if t.mut else "const"} {base}']
        return out + ([f'{count_of(name, t)}: usize'] if t.form == '[]' else [])
    for n in reversed(t.dims):
        base = f'[{base}; {n}]'
    return [f'{safe(name)}: {base}']


def parameters(row, structs):
    out = []
    for name, t in row.fields:
        pointer = f'*{"mut" if t.mut else "const"} '
        if t.form in ('*', '[]'):
            out += members(name, t)
        elif t.form == 'array':
            out.append(f'{safe(name)}: {pointer}[{type_name(t.name)}; {t.dims[0]}]')
        elif t.name in structs or t.mut:
            out.append(f'{safe(name)}: {pointer}{type_name(t.name)}')
        else:
            out.append(f'{safe(name)}: {type_name(t.name)}')
    if row.type and not row.type.form and row.type.name in structs:
        out.append(f'out: *mut {type_name(row.type.name)}')
    return out


def returned(row, structs):
    t = row.type
    if t is None:
        return ''
    if t.form == '*':
        return f' -> *{"mut" if t.mut else "const"} {type_name(t.name)}'
    return ' -> ' + ('Status' if t.name in structs else type_name(t.name))


def docs(lines, indent=''):
    return comment(lines, '///', indent)


def enum_text(row):
    mark = ['#[must_use]'] if row.name == 'status' else []
    out = docs(row.doc) + ['#[repr(transparent)]', '#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]'] + mark
    out += [f'pub struct {camel(row.name)}(pub {row.type.name});', f'impl {camel(row.name)} {{']
    for i, value in enumerate(row.values):
        out += docs(row.docs.get(value, []), '    ') + [f'    pub const {value.upper()}: Self = Self({i});']
    return out + ['}']


def struct_text(row, layout):
    name = camel(row.name)
    out = docs(row.doc) + [f'#[repr(C{f", align({row.boundary()})" if row.boundary() > 1 else ""})]', '#[derive(Clone, Copy)]',
                           f'pub struct {name} {{']
    for field, t in row.fields:
        out += docs(row.docs.get(field, []), '    ')
        out += [f'    pub {m},' for m in members(field, t)]
    out += ['}', f'impl Default for {name} {{', '    fn default() -> Self {']
    if 'init' in row.flags:
        out += ['        unsafe {', '            let mut new: Self = std::mem::zeroed();',
                f'            {row.name}_init(&mut new);', '            new', '        }']
    else:
        out.append('        unsafe { std::mem::zeroed() }')
    return out + ['    }', '}', '#[cfg(target_pointer_width = "64")]',
                  f'const _: () = assert!(std::mem::size_of::<{name}>() == {layout.of(row.name)[0]});']


def constant_text(row):
    value = re.sub(r'(?<=\d)f\b', '', row.value)
    if row.type.name == 'f32':
        value = re.sub(r'\b60\b', '60.0', value)
    return docs(row.doc + row.beside) + [f'pub const {row.name.upper()}: {type_name(row.type.name)} = {value};']


def made(rows, parts):
    structs, layout = {r.name for r in rows if r.kind == 'struct'}, Layout(rows, 8)
    out = [MADE + '// The runtime for Rust, as C has it: see docs/c.md. Link marrow_c, marrow_unpack and marrow_runtime.',
           '#![allow(dead_code, clippy::all)]', 'use std::os::raw::{c_char, c_void};', '',
           *[f'/// What {p.prefix}abi() must give.\npub const {p.prefix.upper()}ABI: u32 = 0x{p.abi:08x};' for p in parts], '']
    for row in rows:
        if row.kind == 'callback':
            out += docs(row.doc) + [f'pub type {camel(row.name)} = Option<unsafe extern "C" fn('
                                    f'{", ".join(parameters(row, structs))}){returned(row, structs)}>;', '']
        if row.kind == 'const':
            out += constant_text(row) + ['']
        if row.kind == 'enum':
            out += enum_text(row) + ['']
        if row.kind == 'struct':
            out += struct_text(row, layout) + ['']
        if row.kind == 'opaque':
            out += ['#[repr(C)]', f'pub struct {camel(row.name)} {{', '    _private: [u8; 0],', '}', '']
    out.append('extern "C" {')
    for part in parts:
        out += [f'    #[link_name = "mrw_{part.prefix}abi"]', f'    pub fn {part.prefix}abi() -> u32;']
    for row in rows:
        if row.kind == 'struct' and 'init' in row.flags:
            out += [f'    #[link_name = "mrw_{row.name}_init"]',
                    f'    pub fn {row.name}_init(out: *mut {camel(row.name)});']
        if row.kind == 'fn':
            out += docs(row.doc, '    ') + [f'    #[link_name = "mrw_{row.name}"]']
            out.append(f'    pub fn {row.name}({", ".join(parameters(row, structs))}){returned(row, structs)};')
    return '\n'.join(out + ['}', ''])
