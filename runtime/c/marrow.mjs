// Calls the runtime in WebAssembly, by what tables.mjs says: structs as objects with fields, functions as methods that
// take them. Nothing is copied; memory is what make() and list() give. See docs/c.md; types in marrow.d.ts.
import { glImports } from './gl.mjs';
import { ABI, functions, structs } from './tables.mjs';

export * from './tables.mjs';

const kBoundary = 16;
const kScalars = {  // bytes, how a DataView calls it, the array of many
  f32: [4, 'Float32', Float32Array], f64: [8, 'Float64', Float64Array], bool: [1, 'Uint8', Uint8Array],
  u8: [1, 'Uint8', Uint8Array], u16: [2, 'Uint16', Uint16Array], u32: [4, 'Uint32', Uint32Array],
  u64: [8, 'BigUint64', BigUint64Array], i16: [2, 'Int16', Int16Array], i32: [4, 'Int32', Int32Array],
  byte: [1, 'Uint8', Uint8Array], void: [1, 'Uint8', Uint8Array],
};
const sizeOf = (type) => (kScalars[type] ? kScalars[type][0] : structs[type].size);

// A module that gives a function of JavaScript on as one of WebAssembly, with two numbers and no result.
const kTold = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 6, 1, 96, 2, 127, 127, 0, 2, 7, 1, 1, 101, 1, 102, 0, 0, 7, 5, 1, 1, 102, 0, 0,
]);

// A module with an instruction of SIMD, which is valid where they are known.
const kSimd = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65, 0, 253, 15, 11,
]);
// The libraries beside this file, each a literal that bundlers find.
const kLibraries = [
  () => new URL('./marrow-core.wasm', import.meta.url), () => new URL('./marrow-core-simd.wasm', import.meta.url),
  () => new URL('./marrow-all.wasm', import.meta.url), () => new URL('./marrow-all-simd.wasm', import.meta.url),
];

class View {
  constructor(marrow, ptr) {
    this.marrow = marrow;
    this.ptr = ptr;
  }
}

class List extends View {
  constructor(marrow, type, ptr, length) {
    super(marrow, ptr);
    this.type = type;
    this.length = length;
  }
  at(index) {
    if (!(index >= 0 && index < this.length)) throw new RangeError(`${index} of ${this.length} ${this.type}`);
    return this.marrow.view(this.type, this.ptr + index * sizeOf(this.type));
  }
  *[Symbol.iterator]() { for (let i = 0; i < this.length; ++i) yield this.at(i); }
  get array() {
    return this.marrow.arrayAt(kScalars[this.type] ? this.type : 'byte', this.ptr,
      this.length * (kScalars[this.type] ? 1 : sizeOf(this.type)));
  }
}

// How a field is read, and written where it can be.
function accessor([place, kind, type, count]) {
  if (kind === 'value') {
    const name = kScalars[type][1];
    return {
      get() {
        const value = this.marrow.data[`get${name}`](this.ptr + place, true);
        return type === 'bool' ? value !== 0 : value;
      },
      set(value) { this.marrow.data[`set${name}`](this.ptr + place, type === 'u64' ? value : Number(value), true); },
    };
  }
  const pointer = (view) => view.marrow.data.getUint32(view.ptr + place, true);
  const point = (view, to) => view.marrow.data.setUint32(view.ptr + place, to, true);
  switch (kind) {
    case 'text':
      return {
        get() { return this.marrow.textAt(pointer(this)); },
        set(text) { point(this, this.marrow.textOf(text)); },
      };
    case 'struct': return { get() { return this.marrow.view(type, this.ptr + place); } };
    case 'array': return { get() { return this.marrow.arrayAt(type, this.ptr + place, count); } };
    case 'structs':
      return {
        get() { return Array.from({ length: count }, (_, i) => this.marrow.view(type, this.ptr + place + i * sizeOf(type))); },
      };
    case 'list':
      return {
        get() {
          return new List(this.marrow, type, pointer(this), this.marrow.data.getUint32(this.ptr + place + 4, true));
        },
        set(list) {
          point(this, list ? list.ptr : 0);
          this.marrow.data.setUint32(this.ptr + place + 4, list ? list.length : 0, true);
        },
      };
    default: return { get() { return pointer(this); }, set(to) { point(this, to ? to.ptr ?? to : 0); } };
  }
}

const classes = {};
for (const [name, struct] of Object.entries(structs)) {
  classes[name] = class extends View {};
  for (const [field, entry] of Object.entries(struct.fields))
    Object.defineProperty(classes[name].prototype, field, { enumerable: true, ...accessor(entry) });
}

