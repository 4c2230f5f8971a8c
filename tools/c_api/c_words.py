"""Comments of the C++ headers as C's have them: names of types, functions, members, constants and files are C's."""
import re

from names import constant, count_of, enumerator

NAME = r'[A-Za-z_]\w*'
TOKEN = re.compile(rf'(?P<file>(?:marrow/)?(?P<stem>{NAME})\.h\b)|(?P<kept>\w[\w.]*/[\w./*]*|(?:MARROW|MRW|mrw)_\w+)|'
                   rf'(?P<path>{NAME}(?:\.{NAME})+)(?P<none>\(\))?|(?P<names>(?:{NAME}::)*{NAME})(?P<call>\()?')
WIDTH = 117  # of a comment's text
LEAST = 110  # that lines have where they are broken because they are full


class Words:
    def __init__(self, part, parts):
        rows = [r for p in parts for r in p.rows if r.kind != 'no']
        self.file_of = {r.header.removesuffix('.h'): p.header for p in parts for r in p.rows if r.header}
        self.file = part.header
        self.types = {r.cpp: r for r in rows if r.kind in ('struct', 'enum', 'opaque')}
        self.errors = set(self.types['Status'].values) - {'ok'}
        self.structs = {r.name: r for r in rows if r.kind == 'struct'}
        self.constants = {r.cpp: constant(r.name) for r in rows if r.kind == 'const'}
        self.functions, self.methods = {}, {}
        for r in rows:
            if r.kind == 'fn' and r.method:
                self.methods.setdefault((r.method, r.cpp), 'mrw_' + r.name)
            elif r.kind == 'fn':
                self.functions.setdefault(r.cpp, []).append(r)
        self.members = {name for row in self.structs.values() for name, _ in row.fields}

    def member(self, row, name):
        """What C has for Type::name."""
        if row.kind == 'enum' and name in row.values:
            return enumerator(row, name)
        if (row.name, name) in self.methods:
            return self.methods[row.name, name]
        if name in dict(row.fields):
            return f'mrw_{row.name}.{name}'
        raise SystemExit(f'a comment names {row.cpp}::{name}, which C has not')

    def function(self, name, arguments, header, about):
        """Of overloads the one that takes such arguments, is what the comment is about, or stands in the header; or what
        their names have in common."""
        found = self.functions[name]
        taken = {id(r): len(arguments & {n for n, _ in r.fields}) for r in found}
        for best in (lambda r: taken[id(r)] == max(taken.values()), lambda r: r is about, lambda r: r.header == header,
                     lambda r: r.name in (name, f'{r.namespace}_{name}')):
            found = [r for r in found if best(r)] or found
        if len(found) == 1:
            return 'mrw_' + found[0].name
        prefix = f'mrw_{found[0].namespace}_' if found[0].namespace else 'mrw_'
        return prefix + (f'…_{name}' if found[0].name.endswith('_' + name) else f'{name}_…')

    def name(self, names, arguments, is_first, header, about):
        """What C has for a name; `is_first`: a sentence begins with it. `header`: where it would stand;
        `arguments`: what stands in parentheses behind it, or None."""
        names = [n for n in names if n not in ('marrow', 'gles3')] or names
        name, own = names[-1], {n for n, _ in about.fields} if about else set()
        if len(names) > 1:
            return self.member(self.types[names[-2]], name) if names[-2] in self.types else None
        if name in self.constants:
            return self.constants[name]
        if name in self.types and not (is_first and name[1:].islower()):  # "File" is a word, too
            return 'mrw_' + self.types[name].name
        if name in self.errors:
            return enumerator(self.types['Status'], name)
        if arguments is not None and about and (about.method or about.name, name) in self.methods:
            return self.methods[about.method or about.name, name]
        if name in self.functions and (arguments is not None or '_' in name and name not in own | self.members):
            return self.function(name, arguments or set(), header, about)
        return None

    def path(self, names, is_call, about):
        """list.size as its count, struct.function() as a call of C's; None for all else."""
        row, t, before = about, None, []
        for at, name in enumerate(names):
            if t is not None and t.form == '[]' and name == 'size':
                return '.'.join(before[:-1] + [count_of(before[-1], t)])
            if is_call and row is not None and (row.name, name) in self.methods:
                return f'{self.methods[row.name, name]}({".".join(before)})'
            t = dict(row.fields).get(name) if row is not None else None
            row = self.structs.get(t.name if t is not None else name if at == 0 else '')
            before.append(name)
        return None

    def text(self, text, header, about):
        def each(m):
            before, after = text[:m.start()].rstrip(' \n`('), text[m.end():]
            is_first = not before or before.endswith(('.', ':', '?'))
            if m['file'] and m['stem'] in self.file_of:
                file = self.file_of[m['stem']]
                return ('Part ' if is_first else 'part ') + m['stem'] + (f' of {file}' if file != self.file else '')
            if m['file'] or m['kept'] or before.endswith('"'):
                return m[0]
            if m['path']:
                return self.path(m['path'].split('.'), bool(m['none']), about) or m[0]
            is_title = re.match(r' [A-Z][a-z]', after) and m['names'][1:].islower()
            arguments = set(re.findall(NAME, after.split(')')[0])) if m['call'] else None
            elsewhere = re.match(r'\)\s(?:of|in)\s(\w+\.h)', after)
            name = self.name(m['names'].split('::'), arguments, is_first or is_title,
                             elsewhere[1] if elsewhere else header, None if elsewhere else about)
            return (name or m['names']) + (m['call'] or '')
        out = re.sub(r'\b[Ss]pan(s?)\b', r'list\1', TOKEN.sub(each, text))
        return re.sub(r'\b([Aa])(?=[ \n]`?(mrw|MRW)_)', r'\1n', out)

    def comment(self, lines, header, about=None, width=WIDTH):
        return wrapped(lines, self.text('\n'.join(lines), header, about).split('\n'), width) if lines else []


def filled(lines, indent, width):
    """The same words in full lines, the second and later ones indented."""
    out, line = [], ''
    for word in re.findall(r' *\S+', lines[0] + ''.join(' ' + line.lstrip() for line in lines[1:])):
        if line and len(line + word) > width:
            out.append(line)
            line, word = indent, word.lstrip()
        line += word
    return out + [line]


def indent_of(line):
    """Where what belongs to a line goes on: of a table in its second column."""
    return ' ' * re.match(r' +(\S.*?\S  +)?', line).end() if line.startswith(' ') else ''


def wrapped(before, lines, width):
    """Paragraphs and rows in which a line has become too long are filled anew. Breaks stay where the word behind them
    would have fitted `before`."""
    out, paragraph = [], []
    def end():
        fits = all(len(line) <= width for line in paragraph)
        out.extend(paragraph if fits else filled(paragraph, indent_of(paragraph[0]), width))
        paragraph.clear()
    for i, line in enumerate(lines):
        goes_on = paragraph and line and len(line) - len(line.lstrip()) == len(indent_of(paragraph[0])) and \
            len(before[i - 1]) + 1 + len(before[i].split()[0]) > LEAST
        if not goes_on:
            end()
        paragraph.append(line)
    end()
    return out
