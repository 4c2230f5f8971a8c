"""The wrappers, a line of C++ each, and what holds C's structs to C++'s."""
from description import SCALARS
from names import constant, count_of, enumerator
from to_c import c_name, prototype, returned

MADE = '// Made by tools/c_api from the descriptions in runtime/c: do not edit.\n'


class Writer:
    def __init__(self, part, rows):
        self.part = part
        self.cpp = {r.name: r.qualified() for r in rows if r.kind in ('struct', 'enum', 'opaque')}
        self.cpp['text'] = 'const char*'
        self.structs = {r.name for r in rows if r.kind == 'struct'}
        self.ready = {r.name for r in rows if 'ready' in r.flags}
        self.enums = {r.name for r in rows if r.kind == 'enum'}

    def type(self, name):
        return self.cpp.get(name) or (SCALARS[name][1] if name in SCALARS else name)

    def argument(self, name, t):
        cpp, const = self.type(t.name), '' if t.mut else 'const '
        if t.form == '[]':
            return f'span<{const}{cpp}>({name}, {count_of(name, t)})'
        if t.form == 'array':
            return f'array<{const}{cpp}, {t.dims[0]}>({name})'
        if t.form == '*':
            return f'static_cast<{const}{cpp}*>(static_cast<{const}void*>({name}))' if t.name in self.structs else name
        if t.name in self.structs:
            return f'or_default<{cpp}>({name})' if t.optional else f'{"to" if t.mut else "of"}<{cpp}>({name})'
        if t.name in self.enums:
            if t.mut:
                return f'to<{cpp}>({name})'
            return f'static_cast<{cpp}>({name})'
        return '*' + name if t.mut else name

    def conditions(self, row):
        out = []
        for name, t in row.fields:
            if t.form == '[]':
                out.append(f'is_list<{self.type(t.name)}>({name}, {count_of(name, t)})')
            if t.form == '[]' or (t.form == '' and t.name not in self.structs and not t.mut) or t.name == 'void':
                continue
            out.append(f'{"leads_to_if_any" if t.optional else "leads_to"}<{self.type(t.name)}>({name})')
            if t.name in self.ready and not t.mut:
                out.append(f'is_ready(of<{self.type(t.name)}>({name}))')
        if self.gives_struct(row):
            out.append(f'leads_to<{self.type(row.type.name)}>(out)')
        return out

    def gives_struct(self, row):
        return row.type is not None and not row.type.form and row.type.name in self.structs

    def call(self, row):
        fields = row.fields[1:] if row.method else row.fields
        arguments = ', '.join(self.argument(name, t) for name, t in fields)
        if row.method:
            name = f'of<{self.type(row.method)}>({row.method}).{row.cpp}'
        else:
            name = f'marrow::{row.qualified()}'
        call = name if row.is_member else f'{name}({arguments})'
        if row.type is None:
            return call
        if self.gives_struct(row):
            return f'give<{self.type(row.type.name)}>(out, {call})'
        if row.type.name in self.structs:
            return f'return to_c<{"" if row.type.mut else "const "}{c_name(row.type.name)}>({"&" * row.type.is_reference}{call})'
        if row.type.name == 'status':
            return f'return code({call})'
        if row.type.name in self.enums and not row.type.form:
            return f'return static_cast<{c_name(row.type.name)}>({call})'
        return f'return {call}'

    def wrapper(self, row):
        needs = ' && '.join(self.conditions(row))
        result = returned(row, self.structs)
        nothing = {'mrw_status': 'MRW_BAD_ARGUMENT', 'void': '', 'const char*': '""', 'bool': 'false'}.get(
            result, 'nullptr' if result.endswith('*') else '0')
        out = [prototype(row, self.structs, ' {')]
        if needs:
            out.append(f'  MRW_NEEDS({needs}, {nothing});')
        out.append(f'  {self.call(row)};')
        if self.gives_struct(row):
            out.append('  return MRW_OK;')
        return '\n'.join(out + ['}', ''])

    def init(self, row):
        cpp = self.type(row.name)
        return (f'void mrw_{row.name}_init(mrw_{row.name}* out) {{\n'
                f'  MRW_NEEDS(leads_to<{cpp}>(out), );\n  to<{cpp}>(out) = {cpp}{{}};\n}}\n')

    def source(self, name):
        rows = [r for r in self.part.rows if r.kind == 'fn' and r.source == name]
        headers = sorted({r.header for r in rows})
        out = [MADE.replace('do not', 'one line of C++ a function. Do not') + f'#include "c/{self.part.prefix}twin.h"\n']
        out += [f'#include "marrow/{h}"' for h in headers] + ['', '// clang-format off',
                                                              'using namespace marrow;', 'using namespace marrow::c;', '',
                                                              'extern "C" {', '']
        if name == self.part.wrappers:
            prefix = self.part.prefix
            out.append(f'uint32_t mrw_{prefix}abi(void) {{\n  return MRW_{prefix.upper()}ABI;\n}}\n')
            out += [self.init(r) for r in self.part.rows if 'init' in r.flags]
        out += [self.wrapper(r) for r in rows]
        return '\n'.join(out) + '\n}  // extern "C"\n'

    def layouts(self):
        out = [MADE + '// C\'s structs, enums and constants are C++\'s.', f'#include "marrow/{self.part.header}"', '',
               '#include <cstddef>', '#include <type_traits>', '']
        out += [f'#include "marrow/{h}"' for h in sorted({r.header for r in self.part.rows if r.kind in ('struct', 'enum', 'const')})]
        out += ['', '// clang-format off', '// NOLINTBEGIN(bugprone-sizeof-expression)', 'namespace marrow {', '',
                '#define SAME(C, Cpp) static_assert(sizeof(C) == sizeof(Cpp) && alignof(C) == alignof(Cpp) && '
                'std::is_standard_layout_v<Cpp>)',
                '#define SAME_MEMBER(C, Cpp, c, cpp) static_assert(offsetof(C, c) == offsetof(Cpp, cpp) && '
                'sizeof(C::c) == sizeof(Cpp::cpp))',
                '#define SAME_SPAN(C, Cpp, c, count) static_assert(offsetof(C, c) == offsetof(Cpp, c) && '
                'offsetof(C, count) == offsetof(Cpp, c) + sizeof(void*))', '']
        for r in self.part.rows:
            cpp = r.qualified()
            if r.kind == 'const':
                out.append(f'static_assert({constant(r.name)} == {cpp});')
            if r.kind == 'enum':
                out.append(f'static_assert(sizeof(mrw_{r.name}) == sizeof({cpp}));')
                out += [f'static_assert({enumerator(r, v)} == static_cast<int>({cpp}::{v}));' for v in r.values]
            if r.kind == 'struct':
                out.append(f'SAME(mrw_{r.name}, {cpp});')
                for name, t in r.fields if 'private' not in r.flags else []:
                    if t.form == '[]':
                        out.append(f'SAME_SPAN(mrw_{r.name}, {cpp}, {name}, {count_of(name, t)});')
                    else:
                        out.append(f'SAME_MEMBER(mrw_{r.name}, {cpp}, {name}, {name});')
        return '\n'.join(out + ['', '}  // namespace marrow', '// NOLINTEND(bugprone-sizeof-expression)', ''])
