// Cooks by cook.wasm in node, as a page would: node tools/cook/wasm.mjs cook.wasm IN OUT.mrw [OPTIONS, as marrow.toml]
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { cook, CookFailure } from './instance.mjs';

const [wasm, input, output, options = ''] = process.argv.slice(2);
const read = (name) => {
  const path = join(dirname(input), name);
  return statSync(path, { throwIfNoEntry: false })?.isFile() ? readFileSync(path) : null;
};
const progress = (stage, done, count) => count === 0 && console.log(stage);
try {
  const cooked = cook(new WebAssembly.Module(readFileSync(wasm)), basename(input), options, read, progress);
  writeFileSync(output, cooked.file);
  console.log(`${cooked.file.length} bytes, ${cooked.report.warnings.length} warnings`);
} catch (failure) {
  if (!(failure instanceof CookFailure)) throw failure;
  console.error(failure.message);
  process.exit(failure.code);
}
