// Cooks by cook.wasm in node, as a page would: node tools/cook/wasm.mjs cook.wasm IN OUT.mrw [OPTIONS, as marrow.toml]
import {existsSync, readFileSync, writeFileSync} from "node:fs";
import {basename, dirname, join} from "node:path";

const [wasm, input, output, options = ""] = process.argv.slice(2);
let exports;
const bytesAt = (at, size) => Buffer.from(exports.memory.buffer, at, size);
const put = (bytes) => {
  const at = exports.take_memory(bytes.length);
  bytesAt(at, bytes.length).set(bytes);
  return at;
};
const stages = ["read", "prepare", "clip", "mesh", "learn", "write"];
const marrow = {
  read(name, length, most, size) {
    const path = join(dirname(input), bytesAt(name, length).toString());
    if (!existsSync(path)) return 0;
    const bytes = readFileSync(path).subarray(0, most);
    const at = put(bytes);
    bytesAt(size, 4).writeUInt32LE(bytes.length);
    return at;
  },
  progress(stage, done, count) {
    if (count === 0) console.log(stages[stage]);
  },
  failed(at, length, code) {
    throw Object.assign(new Error(bytesAt(at, length).toString()), {code});
  },
};
// Nothing of it is called: libc++ could print, and asks for its locale.
const wasi = new Proxy({}, {get: (_, name) => () => { throw new Error(`the cooker calls ${name}`); }});

const module = new WebAssembly.Module(readFileSync(wasm));
exports = new WebAssembly.Instance(module, {marrow, wasi_snapshot_preview1: wasi}).exports;
try {
  exports._initialize();
  const name = Buffer.from(basename(input)), toml = Buffer.from(options);
  exports.cook(put(name), name.length, put(toml), toml.length);
  writeFileSync(output, bytesAt(exports.file(), exports.file_size()));
  const report = JSON.parse(bytesAt(exports.report(), exports.report_size()).toString());
  console.log(`${exports.file_size()} bytes, ${report.warnings.length} warnings`);
} catch (failure) {
  if (failure.code === undefined) throw failure;
  console.error(failure.message);
  process.exit(failure.code);
}
