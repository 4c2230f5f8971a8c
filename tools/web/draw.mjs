// Draws the sample character by WebGL 2 in a headless Chromium, and compares with `marrow render`.
// usage: node draw.mjs MARROW BUILT PICTURES      (the program; the folder with newt.mjs and newt.wasm; where to)
// Prints a line a case; exit 1 if a picture differs, GL reports an error or a lost context does not come back.
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { browse, fileIn } from './browser.mjs';
import { kDistance_m, kDt_s, kFrames, kHeight, kWidth, renderAll } from './pictures.mjs';

// Shares of all pixels. Edges within the picture differ, as `marrow render` averages samples of linear colours and a
// canvas does not.
const kMostWrong = 0.005, kLeastInside = 0.05, kMost_s = 400;
const kNearer = 1.5;  // as many pixels must differ from the picture by the other deformer
const kCases = ['ssd', 'as'].flatMap((deformer) => ['ubo', 'texture', 'cpu'].map((how) => ({
  name: `${deformer}_${how}`, deformer, path: how, width: kWidth, height: kHeight, frames: kFrames, dt_s: kDt_s,
  distance_m: kDistance_m })));

const [marrow, built, pictures] = process.argv.slice(2);
const here = import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname);
const web = path.join(here, '../../platform/web');
const work = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-web-'));

function judge(r) {
  const failures = [];
  if (r.errors.length) failures.push(`${r.errors.length} errors of GL, first 0x${r.errors[0].toString(16)}`);
  if (r.wrong > kMostWrong) failures.push('another picture than `marrow render`');
  if (r.wrong_by_other < kNearer * r.wrong) failures.push('not by this deformer');
  if (r.inside < kLeastInside) failures.push('next to nothing is drawn');
  if (r.drawn_while_lost) failures.push('draws while the context is lost');
  if (r.changed) failures.push(`${r.changed} bytes of the picture differ once the context is back`);
  const share = (x) => `${(100 * x).toFixed(3)} %`;
  console.log(`${failures.length ? 'FAILED' : 'ok    '} ${r.name}: ${share(r.wrong)} of pixels differ, ` +
    `${share(r.wrong_by_other)} from the other deformer's, ` +
    `${share(r.inside)} inside, ${share(r.edges)} at edges; ${r.changed} bytes differ after a lost context; ` +
    `slowest frame ${r.slowest_ms.toFixed(0)} ms; ${r.driver}${failures.map((f) => `: ${f}`).join('')}`);
  return failures.length === 0;
}

let good = true, judged = 0;
// The page's own files, what was built, and pictures.
const get = (name) => (name === 'cases' ? JSON.stringify(kCases) : fileIn([here, web, built, work, pictures], name));
function post(name, body) {
  if (name.startsWith('picture/')) fs.writeFileSync(path.join(pictures, path.basename(name)), body);
  if (name === 'result') good = judge(JSON.parse(body)) && good, ++judged;
}
renderAll(marrow, work, pictures);
const failure = await browse('page.html', work, kMost_s, get, post);
if (failure) console.error(`draw: ${failure}`);
process.exit(failure || !good || judged !== kCases.length ? 1 : 0);
