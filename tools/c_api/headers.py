"""Reads the C++ headers: comments, and what descriptions leave for them to say."""
import re
from collections import Counter

from description import SCALARS, Type, Wrong

SCALAR_OF = {**{cpp: name for name, (_, cpp) in SCALARS.items()}, 'unsigned': 'u32', 'int': 'i32', 'void': 'void'}


def type_of(cpp, names):
    """A type as descriptions have it; `names`: what structs and enums are called there."""
    m = re.fullmatch(r'Span<(const )?(.*?)( const)?>|(const )?([\w:]+)(\*)?', cpp)
    within = m and (m[2] or m[5])
    if m and within.startswith('char') and (m[1] or m[4]) and (m[2] or m[6]):
        return Type('text', form='[]' if m[2] else '')
    name = SCALAR_OF.get(within) or names.get(within) if m else None
    if name is None:
        raise Wrong(f'{cpp}: is no type of C: say FIELD = TYPE')
    return Type(name, not (m[1] or m[4]) and bool(m[2] or m[6]), '[]' if m[2] else m[6] or '')


def body_of(lines, at):
    """What stands in the braces that begin at line `at`, without comments."""
    code = [trailing_comment(line)[0] for line in lines[at:]]
    text = ' '.join(code)
    return re.sub(r'\s+', ' ', text[text.index('{') + 1:text.index('};')] if '};' in code[0]
                  else ' '.join(code[1:next(i for i, line in enumerate(code) if line.startswith('};'))]))


def without_initialisers(text):
    before = None
    while before != text:
        before, text = text, re.sub(r'\{[^{}]*\}', '', text)
    return re.sub(r'=[^,;]*', '', text)


def fields_of(row, lines, at, names, constants):
    """The fields of a struct, in its order."""
    out = []
    for statement in (s.strip() for s in without_initialisers(body_of(lines, at)).split(';')):
        statement = re.sub(r'^alignas\([^)]*\) ', '', statement)
        pointer = re.search(r'\(\*(\w+)\)', statement)
        if pointer and pointer[1] in row.known:
            out.append((pointer[1], row.known[pointer[1]]))
            continue
        m = re.fullmatch(r'((?:const )?[\w:]+(?:<[^>]*>)?\*?) ([^()]+)', statement)
        if not m:
            if pointer:
                raise Wrong(f'{pointer[1]}: say FIELD = TYPE')
            continue  # a constructor
        for declared in m[2].split(','):
            name, *dims = re.findall(r'\w+', declared)
            t = row.known.get(name) or type_of(m[1], names)
            if dims:
                t = Type(t.name, form='array', dims=tuple(int(constants.get(d, d)) for d in dims))
            out.append((name, t))
    return out


def value_of(row, line, constants):
    text = re.search(rf'\b{row.cpp} = (.*?);', line)[1]
    if row.type.name == 'f32':
        return text
    text = re.sub(r'\bk\w+', lambda m: constants[m[0]], text)
    return str(eval(re.sub(r'(?<=[0-9A-Fa-f])u\b', '', text), {'__builtins__': {}}))


PATTERNS = {
    'const': r'inline constexpr .*\b{name}\b|.*\b{name} = ',
    'enum': r'enum class (\[\[.*?\]\] )?{name}\b',
    'struct': r'(struct|class) ((alignas\(\d+\)|[A-Z_]+) )*{name} \{{',
    'opaque': r'struct {name};',
    'fn': r'[a-zA-Z][\w:&*<> ]*[ *&]{name}\(',
    'method': r'  (?!return|if|for)[\w:&*<> ]+[ *&]{name}\(',
}


def places_of(row, lines):
    pattern = PATTERNS['method' if row.method else row.kind].format(name=re.escape(row.cpp))
    return [i for i, line in enumerate(lines) if re.match(pattern, line)]


def complete(rows, above, read_header):
    """Fills in values, enumerators and fields that rows leave to the header."""
    names = {r.cpp: r.name for r in above + rows if r.kind in ('struct', 'enum')}
    constants = {r.cpp: r.value for r in above if r.kind == 'const'}
    for row in sorted(rows, key=lambda r: r.kind != 'const'):  # dimensions are constants
        if row.kind not in ('const', 'enum', 'struct') or row.value or row.values or row.fields:
            constants.update({row.cpp: row.value} if row.kind == 'const' else {})
            continue
        lines = read_header(row.header)
        try:
            at = places_of(row, lines)[0]
            if row.kind == 'const':
                row.value = constants[row.cpp] = value_of(row, lines[at], constants)
            elif row.kind == 'enum':
                row.values = [v for v in re.split(r'[, ]+', body_of(lines, at)) if v]
            else:
                row.fields = fields_of(row, lines, at, names, constants)
        except (Wrong, IndexError, KeyError) as wrong:
            raise SystemExit(f'{row.header}: {row.cpp}: {wrong}')

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
    return [line for line in out if not line.startswith('clang-format')]


