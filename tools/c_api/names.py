"""How things are called in each language."""
import re

COUNTS = {'meshes': 'mesh', 'properties': 'property', 'feet': 'foot', 'bytes': 'byte', 'stiffness': 'stiffness',
          'target_was': 'target_was'}


def count_of(name, type):
    """The name of the count beside a pointer."""
    if type.name in ('byte', 'char') and name != 'bytes':
        return name + '_bytes'
    if name in COUNTS:
        return COUNTS[name] + '_count'
    return re.sub(r'(_s)$', '', name).removesuffix('s') + '_count'


def constant(name):
    return 'MRW_' + name.upper()


def enumerator(enum, value):
    return constant(value if enum.name == 'status' else f'{enum.name}_{value}')


def camel(name):
    return ''.join(part[:1].upper() + part[1:] for part in name.split('_'))


def wrapped(first, parts, last, indent='    ', most=120):
    """first + 'a, b, c' + last, on as many lines as it takes."""
    line, lines = first, []
    for i, part in enumerate(parts):
        piece = part + (', ' if i + 1 < len(parts) else last)
        if len((line + piece).rstrip()) > most:
            lines.append(line.rstrip())
            line = indent
        line += piece
    if not parts:
        line += last
    return '\n'.join(lines + [line])


def comment(lines, mark='//', indent=''):
    return [(f'{indent}{mark} {line}' if line else f'{indent}{mark}').rstrip() for line in lines]
