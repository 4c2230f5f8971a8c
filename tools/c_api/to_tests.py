"""A call of each function of C with whatever a test thinks of: tests/c/bad_calls.c."""
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


def rows_of_calls(part, rows):
    structs = {r.name for r in rows if r.kind == 'struct'}
    enums = {r.name for r in rows if r.kind == 'enum'}
    ready = {r.name for r in rows if 'ready' in r.flags}
    calls, table = [], []
    for r in part.rows:
        if r.kind == 'struct' and 'init' in r.flags:
            calls.append(f'static int call_{r.name}_init(const Round* r) {{\n  mrw_{r.name}_init(at(r, 0));\n  return -1;\n}}')
            table.append(f'    {{"mrw_{r.name}_init", call_{r.name}_init, 0, 0}},')
        if r.kind != 'fn' or r.cpp == 'set_call_error_handler' or r.source != part.wrappers:
            continue
        is_status = returned(r, structs) == 'mrw_status'
        takes_struct = any(t.name in structs and t.form in ('', 'array') and not t.optional for _, t in r.fields)
        takes_list = any(t.form == '[]' for _, t in r.fields)
        call = f'mrw_{r.name}({arguments(r, structs, enums, ready)})'
        body = f'  return {call};' if is_status else f'  (void){call};\n  return -1;'
        calls.append(f'static int call_{r.name}(const Round* r) {{\n  (void)r;\n{body}\n}}')
        table.append(f'    {{"mrw_{r.name}", call_{r.name}, {int(takes_struct)}, {int(takes_list)}}},')
    return (MADE + '// Of every function a call; what it is given, bad_calls.c says.\n// clang-format off\n' + '\n'.join(calls) +
            '\n\nstatic const Row rows[] = {\n' + '\n'.join(table) + '\n};\n')
