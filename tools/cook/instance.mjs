// Calls cook.wasm, in a page and in node.
const decoder = new TextDecoder();
const encoder = new TextEncoder();
export const stages = ['read', 'prepare', 'clip', 'mesh', 'learn', 'write'];

// What the cooker cannot do, in its own words. code: as the program's exit codes.
export class CookFailure extends Error {
  constructor(message, code) {
    super(message);
    this.name = 'CookFailure';
    this.code = code;
  }
}

const kInternal = 5;
const kNearItsEnd = 65536;  // bytes of the stack
const kPages = 'a page has 4 GiB at most, and less on small devices; the program marrow cooks what is larger';

// What a trap was, in plain words. `exports`: of the instance, undefined if it was never made.
function explain(trap, name, exports) {
  const used = exports ? ` at ${exports.memory.buffer.byteLength >> 20} MiB` : '';
  const deep = exports && exports.__stack_pointer.value < kNearItsEnd;
  if (deep || /call stack|recursion/i.test(trap.message))
    return `${name}: nested too deep for the cooker's stack; report it as a mistake of Marrow's`;
  if (trap instanceof RangeError) return `${name}: out of memory${used}; ${kPages}`;
  if (trap instanceof WebAssembly.RuntimeError)
    return `${name}: internal error: the cooker stopped${used}: ${trap.message}`;
  return `${name}: internal error: ${trap.message}`;
}

// Cooks the file of this name. options: text as marrow.toml has it. read(name): bytes of a file, or null. progress(stage,
// done, count): 0 of 0 as a stage begins. Throws CookFailure, whatever goes wrong in there. Each call has an instance of
// its own, as a failure ends it.
export function cook(module, name, options, read, progress = () => {}) {
  let exports;
  const bytes = (at, size) => new Uint8Array(exports.memory.buffer, at >>> 0, size >>> 0);
  const outOfMemory = () =>
    new CookFailure(`${name}: out of memory at ${exports.memory.buffer.byteLength >> 20} MiB; ${kPages}`, kInternal);
  const put = (text) => {
    const from = encoder.encode(text), at = exports.take_memory(Math.max(from.length, 1));
    if (at === 0) throw outOfMemory();
    bytes(at, from.length).set(from);
    return [at, from.length];
  };
  const file = (at, length) => read(decoder.decode(bytes(at, length)));
  const marrow = {
    size: (at, length) => file(at, length)?.length ?? -1,
    read: (at, length, to, count) => bytes(to, count).set(file(at, length).subarray(0, count)),
    progress: (stage, done, count) => progress(stages[stage], done, count),
    failed(at, length, code) {
      const text = decoder.decode(bytes(at, length));
      throw text === 'out of memory' ? outOfMemory() : new CookFailure(text, code);
    },
  };
  // Nothing of it is called: libc++ could print, and asks for its locale.
  const wasi = new Proxy({}, { get: (_, call) => () => { throw new Error(`the cooker calls ${String(call)}`); } });
  try {
    exports = new WebAssembly.Instance(module, { marrow, wasi_snapshot_preview1: wasi }).exports;
    exports._initialize();
    exports.cook(...put(name), ...put(options));
    const report = JSON.parse(decoder.decode(bytes(exports.report(), exports.report_size())));
    report.output = { file: name.replace(/(\.[^./]*)?$/, '.mrw'), ...report.output };
    return { file: bytes(exports.file(), exports.file_size()).slice(), report,
             memory_bytes: exports.memory.buffer.byteLength };
  } catch (failure) {
    if (failure instanceof CookFailure) throw failure;
    throw new CookFailure(explain(failure, name, exports), kInternal);
  }
}
