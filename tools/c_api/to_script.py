"""JavaScript: tables.mjs, which marrow.mjs works by, with 4-byte pointers; and marrow.d.ts, its types."""
import json
import re

from layout import Layout
from names import camel, count_of
from to_cpp import MADE


def value_of(row):
    return re.sub(r'(?<=\d)f\b', '', row.value)


def field_entry(name, t, place, enums, structs):
    kind = enums[t.name].type.name if t.name in enums else {'size': 'u32', 'char': 'u8'}.get(t.name, t.name)
    if t.form == '[]' and t.name == 'text':
        return [place, 'list', 'u32']
    if t.form == '[]':
        return [place, 'list', camel(kind) if t.name in structs else kind]
    if t.form == '*' or t.name == 'code' or t.is_callback:
        return [place, 'pointer', camel(kind) if t.name in structs else kind]
    if t.name == 'text':
        return [place, 'text']
    if t.name in structs:
        return [place, 'structs', camel(kind), t.dims[0]] if t.dims else [place, 'struct', camel(kind)]
    count = 1
    for n in t.dims:
        count *= n
    return [place, 'array', kind, count] if t.dims else [place, 'value', kind]


def argument(t, structs):
    if t.form == '[]':
        return 'list'
    if t.form or t.name in structs or t.mut or t.is_callback:
        return 'pointer'
    return {'text': 'text', 'bool': 'bool'}.get(t.name, 'number')


def result(row, structs):
    t = row.type
    if t is None:
        return 'void'
    if t.form == '*':
        return camel(t.name)
    if t.name in structs:
        return 'number'
    return {'text': 'text', 'bool': 'bool', 'u64': 'bigint', 'f32': 'real', 'f64': 'real'}.get(t.name, 'number')


def arguments(row, structs):
    out = [(n, argument(t, structs), t) for n, t in row.fields]
    if row.type and not row.type.form and row.type.name in structs:
        out.append(('out', 'pointer', row.type))
    return out


def tables(rows, parts):
    structs = {r.name: r for r in rows if r.kind == 'struct'}
    enums = {r.name: r for r in rows if r.kind == 'enum'}
    layout = Layout(rows, 4)
    out = [MADE + '// What marrow.mjs reads and calls by, for WebAssembly with pointers of 4 bytes; and enums and constants.', '',
           *[f'export const {p.prefix.upper()}ABI = 0x{p.abi:08x};' for p in parts], '']
    out += [f'export const {r.name.upper()} = {value_of(r)};' for r in rows if r.kind == 'const'] + ['']
    for r in enums.values():
        pairs = ', '.join(f'{v.upper()}: {i}' for i, v in enumerate(r.values))
        out.append(f'export const {camel(r.name)} = Object.freeze({{ {pairs} }});')
    out += ['', '// Size, boundary, whether there is an init, and of each field its place and what it is.',
            'export const structs = {']
    for r in structs.values():
        size, align, places = layout.of(r.name)
        fields = {} if 'private' in r.flags else {n: field_entry(n, t, p, enums, structs)
                                                  for (n, t), p in zip(r.fields, places)}
        out.append(f'  {camel(r.name)}: {{ size: {size}, align: {align}, init: '
                   f'{json.dumps(r.name + "_init" if "init" in r.flags else "")}, fields: {json.dumps(fields)} }},')
    out += ['};', '', '// What each function takes, and what it gives.', 'export const functions = {',
            *[f"  {p.prefix}abi: [[], 'number']," for p in parts]]
    for r in rows:
        if r.kind == 'struct' and 'init' in r.flags:
            out.append(f"  {r.name}_init: [['pointer'], 'void'],")
        if r.kind == 'fn':
            out.append(f'  {r.name}: {json.dumps([[a for _, a, _ in arguments(r, structs)], result(r, structs)])},')
    return '\n'.join(out + ['};', ''])


SCRIPT = {'f64': 'number', 'bool': 'boolean', 'u64': 'bigint', 'text': 'string'}


def script_type(t, structs, enums):
    name = camel(t.name) if t.name in structs or t.name in enums else SCRIPT.get(t.name, 'number')
    if t.form == '[]':
        return f'List<{name}>' if t.name in structs else 'List<number>'
    if t.form == '*' or t.name == 'code' or t.is_callback:
        return 'number'
    if t.dims:
        return f'{name}[]' if t.name in structs else 'TypedArray'
    return name


def docs(lines, indent):
    return [f'{indent}/**'] + [f'{indent} * {line}'.rstrip().replace('*/', '* /') for line in lines] + [f'{indent} */'] \
        if lines else []