def trailing_comment(line):
    code, slashes, comment = line.partition('//')
    return code, [comment.strip()] if slashes else []


def body_docs(lines, at, names):
    """What stands beside or above each name in the braces that begin at line `at`."""
    docs, above, last, left = {}, [], [], list(names)
    if '}' in lines[at]:
        return docs
    for line in lines[at + 1:]:
        if re.match(r'(  )?}', line):
            break
        indent = len(line) - len(line.lstrip())
        if line.lstrip().startswith('//'):
            text = re.sub(r'^\s*// ?', '', line).rstrip()
            if indent > 2 and last:
                for n in last:
                    docs[n].append(text)
            else:
                above.append(text)
            continue
        code, beside = trailing_comment(line)
        declared = re.sub(r'=[^,;]*', '', re.sub(r'\{[^}]*\}', '', code))
        found = [n for n in left if re.search(rf'\b{n}\b', declared)]
        for n in found:
            docs[n] = above + beside
            left.remove(n)
        if found:
            last, above = found, []
        elif beside:
            for n in last:
                docs[n] += beside
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
                raise SystemExit(f'{row.header}: {row.cpp}::{name} has no row')


FUNCTION = re.compile(r'(?:  )?(?:(?:MARROW_API|MRW_NODISCARD|inline|constexpr|const) )*(?!return|friend|using|static_assert|'
                      r'explicit|else|MARROW_API)[A-Za-z_][\w:]*(?:<[^>]*>)?(?: const)?[ &*]+(?!alignas|requires)(\w+)\(')
CONSTRUCTOR = re.compile(r'  (?:MARROW_API )?(~?[A-Z][A-Za-z]*)\(.*;')


def functions_of(lines):
    """(name, whether a library exports it) of each public function, also of classes, as often as it has overloads."""
    hidden = False
    for line in lines:
        if line.startswith((' public:', '}')):
            hidden = False
        if line.startswith(' private:'):
            hidden = True
        code = line.replace('= {}', '')
        m = FUNCTION.match(line)
        constructor = None if m else CONSTRUCTOR.match(line)
        if not hidden and (m or constructor) and not re.search(r'= (delete|default);|\boperator\b', line):
            exported = '{' not in code and not re.match(r' *(inline|constexpr)\b', line)
            if m or exported:
                yield (m or constructor)[1], exported, bool(constructor)
        if re.match(r'(inline|constexpr).*\{$', line):
            hidden = True


def expect_all_functions(rows, read_header, names):
    """Each overload and each member has a row, or is said not to be there in C; `names`: of the headers of C++."""
    for header in names:
        declared = Counter(name for name, _, constructor in functions_of(read_header(header)) if not constructor)
        described = Counter(r.cpp for r in rows if r.header == header and r.kind in ('fn', 'no') and not r.is_member)
        for name, times in declared.items():
            if described[name] < times:
                raise SystemExit(f'{header}: {name}: is declared {times} times, and has {described[name]} rows')


def add_docs(rows, read_header):
    seen = {}
    for row in rows:
        if row.kind in ('no', 'callback') or not row.header:
            continue
        lines = read_header(row.header)
        places = places_of(row, lines)
        if not places:
            if row.is_member or row.cpp.startswith('Span<') or row.cpp.endswith('Bounds'):
                continue
            raise SystemExit(f'{row.header}: {row.cpp} is described, but not declared')
        key = (row.header, row.cpp, row.kind)
        at = places[min(seen.get(key, 0), len(places) - 1)]
        seen[key] = seen.get(key, 0) + 1
        row.doc = comment_above(lines, at)
        if row.kind == 'const':
            row.beside = trailing_comment(lines[at])[1]
        if row.kind == 'enum':
            row.docs = body_docs(lines, at, row.values)
        if row.kind == 'struct':
            names = [name for name, _ in row.fields]
            row.docs = body_docs(lines, at, names)
            if 'private' in row.flags:
                continue
            expect_all_fields(row, lines, at, names + [r.cpp for r in rows if r.is_member and r.method == row.name])
