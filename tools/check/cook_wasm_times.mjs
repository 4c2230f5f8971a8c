// Measures the cooker in WebAssembly against the program on one thread: pairs of runs in turn, the least of each. Seconds
// are a thread's own, so that other work counts little. Prints rows of the table in docs/cooking/library.md.
// usage: node cook_wasm_times.mjs MARROW cook.wasm RUNS MODEL ...
import { execFileSync } from 'node:child_process';
import { readFileSync, statSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { cook } from '../cook/instance.mjs';

const kProgram = `import resource, subprocess, sys
subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(used.ru_utime + used.ru_stime, used.ru_maxrss * 1024)`;
const kTick_s = 0.01;  // of /proc
const [marrow, wasm, runs, ...models] = process.argv.slice(2);

// Seconds of processor of this thread, without those that compile WebAssembly.
function threadSeconds() {
  const fields = readFileSync(`/proc/self/task/${process.pid}/stat`, 'utf8').split(') ')[1].split(' ');
  return kTick_s * (Number(fields[11]) + Number(fields[12]));
}

const program = (model) => execFileSync(
  'python3', ['-c', kProgram, marrow, 'cook', model, '-o', '/dev/shm/marrow.mrw', '--jobs', '1'])
  .toString().split(' ').map(Number);

function page(model) {
  const read = (name) => {
    const path = join(dirname(model), name);
    return statSync(path, { throwIfNoEntry: false }) ? readFileSync(path) : null;
  };
  const module = new WebAssembly.Module(readFileSync(wasm)), began = threadSeconds();  // a new one, as a page has
  const { memory_bytes } = cook(module, basename(model), '', read);
  return [threadSeconds() - began, memory_bytes];
}

const least = (pairs) => pairs[0].map((_, i) => Math.min(...pairs.map((pair) => pair[i])));
for (const model of models) {
  const theirs = [], ours = [];
  for (let run = 0; run < Number(runs); run++) {
    theirs.push(program(model));
    ours.push(page(model));
  }
  const [program_s, program_bytes] = least(theirs), [page_s, page_bytes] = least(ours);
  const mib = (bytes) => (bytes / 2 ** 20).toFixed(0);
  const seconds = [program_s, page_s, page_s / program_s].map((value) => value.toFixed(2)).join(' | ');
  console.log(`| ${basename(model)} | ${(statSync(model).size / 1e6).toFixed(2)} | ${seconds} | ${mib(program_bytes)} | ${mib(page_bytes)} |`);
}
