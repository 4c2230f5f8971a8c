"""Marrow.cs: [DllImport] functions and sequential structs, for 64-bit and 32-bit processes."""
import re
from xml.sax.saxutils import escape

from layout import Layout
from names import camel, count_of
from to_cpp import MADE

NAMES = {'f32': 'float', 'f64': 'double', 'u8': 'byte', 'u16': 'ushort', 'u32': 'uint', 'u64': 'ulong', 'i8': 'sbyte',
         'i16': 'short', 'i32': 'int', 'size': 'UIntPtr', 'byte': 'void', 'void': 'void', 'bool': 'byte',
         'char': 'byte', 'text': 'byte*', 'code': 'IntPtr'}
# Where all that a game has is one file.
LIBRARY = ['#if (UNITY_IOS || UNITY_TVOS || UNITY_VISIONOS || UNITY_WEBGL) && !UNITY_EDITOR',
           '    /// <summary>What all functions here are imported from: the program itself.</summary>',
           '    public const string Library = "__Internal";', '#else',
           '    /// <summary>What all functions here are imported from: libmarrow_c.so, marrow_c.dll, …</summary>',
           '    public const string Library = "marrow_c";', '#endif']
KEYWORDS = {'in', 'out', 'params', 'ref', 'fixed', 'object', 'base', 'lock', 'is', 'as', 'event', 'checked'}


def safe(name):
    return '@' + name if name in KEYWORDS else name


def type_name(name):
    return NAMES.get(name) or camel(name)


def type_of(t):
    return 'IntPtr' if t.is_callback else type_name(t.name)


def members(name, t):
    base = type_of(t)
    if t.form in ('*', '[]'):
        return [f'{base}* {safe(name)}'] + ([f'UIntPtr {count_of(name, t)}'] if t.form == '[]' else [])
    if t.dims and t.name in NAMES:
        count = 1
        for n in t.dims:
            count *= n
        # C# takes no fixed number of UIntPtr. Where pointers have 4 bytes there is then too much room, which harms none.
        return [f'fixed {"ulong" if t.name == "size" else base} {safe(name)}[{count}]']
    if t.dims:
        return [f'{base} {safe(name)}{i}' for i in range(t.dims[0])]
    return [f'{base} {safe(name)}']


def parameters(row, structs):
    out = []
    for name, t in row.fields:
        if t.form in ('*', '[]'):
            out += members(name, t)
        elif t.form == 'array' or t.name in structs or t.mut:
            out.append(f'{type_name(t.name)}* {safe(name)}')
        else:
            out.append(f'{type_of(t)} {safe(name)}')
    if row.type and not row.type.form and row.type.name in structs:
        out.append(f'{type_name(row.type.name)}* @out')
    return out


def returned(row, structs):
    t = row.type
    if t is None:
        return 'void'
    if t.form == '*':
        return type_name(t.name) + '*'
    return 'Status' if t.name in structs else type_of(t)


def docs(lines, indent):
    if not lines:
        return []
    return [f'{indent}/// <summary>'] + [f'{indent}/// {escape(line)}'.rstrip() for line in lines] + [f'{indent}/// </summary>']


def enum_text(row):
    out = docs(row.doc, '') + [f'public enum {camel(row.name)} : {type_name(row.type.name)} {{']
    for i, value in enumerate(row.values):
        out += docs(row.docs.get(value, []), '    ') + [f'    {camel(value)} = {i},']
    return out + ['}', '']


def end_of(row, index, layout):
    """Where a member ends that C# lays out behind the one before it, without boundaries of 16 bytes."""
    size, _ = layout.of_type(row.fields[index][1])
    return layout.of(row.name)[2][index] + size + (layout.pointer if row.fields[index][1].form == '[]' else 0)


def many(name, t, layout):
    """More structs than anyone wants to name one by one: their words."""
    if not t.dims or t.dims[0] <= 16 or t.name not in layout.structs:
        return []
    size, align = layout.of_type(t)
    return [f'fixed {"uint" if align == 4 else "ulong"} {safe(name)}[{size // align}]']


def callback_text(row, structs):
    return docs(row.doc, '') + ['[UnmanagedFunctionPointer(CallingConvention.Cdecl)]',
                                f'public unsafe delegate {returned(row, structs)} {camel(row.name)}('
                                f'{", ".join(parameters(row, structs))});', '']


