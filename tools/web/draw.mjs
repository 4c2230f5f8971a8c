// Draws the sample character by WebGL 2 in a headless Chromium, and compares with `marrow render`.
// usage: node draw.mjs MARROW BUILT PICTURES      (the program; the folder with newt.mjs and newt.wasm; where to)
// Prints a line a case; exit 1 if a picture differs, GL reports an error or a lost context does not come back.
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import { execFileSync, spawn } from 'node:child_process';

// Shares of all pixels. Edges within the picture differ, as `marrow render` averages samples of linear colours and a
// canvas does not.
const kMostWrong = 0.005, kLeastInside = 0.05, kMost_s = 400;
const kNearer = 1.5;  // as many pixels must differ from the picture by the other deformer
const kWidth = 640, kHeight = 480, kDistance_m = 4.6, kFrames = 32, kDt_s = 1 / 64;  // exact in binary
const kCases = ['ssd', 'as'].flatMap((deformer) => ['ubo', 'texture', 'cpu'].map((how) => ({
  name: `${deformer}_${how}`, deformer, path: how, width: kWidth, height: kHeight, frames: kFrames, dt_s: kDt_s,
  distance_m: kDistance_m })));

const [marrow, built, pictures] = process.argv.slice(2);
const here = import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname);
const root = path.join(here, '../..'), web = path.join(root, 'platform/web');
const work = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-web-'));
fs.mkdirSync(pictures, { recursive: true });

// The sample, its materials without light, which is what newt.cpp draws; with a colour that one instead of its own.
function write_variant(to, colour) {
  const glb = fs.readFileSync(path.join(root, 'tools/sample/newt.glb')), size = glb.readUInt32LE(12);
  const json = JSON.parse(glb.toString('utf8', 20, 20 + size));
  json.extensionsUsed = [...(json.extensionsUsed ?? []), 'KHR_materials_unlit'];
  for (const material of json.materials) {
    material.extensions = { KHR_materials_unlit: {} };
    if (colour) material.pbrMetallicRoughness.baseColorFactor = colour;
  }
  if (colour) for (const mesh of json.meshes) for (const part of mesh.primitives) delete part.attributes.COLOR_0;
  const text = Buffer.from(JSON.stringify(json)), padded = Buffer.alloc(Math.ceil(text.length / 4) * 4, ' ');
  text.copy(padded);
  const head = Buffer.from(glb.subarray(0, 20)), rest = glb.subarray(20 + size);
  head.writeUInt32LE(20 + padded.length + rest.length, 8);
  head.writeUInt32LE(padded.length, 12);
  fs.writeFileSync(to, Buffer.concat([head, padded, rest]));
}

const run = (...words) => execFileSync(marrow, words, { stdio: ['ignore', 'ignore', 'pipe'] });
// Smoothed, so that animation space is another picture than SSD; not packed.
function cook(from, to) {
  run('cook', from, '--as', 'smooth', '--mesh-codec', 'none', '--clip-codec', 'raw', '-o', to);
}
function render_all() {
  cook(path.join(root, 'tools/sample/newt.glb'), path.join(work, 'newt.mrw'));
  for (const [name, colour] of [['plain', null], ['red', [1, 0, 0, 1]], ['green', [0, 1, 0, 1]]]) {
    const model = path.join(work, `${name}.glb`), cooked = path.join(work, `${name}.mrw`);
    write_variant(model, colour);
    cook(model, cooked);
    for (const deformer of ['ssd', 'as'])
      run('render', cooked, '--clip', 'walk', '--time', String(kFrames * kDt_s), '--deformer', deformer,
        '--normals', 'blended', '--look-at', 'pelvis', '--distance', String(kDistance_m),
        '--size', `${kWidth}x${kHeight}`, '-o', path.join(pictures, `${name}_${deformer}.png`));
  }
}

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

// The page's own files, what was built, and pictures.
const kTypes = { '.html': 'text/html', '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.png': 'image/png' };
function file_of(name) {
  return [path.join(here, name), path.join(web, name), path.join(built, name), path.join(work, name),
          path.join(pictures, name)].find((file) => fs.existsSync(file));
}
const body_of = async (request) => {
  const parts = [];
  for await (const part of request) parts.push(part);
  return Buffer.concat(parts);
};

let good = true, judged = 0;
function serve(done) {
  return http.createServer(async (request, response) => {
    const name = path.basename(request.url);
    if (request.method === 'POST') {
      const body = await body_of(request);
      if (request.url.startsWith('/picture/')) fs.writeFileSync(path.join(pictures, name), body);
      if (name === 'result') good = judge(JSON.parse(body)) && good, ++judged;
      response.end();
      if (name === 'done') done('');
      if (name === 'failed') done(body.toString());
      return;
    }
    const file = file_of(name);
    response.writeHead(name === 'cases' || file ? 200 : 404,
      { 'content-type': kTypes[path.extname(name)] ?? 'application/octet-stream' });
    response.end(name === 'cases' ? JSON.stringify(kCases) : file && fs.readFileSync(file));
  });
}

render_all();
let chromium;
const failure = await new Promise((done) => {
  const server = serve(done).listen(0, '127.0.0.1', () => {
    chromium = spawn('chromium', ['--headless=new', '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--disable-gpu-watchdog', '--disable-hang-monitor',
      '--disable-dev-shm-usage', '--disable-quic', '--no-first-run', '--disable-background-networking',
      '--disable-component-update', '--disable-sync', `--user-data-dir=${path.join(work, 'profile')}`,
      `http://127.0.0.1:${server.address().port}/page.html`], { stdio: ['ignore', 'ignore', 'pipe'], detached: true });
    chromium.stderr.on('data', (text) => process.env.MARROW_VERBOSE && process.stderr.write(text));
    chromium.on('error', (error) => done(error.message));
    chromium.on('exit', () => done('Chromium ended before the page did'));
  });
  setTimeout(() => done(`the page takes more than ${kMost_s} s`), 1000 * kMost_s).unref();
});
chromium.removeAllListeners('exit');
const ended = new Promise((done) => chromium.on('exit', done));
// Its processes are a group, so that none is left that writes to the profile.
if (chromium.pid && chromium.exitCode === null && process.kill(-chromium.pid, 'SIGKILL')) await ended;
try {
  fs.rmSync(work, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 });
} catch (error) {
  console.error(`draw: ${work} is left behind: ${error.code}`);
}
if (failure) console.error(`draw: ${failure}`);
process.exit(failure || !good || judged !== kCases.length ? 1 : 0);
