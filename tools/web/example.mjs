// Draws the package's example in a headless Chromium, with SIMD and without, compares with `marrow render`, and lets
// the self-test of marrow::gles3 run.
// usage: node example.mjs MARROW PACKAGE PICTURES      (the program; the package's folder; where to)
// Prints a line each; exit 1 if a picture differs, GL reports an error or another library is fetched.
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { browse, fileIn } from './browser.mjs';
import { renderAll } from './pictures.mjs';

const kMostWrong = 0.005, kLeastInside = 0.05, kNearer = 1.5, kMost_s = 600;  // as those of draw.mjs
const [marrow, built, pictures] = process.argv.slice(2);
const here = import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname);
const work = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-example-'));
const kLibraries = { example_simd: 'marrow-core-simd.wasm', example_plain: 'marrow-core.wasm' };

let fetched = '', good = true, judged = 0;
function get(name) {
  if (name.endsWith('.wasm')) fetched = name;
  const bytes = fileIn([built, here, work, pictures], name);
  if (name !== 'example.html') return bytes;
  return bytes.toString().replace('<canvas', '<script src="watch.js"></script><canvas');
}
function judge(r) {
  const failures = [];
  if (r.errors.length) failures.push(`${r.errors.length} errors of GL, first 0x${r.errors[0].toString(16)}`);
  if (r.wrong > kMostWrong) failures.push('another picture than `marrow render`');
  if (r.wrong_by_other < kNearer * r.wrong) failures.push('not by this deformer');
  if (r.inside < kLeastInside) failures.push('next to nothing is drawn');
  if (fetched !== kLibraries[r.name]) failures.push(`fetches ${fetched}`);
  const share = (x) => `${(100 * x).toFixed(3)} %`;
  console.log(`${failures.length ? 'FAILED' : 'ok    '} ${r.name}, ${fetched}: ${share(r.wrong)} of pixels differ, ` +
    `${share(r.wrong_by_other)} from animation space, ${share(r.inside)} inside` +
    failures.map((f) => `: ${f}`).join(''));
  return failures.length === 0;
}
// Of the paths that WebGL 2 has each is usable; why feedback is none says docs/platforms.md.
function judge_paths({ verdicts, left, texture }) {
  const usable = Object.keys(verdicts).filter((path) => verdicts[path] === 'usable').join(' ');
  console.log(`self-test: usable are ${usable}; ${left.length} errors of GL are left`);
  return usable === 'UBO TEXTURE CPU' && left.length === 0 && texture;
}
function post(name, body) {
  if (name.startsWith('picture/')) fs.writeFileSync(path.join(pictures, path.basename(name)), body);
  if (name === 'result') good = judge(JSON.parse(body)) && good, ++judged;
  if (name === 'verdicts') good = judge_paths(JSON.parse(body)) && good, ++judged;
}
renderAll(marrow, work, pictures);
const failure = await browse('example.html', work, kMost_s, get, post);
if (failure) console.error(`example: ${failure}`);
process.exit(failure || !good || judged !== 3 ? 1 : 0);