def struct_text(row, layout, narrow):
    size = layout.of(row.name)[0]
    # Padding inside is the same with pointers of 4 bytes; behind the last member there may then be some too much.
    out = docs(row.doc, '') + [f'[StructLayout(LayoutKind.Sequential, Size = {size})]' if 'align16' in row.flags or
                               layout.of(row.name)[1] == 16 and not has_pointers(row, layout)
                               else '[StructLayout(LayoutKind.Sequential)]',
                               f'public unsafe struct {camel(row.name)} {{']
    for i, (field, t) in enumerate(row.fields):
        if i > 0 and layout.of_type(t)[1] == 16:
            gap = layout.of(row.name)[2][i] - end_of(row, i - 1, layout)
            if gap != narrow.of(row.name)[2][i] - end_of(row, i - 1, narrow):
                raise SystemExit(f'{row.name}.{field}: C# cannot lay it out')
            if gap:
                out.append(f'    fixed byte padding{i}[{gap}];')
        out += docs(row.docs.get(field, []), '    ')
        out += [f'    public {m};' for m in many(field, t, layout) or members(field, t)]
    if layout.of(row.name)[1] == 16 and has_pointers(row, layout):
        out.append(f'    fixed byte padding[{size - end_of(row, len(row.fields) - 1, layout)}];')
    if 'init' in row.flags:
        name = camel(row.name)
        out.append(f'    public static {name} New() {{')
        if layout.of(row.name)[1] == 16:  # C# puts it anywhere
            out += [f'        byte* room = stackalloc byte[{size + 16}];',
                    f'        {name}* made = ({name}*)(((ulong)room + 15) / 16 * 16);',
                    f'        Marrow.{name}Init(made);', '        return *made;', '    }']
        else:
            out += [f'        {name} made;', f'        Marrow.{name}Init(&made);', '        return made;', '    }']
    return out + ['}', '']


def has_pointers(row, layout):
    return any(t.form in ('*', '[]') or t.name in ('text', 'size', 'code') for _, t in row.fields)


def structs_in_order(rows):
    return [r.name for r in rows if r.kind == 'struct']


def constant(row):
    if row.type.name == 'f32':
        return f'    public const float {camel(row.name)} = {row.value};'
    name = {'size': 'int'}.get(row.type.name, type_name(row.type.name))
    return f'    public const {name} {camel(row.name)} = {row.value};'


def import_text(name, result, params):
    return [f'    [DllImport(Library, EntryPoint = "mrw_{name}", CallingConvention = CallingConvention.Cdecl)]',
            f'    public static extern {result} {camel(name)}({", ".join(params)});']


def made(rows, parts):
    structs = {r.name for r in rows if r.kind == 'struct'}
    wide, narrow = Layout(rows, 8), Layout(rows, 4)
    out = [MADE + '// The runtime for C#, as C has it: see docs/c.md. bool is a byte here, so that all structs are blittable. '
           'New() makes a\n// struct as C++ has it by default. Structs that C++ puts on 16 bytes go into memory of '
           'Marrow.Block().',
           'using System;', 'using System.Runtime.InteropServices;', '', 'namespace MarrowRuntime {', '']
    for row in rows:
        if row.kind == 'callback':
            out += callback_text(row, structs)
        if row.kind == 'enum':
            out += enum_text(row)
        if row.kind == 'struct':
            out += struct_text(row, wide, narrow)
        if row.kind == 'opaque':
            out += [f'public struct {camel(row.name)} {{}}', '']
    out += ['public static unsafe class Marrow {', *LIBRARY, '',
            *[line for p in parts for line in (
                f'    /// <summary>What {camel(p.prefix + "abi")}() must give.</summary>',
                f'    public const uint {camel(p.prefix + "abi")}Number = 0x{p.abi:08x};')], '']
    out += [line for r in rows if r.kind == 'const' for line in docs(r.doc + r.beside, '    ') + [constant(r)]]
    for part in parts:
        out += import_text(part.prefix + 'abi', 'uint', [])
    for row in rows:
        if row.kind == 'struct' and 'init' in row.flags:
            out += import_text(row.name + '_init', 'void', [f'{camel(row.name)}* @out'])
        if row.kind == 'fn':
            out += docs(row.doc, '    ') + import_text(row.name, returned(row, structs), parameters(row, structs))
    sizes = [f'sizeof({camel(n)}) == {wide.of(n)[0]}' for n in structs_in_order(rows)]
    out += ['', '    /// <summary>Whether structs are laid out as those of a library of 64 bits.</summary>',
            '    public static bool IsLaidOut() {', '        return ' + ' &&\n            '.join(sizes) + ';', '    }']
    out += ['', '    /// <summary>Bytes on a boundary of 16, which are to be freed by FreeBlock().</summary>',
            '    public static void* Block(ulong bytes) {',
            '        byte* all = (byte*)Marshal.AllocHGlobal(new IntPtr((long)bytes + 32));',
            '        byte* first = (byte*)(((ulong)all + 31) / 16 * 16);', '        ((void**)first)[-1] = all;',
            '        return first;', '    }',
            '    public static void FreeBlock(void* first) {',
            '        Marshal.FreeHGlobal((IntPtr)((void**)first)[-1]);', '    }',
            '    /// <summary>A text of the runtime.</summary>',
            '    public static string Text(byte* text) {', '        int length = 0;',
            '        while (text[length] != 0) ++length;',
            '        return System.Text.Encoding.UTF8.GetString(text, length);', '    }', '}', '', '}']
    return '\n'.join(out) + '\n'
