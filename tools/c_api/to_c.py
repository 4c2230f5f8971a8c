"""marrow/c.h, for programs in C99 and C++."""
from names import camel, comment, constant, count_of, enumerator, wrapped

C_NAMES = {'f32': 'float', 'f64': 'double', 'size': 'size_t', 'bool': 'bool', 'byte': 'void', 'void': 'void',
           'char': 'char', 'text': 'const char*'}


def c_name(name):
    if name in C_NAMES:
        return C_NAMES[name]
    if name[0] in 'iu' and name[1:].isdigit():
        return ('int' if name[0] == 'i' else 'uint') + name[1:] + '_t'
    return 'mrw_' + name


def pointed(t):
    """What a pointer leads to."""
    base = c_name(t.name)
    return base if t.mut else f'{base} const' if base.endswith('*') else f'const {base}'


def member(name, t):
    """A member of a struct, or two."""
    if t.name == 'code':
        return [f'void (*{name})(void)']
    if t.form in ('*', '[]'):
        return [f'{pointed(t)}* {name}'] + ([f'size_t {count_of(name, t)}'] if t.form == '[]' else [])
    return [f'{c_name(t.name)} {name}' + ''.join(f'[{n}]' for n in t.dims)]


def parameters(row, structs):
    out = []
    for name, t in row.fields:
        if t.form == '[]':
            out += [f'{pointed(t)}* {name}', f'size_t {count_of(name, t)}']
        elif t.form == 'array':
            out.append(f'{pointed(t)} {name}[{t.dims[0]}]')
        elif t.form == '*' or t.name in structs or t.mut:
            out.append(f'{pointed(t)}* {name}')
        else:
            out.append(f'{c_name(t.name)} {name}')
    if row.type and not row.type.form and row.type.name in structs:
        out.append(f'{c_name(row.type.name)}* out')
    return out


def returned(row, structs):
    t = row.type
    if t is None:
        return 'void'
    if t.form == '*':
        return f'{pointed(t)}*'
    return 'mrw_status' if t.name in structs else c_name(t.name)


def prototype(row, structs, last=';'):
    result = returned(row, structs)
    return wrapped(f'{result} mrw_{row.name}(', parameters(row, structs) or ['void'], ')' + last)


OPENING = '''// The whole runtime for C99, and for all languages that call C: see docs/c.md. Library marrow::c.
//
// Made by tools/c_api from runtime/c/api.txt and the C++ headers: do not edit. A list is a pointer and a count; a null
// pointer with a count of 0 is empty. What is said to be empty by default, or that it may be, may be null.
//
// A struct that is filled in begins with its mrw_…_init(), which sets defaults. Memory is the caller's, and nothing is
// to be freed. A pointer that is null or off the boundary of its type makes a call return MRW_BAD_ARGUMENT, and what
// returns no status 0, false or null; the handler of mrw_set_call_error_handler() is told why.
#ifndef MARROW_C_H
#define MARROW_C_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define MRW_ALIGN(bytes) __attribute__((aligned(bytes)))
#define MRW_NODISCARD __attribute__((warn_unused_result))
#elif defined(_MSC_VER)
#define MRW_ALIGN(bytes) __declspec(align(bytes))
#define MRW_NODISCARD
#endif

'''

OPENING_OF_GLES3 = '''// Skinning by OpenGL ES 3.0 for C99, and for all languages that call C: see docs/c.md. Library marrow::c_gles3.
//
// Made by tools/c_api from runtime/c/gles3.txt and the C++ headers: do not edit. Lists, structs that are filled in, and
// what may be null are as marrow/c.h says.
//
// A pointer that is null or off the boundary of its type is refused, and so is an mrw_gles3_api full of zeros, which
// mrw_gles3_load_api() has not filled yet.
#ifndef MARROW_C_GLES3_H
#define MARROW_C_GLES3_H

#include "marrow/c.h"

'''

ABI = '''
// A number that all rows of the description give: it changes with every struct, enum, constant and function.
#define MRW_%(NAME)sABI 0x%(abi)08xu
// That of the library. A program compares it with its own MRW_%(NAME)sABI before it calls anything else.
uint32_t mrw_%(name)sabi(void);
'''


def struct_text(row, words):
    align = f' MRW_ALIGN({row.boundary()})' if row.boundary() > 1 else ''
    out = [f'struct{align} mrw_{row.name} {{']
    for name, t in row.fields:
        doc = words.comment(row.docs.get(name, []), row.header, row, 115)
        members = ['  ' + m + ';' for m in member(name, t)]
        if len(doc) == 1 and len(members[0] + doc[0]) < 115:
            members[0] += '  // ' + doc[0]
        else:
            out += comment(doc, indent='  ')
        out += members
    return out + ['};']


def enum_text(row, words):
    out = [f'typedef {c_name(row.type.name)} mrw_{row.name};', 'enum {']
    for i, value in enumerate(row.values):
        line = f'  {enumerator(row, value)} = {i},'
        doc = words.comment(row.docs.get(value, []), row.header, row, 115)
        if len(doc) == 1 and len(line + doc[0]) < 115:
            line += '  // ' + doc[0]
        else:
            out += comment(doc, indent='  ')
        out.append(line)
    return out + ['};']


def constant_text(row, words):
    value = row.value if '.' in row.value or 'e' in row.value else row.value + ('' if row.type.name == 'i32' else 'u')
    value = f'({value})' if ' ' in value else value
    line, beside = f'#define {constant(row.name)} {value}', words.comment(row.beside, row.header)
    return [f'{line}  // {beside[0]}'] if len(beside) == 1 and len(line + beside[0]) < 115 else comment(beside) + [line]


def row_text(row, structs, words):
    if row.kind == 'const':
        return constant_text(row, words)
    if row.kind == 'enum':
        return enum_text(row, words)
    if row.kind == 'callback':
        return wrapped(f'typedef {returned(row, structs)} (*mrw_{row.name})(', parameters(row, structs) or ['void'],
                       ');').split('\n')
    if row.kind == 'opaque':
        return [f'typedef struct mrw_{row.name} mrw_{row.name};']
    if row.kind == 'struct':
        return [f'typedef struct mrw_{row.name} mrw_{row.name};'] + struct_text(row, words)
    mark = ' MRW_NODISCARD' if returned(row, structs) == 'mrw_status' else ''
    return prototype(row, structs, mark + ';').split('\n')


def header(part, structs, headings, words):
    opening = OPENING_OF_GLES3 if part.prefix else OPENING
    out, last, last_doc = [opening + '// clang-format off\n#ifdef __cplusplus\nextern "C" {\n#endif\n' + ABI % {
        'name': part.prefix, 'NAME': part.prefix.upper(), 'abi': part.abi}], '', []
    for row in part.rows:
        if row.kind == 'no':
            continue
        if row.header != last:
            out += ['', f'// ---- Part {row.header[:-2]} '.ljust(120, '-')] + comment(words.comment(headings[row.header], row.header))
            last = row.header
        if row.doc != last_doc or not row.doc:
            out += [''] + comment(words.comment(row.doc, row.header, row))
        last_doc = row.doc
        out += row_text(row, structs, words)
        if 'init' in row.flags:
            out.append(f'void mrw_{row.name}_init(mrw_{row.name}* out);')
    out += ['', '#ifdef __cplusplus', '}', '#endif', '#endif']
    return '\n'.join(out) + '\n'