export class Marrow {
  static async load(wasm, context = null) {
    const module = wasm instanceof WebAssembly.Module ? wasm : await WebAssembly.compile(wasm);
    let exports = null;
    const gl = context && glImports(context, () => exports);
    const nothing = () => 0;
    const imports = {};  // the C library's of files, which the runtime calls none of; OpenGL ES without a context
    for (const { module: from, name } of WebAssembly.Module.imports(module))
      (imports[from] ??= {})[name] = (from === 'gl' && gl?.imports[name]) || nothing;
    ({ exports } = await WebAssembly.instantiate(module, imports));
    const marrow = new Marrow(exports, gl);
    if (marrow.abi() >>> 0 !== ABI)
      throw new Error(`marrow: the library has ABI ${marrow.abi() >>> 0}, this binding ${ABI}: take both from one release`);
    return marrow;
  }
  static async fetch(context = null, { all = false, simd = WebAssembly.validate(kSimd) } = {}) {
    const response = await fetch(kLibraries[2 * all + simd]());
    if (!response.ok) throw new Error(`marrow: ${response.url}: ${response.status}`);
    return Marrow.load(await response.arrayBuffer(), context);
  }

  constructor(exports, gl) {
    this.exports = exports;
    this.gl = gl;
    this.blocks = new Map();
    this.texts = new Map();
    exports._initialize?.();
  }

  get loadProc() { return this.exports.marrow_load_proc(); }

  get data() {
    const { buffer } = this.exports.memory;
    if (this.seen !== buffer) {
      this.seen = buffer;
      this.seenData = new DataView(buffer);
    }
    return this.seenData;
  }

  block(bytes) {
    const all = this.exports.malloc(bytes + kBoundary);
    if (all === 0) throw new Error('marrow: out of memory');
    const ptr = (all + kBoundary - 1) & -kBoundary;
    this.arrayAt('u8', ptr, bytes).fill(0);
    this.blocks.set(ptr, all);
    return ptr;
  }
  free(made) {
    if (!this.blocks.has(made.ptr)) throw new Error('marrow: this is not from make() or list(), or free already');
    this.exports.free(this.blocks.get(made.ptr));
    this.blocks.delete(made.ptr);
  }

  view(name, ptr) { return new classes[name](this, ptr); }
  make(name, values = {}) {
    const made = this.view(name, this.block(structs[name].size));
    if (structs[name].init) this.exports[`mrw_${structs[name].init}`](made.ptr);
    return this.assign(made, values);
  }
  assign(to, values) {
    for (const [field, value] of Object.entries(values)) {
      if (Array.isArray(value) || ArrayBuffer.isView(value)) to[field].set(value);
      else to[field] = value;
    }
    return to;
  }
  list(type, length) {
    const made = new List(this, type, this.block(length * sizeOf(type)), length);
    if (structs[type]?.init)
      for (let i = 0; i < length; ++i) this.exports[`mrw_${structs[type].init}`](made.at(i).ptr);
    return made;
  }
  bytes(from) {
    const made = this.list('byte', from.length);
    made.array.set(from);
    return made;
  }

  arrayAt(type, ptr, count) { return new kScalars[type][2](this.exports.memory.buffer, ptr, count); }
  textAt(ptr) {
    if (ptr === 0) return '';
    const bytes = new Uint8Array(this.exports.memory.buffer, ptr);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }
  // Texts that functions are given stay, each once.
  textOf(text) {
    if (text === null || text === undefined) return 0;
    if (!this.texts.has(text)) this.texts.set(text, this.bytes(new TextEncoder().encode(`${text}\0`)).ptr);
    return this.texts.get(text);
  }

  must(status) {
    if (status !== 0) throw new Error(`marrow: ${this.status_text(status)}`);
  }
  onCallError(handler) {
    if (handler === null) return void this.exports.mrw_set_call_error_handler(0);
    const tell = (name, condition) => handler(this.textAt(name), this.textAt(condition));
    const told = new WebAssembly.Instance(new WebAssembly.Module(kTold), { e: { f: tell } }).exports.f;
    const table = this.exports.__indirect_function_table;
    this.toldAt ??= table.grow(1);
    table.set(this.toldAt, told);
    this.exports.mrw_set_call_error_handler(this.toldAt);
  }
}

function lowered(marrow, kind, argument, out) {
  switch (kind) {
    case 'list': return void out.push(argument ? argument.ptr : 0, argument ? argument.length : 0);
    case 'pointer': return void out.push(argument ? argument.ptr ?? argument : 0);
    case 'text': return void out.push(marrow.textOf(argument));
    default: return void out.push(Number(argument));
  }
}

for (const [name, [kinds, gives]] of Object.entries(functions)) {
  Marrow.prototype[name] = function (...given) {
    const wrapped = this.exports[`mrw_${name}`];
    if (!wrapped) throw new Error(`marrow: ${name} is not linked into this library`);
    if (given.length !== kinds.length) throw new TypeError(`marrow: ${name} takes ${kinds.length} arguments`);
    const lower = [];
    kinds.forEach((kind, i) => lowered(this, kind, given[i], lower));
    const result = wrapped(...lower);
    if (gives === 'text') return this.textAt(result);
    if (gives === 'bool') return result !== 0;
    if (gives === 'number') return result >>> 0;  // WebAssembly's are signed
    if (structs[gives]) return result === 0 ? null : this.view(gives, result);
    return result;
  };
}
