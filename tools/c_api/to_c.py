"""marrow/c.h, for programs in C99 and C++."""
from names import camel, comment, constant, count_of, enumerator, wrapped

C_NAMES = {'f32': 'float', 'f64': 'double', 'size': 'size_t', 'bool': 'bool', 'byte': 'void', 'void': 'void',
           'text': 'const char*', 'code': 'void (*', 'call_error_handler': 'mrw_call_error_handler'}


def c_name(name):
    if name in C_NAMES:
        return C_NAMES[name]
    if name[0] in 'iu' and name[1:].isdigit():
        return ('int' if name[0] == 'i' else 'uint') + name[1:] + '_t'
    return 'mrw_' + name


def member(name, t):
    """A member of a struct, or two."""
    base = c_name(t.name)
    if t.name == 'code':
        return [f'void (*{name})(void)']
    if t.form in ('*', '[]'):
        pointer = f'{"" if t.mut else "const "}{base}* {name}'
        return [pointer] + ([f'size_t {count_of(name, t)}'] if t.form == '[]' else [])
    return [f'{base} {name}' + ''.join(f'[{n}]' for n in t.dims)]


def parameters(row, structs):
    out = []
    for name, t in row.fields:
        base, const = c_name(t.name), '' if t.mut else 'const '
        if t.form == '[]':
            out += [f'{const}{base}* {name}', f'size_t {count_of(name, t)}']
        elif t.form == '*':
            out.append(f'{const}{base}* {name}')
        elif t.form == 'array':
            out.append(f'{const}{base} {name}[{t.dims[0]}]')
        elif t.name in structs or t.mut:
            out.append(f'{const}{base}* {name}')
        else:
            out.append(f'{base} {name}')
    if row.type and not row.type.form and row.type.name in structs:
        out.append(f'{c_name(row.type.name)}* out')
    return out


def returned(row, structs):
    t = row.type
    if t is None:
        return 'void'
    if t.form == '*':
        return f'{"" if t.mut else "const "}{c_name(t.name)}*'
    return 'mrw_status' if t.name in structs else c_name(t.name)


def prototype(row, structs, last=';'):
    result = returned(row, structs)
    return wrapped(f'{result} mrw_{row.name}(', parameters(row, structs) or ['void'], ')' + last)


OPENING = '''// The whole runtime for C99, and for all languages that call C: see docs/c.md. Library marrow::c.
//
// Made by tools/c_api from runtime/c/api.txt and the C++ headers, whose words these are: do not edit. Where they name a
// C++ function or type, here it is mrw_ and that name in small letters; a Span is a pointer and a count, a null pointer
// with a count of 0 is empty. What is "empty by default" or "may be null" there may be null here.
//
// A struct that is filled in begins with its mrw_…_init(), which sets what C++ has by default. Memory is the caller's,
// and nothing is to be freed. A pointer that is null or off the boundary of its type makes a call return
// MRW_BAD_ARGUMENT, and what returns no status 0, false or null; the handler of mrw_set_call_error_handler() is told
// why.
#ifndef MARROW_C_H
#define MARROW_C_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// clang-format off
#if defined(__GNUC__)
#define MRW_ALIGN(bytes) __attribute__((aligned(bytes)))
#define MRW_NODISCARD __attribute__((warn_unused_result))
#elif defined(_MSC_VER)
#define MRW_ALIGN(bytes) __declspec(align(bytes))
#define MRW_NODISCARD
#endif

#ifdef __cplusplus
extern "C" {
#endif

// A number that all rows of the description give: it changes with every struct, enum, constant and function.
#define MRW_ABI 0x%08xu
// That of the library. A program compares it with its own MRW_ABI before it calls anything else.
uint32_t mrw_abi(void);
'''


def struct_text(row):
    align = f' MRW_ALIGN({row.boundary()})' if row.boundary() > 1 else ''
    out = [f'struct{align} mrw_{row.name} {{']
    for name, t in row.fields:
        doc = row.docs.get(name, [])
        members = ['  ' + m + ';' for m in member(name, t)]
        if len(doc) == 1 and len(members[0] + doc[0]) < 115:
            members[0] += '  // ' + doc[0]
        else:
            out += comment(doc, indent='  ')
        out += members
    return out + ['};']


def enum_text(row):
    out = [f'typedef {c_name(row.type.name)} mrw_{row.name};', 'enum {']
    for i, value in enumerate(row.values):
        line = f'  {enumerator(row, value)} = {i},'
        doc = row.docs.get(value, [])
        if len(doc) == 1 and len(line + doc[0]) < 115:
            line += '  // ' + doc[0]
        else:
            out += comment(doc, indent='  ')
        out.append(line)
    return out + ['};']


def constant_text(row):
    value = row.value if '.' in row.value or 'e' in row.value else row.value + ('' if row.type.name == 'i32' else 'u')
    value = f'({value})' if ' ' in value else value
    return [f'#define {constant(row.name)} {value}']


def row_text(row, structs):
    if row.kind == 'const':
        return constant_text(row)
    if row.kind == 'enum':
        return enum_text(row)
    if row.kind == 'opaque':
        return [f'typedef struct mrw_{row.name} mrw_{row.name};']
    if row.kind == 'struct':
        return [f'typedef struct mrw_{row.name} mrw_{row.name};'] + struct_text(row)
    mark = ' MRW_NODISCARD' if returned(row, structs) == 'mrw_status' else ''
    return prototype(row, structs, mark + ';').split('\n')


def header(rows, abi, headings):
    structs = {r.name for r in rows if r.kind == 'struct'}
    out, last, last_doc = [OPENING % abi], '', []
    for row in rows:
        if row.kind == 'no':
            continue
        if row.header != last:
            out += ['', '// ' + '-' * 117] + comment(headings[row.header])
            last = row.header
        if row.doc != last_doc or not row.doc:
            out += [''] + comment(row.doc)
        last_doc = row.doc
        out += row_text(row, structs)
        if row.cpp == 'set_call_error_handler':
            out.insert(-2 - len(comment(row.doc)),
                       '\ntypedef void (*mrw_call_error_handler)(const char* function, const char* condition);')
        if 'init' in row.flags:
            out.append(f'void mrw_{row.name}_init(mrw_{row.name}* out);')
    out += ['', '#ifdef __cplusplus', '}', '#endif', '#endif']
    return '\n'.join(out) + '\n'