def types(rows, parts):
    structs = {r.name: r for r in rows if r.kind == 'struct'}
    enums = {r.name: r for r in rows if r.kind == 'enum'}
    out = [MADE + '// The runtime for JavaScript and TypeScript, as C has it: see docs/c.md.', '',
           *[f'export const {p.prefix.upper()}ABI: number;' for p in parts]]
    out += [f'export const {r.name.upper()}: number;' for r in rows if r.kind == 'const']
    for r in enums.values():
        out += [''] + docs(r.doc, '') + [f'export const {camel(r.name)}: {{']
        for v in r.values:
            out += docs(r.docs.get(v, []), '  ') + [f'  readonly {v.upper()}: number;']
        out += ['};', f'export type {camel(r.name)} = number;']
    out += ['', 'export type TypedArray = Float32Array | Float64Array | Uint8Array | Uint16Array | Uint32Array | Int16Array;', '',
            '/** A struct in the memory of WebAssembly. */', 'export interface View { readonly ptr: number; }',
            '/** Structs or numbers in a row there. Set a field to one, or hand it over as an argument. */',
            'export interface List<T> extends View {', '  readonly length: number;',
            '  /** Of structs, and one after the other. */', '  at(index: number): T;',
            '  [Symbol.iterator](): IterableIterator<T>;',
            '  /** Of numbers: a view that lasts until memory grows. */', '  readonly array: TypedArray;', '}', '']
    for r in structs.values():
        out += docs(r.doc, '') + [f'export interface {camel(r.name)} extends View {{']
        for n, t in r.fields if 'private' not in r.flags else []:
            fixed = 'readonly ' if t.dims or (t.name in structs and not t.form) else ''
            out += docs(r.docs.get(n, []), '  ') + [f'  {fixed}{n}: {script_type(t, structs, enums)};']
        out += ['}', '']
    out += ['/** What Marrow has made of WebGL. */', 'export interface GlObjects {',
            "  /** The context's own: of a program's id a WebGLProgram; null if there is none of this name. */",
            '  object(name: number): WebGLObject | null;',
            '  /** Deletes every object, or forgets those of a context that was lost. */', '  release(): void;', '}',
            'export type WebGLObject = WebGLBuffer | WebGLFramebuffer | WebGLProgram | WebGLShader | WebGLTexture |',
            '  WebGLVertexArrayObject;', '']
    out += ['export interface Structs {'] + [f'  {camel(n)}: {camel(n)};' for n in structs] + ['}', '',
            'export class Marrow {',
            '  /** Compiles the bytes of a library, or takes a module. Throws if it is of another ABI. `context`: draws there. */',
            '  static load(wasm: BufferSource | WebAssembly.Module, context?: WebGL2RenderingContext | null): Promise<Marrow>;',
            '  /** Fetches the library beside this module: without solvers, limits, feet, springs and graphs, or `all`; with SIMD',
            '   * where the browser has it. */',
            '  static fetch(context?: WebGL2RenderingContext | null, options?: { all?: boolean; simd?: boolean }): Promise<Marrow>;',
            '  /** Of the context, if there is one. */', '  readonly gl: GlObjects | null;',
            '  /** For gles3_load_api(). */', '  readonly loadProc: number;',
            '  /** A struct as C++ has it by default, and with these values; zeros where there is no default. */',
            '  make<K extends keyof Structs>(name: K, values?: Partial<Structs[K]>): Structs[K];',
            '  /** A list of zeros, or of structs as by make(); of bytes on a boundary of 16. */',
            '  list<K extends keyof Structs>(name: K, length: number): List<Structs[K]>;',
            "  list(type: 'f32' | 'u8' | 'u16' | 'u32' | 'byte', length: number): List<number>;",
            '  /** A list of these bytes. */', '  bytes(from: Uint8Array): List<number>;',
            '  /** The struct at a pointer. */', '  view<K extends keyof Structs>(name: K, ptr: number): Structs[K];',
            '  /** Gives back what make() and list() made. */', '  free(made: View): void;',
            '  /** Throws an Error with the text of the status, unless it is ok. */', '  must(status: Status): void;',
            '  /** Is told of bad calls; null: nobody. */',
            '  onCallError(handler: ((name: string, condition: string) => void) | null): void;', '',
            *[f'  {p.prefix}abi(): number;' for p in parts]]
    for r in rows:
        if r.kind != 'fn' or r.cpp == 'set_call_error_handler' or r.source not in [p.wrappers for p in parts]:
            continue
        params = []
        for n, a, t in arguments(r, structs):
            if a == 'list':
                params.append(f'{n}: {script_type(t, structs, enums)} | null')
            elif a == 'pointer':
                params.append(f'{n}: {camel(t.name) if t.name in structs and not t.dims else "View | number"} | null')
            else:
                params.append(f'{n}: {script_type(t, structs, enums)}{" | null" if a == "text" else ""}')
        gives = result(r, structs)
        gives = {'text': 'string', 'bool': 'boolean', 'real': 'number'}.get(gives, gives)
        if r.type and r.type.name in structs:
            gives = f'{gives} | null' if r.type.form else 'Status'
        elif r.type and r.type.name == 'status':
            gives = 'Status'
        out += docs(r.doc, '  ') + [f'  {r.name}({", ".join(params)}): {gives};']
    return '\n'.join(out + ['}', ''])
