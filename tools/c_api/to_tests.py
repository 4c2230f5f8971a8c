"""A row of each function of C, called with whatever a test thinks of, and of each struct that C++ may fill in by name:
tests/c/bad_calls.c and tests/unit/designated_test.cpp."""
from names import count_of
from to_c import returned
from to_cpp import MADE


def arguments(row, structs, enums, ready):
    out = []
    for i, (name, t) in enumerate(row.fields):
        if t.form == '[]':
            out += [f'list(r, {i})', 'count(r)']
        elif t.name in ready and not t.mut:
            out.append(f'ready(r, {i})')
        elif t.is_callback:
            out.append(f'{t.name}(r)')
        elif t.form or t.name in structs or t.mut:
            out.append(f'at(r, {i})')
        elif t.name == 'text':
            out.append('text(r)')
        elif t.name in ('f32', 'f64'):
            out.append('real(r)')
        elif t.name == 'bool':
            out.append('whole(r) != 0')
        else:
            out.append(f'({"mrw_" + t.name if t.name in enums else "uint32_t"})whole(r)')
    if row.type and not row.type.form and row.type.name in structs:
        out.append(f'at(r, {len(row.fields)})')
    return ', '.join(out)


# Four numbers a lane, which nobody wants set first; a union; a struct within another one.
NOT_BY_NAME = {'soa_transform', 'inertial_offset', 'property', 'gles3_program_set_entry'}


def rows_of_calls(part, rows):
    structs = {r.name for r in rows if r.kind == 'struct'}
    enums = {r.name for r in rows if r.kind == 'enum'}
    ready = {r.name for r in rows if 'ready' in r.flags}
    calls, filled = [], []
    for r in part.rows:
        if r.kind == 'struct' and not r.cpp.startswith('Span<') and 'private' not in r.flags and r.name not in NOT_BY_NAME:
            filled.append(f'STRUCT({r.qualified()}, {r.fields[0][0]})')
        if r.kind == 'struct' and 'init' in r.flags:
            calls.append(f'CALL({r.name}_init, 0, 0, at(r, 0))')
        if r.kind != 'fn' or r.cpp == 'set_call_error_handler' or r.source != part.wrappers:
            continue
        macro = 'STATUS' if returned(r, structs) == 'mrw_status' else 'CALL'
        takes_struct = any(t.name in structs and t.form in ('', 'array') and not t.optional for _, t in r.fields)
        takes_list = any(t.form == '[]' for _, t in r.fields)
        calls.append(f'{macro}({r.name}, {int(takes_struct)}, {int(takes_list)}, {arguments(r, structs, enums, ready)})')
    return (MADE + '// Of every function a call, of every struct a member; what is made of them, those say who include this.\n'
            '// clang-format off\n#ifdef STATUS\n' + '\n'.join(calls) + '\n#endif\n#ifdef STRUCT\n' + '\n'.join(filled) +
            '\n#endif\n')
