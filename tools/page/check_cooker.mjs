// Cooks by cooker.js and its worker in node, as a page does. Exit 1 if anything is other than it should be.
// usage: node check_cooker.mjs SITE NEWT.glb NEWT.mrw      (the folder of cooker.js, cook_worker.js and cook.wasm; what the
// program makes of the newt)
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Worker as Thread } from 'node:worker_threads';

const [site, glb, cooked] = process.argv.slice(2).map((path) => resolve(path));

// A browser's Worker, on one of node's threads.
const kInside = `
const { parentPort, workerData } = require('node:worker_threads');
globalThis.self = globalThis;
globalThis.postMessage = (what, transfer) => parentPort.postMessage(what, transfer);
globalThis.fetch = async (url) =>
  new Response(require('node:fs').readFileSync(url), { headers: { 'content-type': 'application/wasm' } });
const waiting = import(workerData);
parentPort.on('message', async (data) => { await waiting; globalThis.onmessage({ data }); });`;
let made = 0;
globalThis.Worker = class {
  constructor(url) {
    made++;
    this.thread = new Thread(kInside, { eval: true, workerData: url.href });
    this.thread.on('message', (data) => this.onmessage?.({ data }));
    this.thread.on('error', (error) => this.onerror?.({ message: error.message }));
  }
  postMessage(what) { this.thread.postMessage(what); }
  terminate() { this.thread.terminate(); }
};

const { cook, CookFailure } = await import(pathToFileURL(join(site, 'cooker.js')));
const never = new AbortController().signal;
const quiet = () => {};
const newt = new Uint8Array(readFileSync(glb));
const expected = readFileSync(cooked);
const failure = async (document, files, options = '') =>
  cook(document, files, options, quiet, never).then(() => assert.fail('it cooked'), (error) => {
    assert.ok(error instanceof CookFailure, error);
    return error;
  });
let tried = 0;
const test = async (what, f) => {
  await f();
  tried++;
};

await test('the program\'s bytes, and stages in their order', async () => {
  const told = [];
  const got = await cook('newt.glb', new Map([['newt.glb', newt]]), '', (...what) => told.push(what), never);
  assert.ok(expected.equals(got.file));
  const began = told.filter(([, , count]) => count === 0).map(([stage]) => stage);
  assert.deepEqual(began.filter((stage) => stage !== 'learn'), ['read', 'prepare', 'mesh', 'clip', 'write']);
  assert.ok(told.some(([stage, done, count]) => stage === 'clip' && count > 0 && done === count));
  assert.ok(got.seconds > 0 && got.memory_bytes > newt.length);
  assert.equal(got.report.output.bytes, got.file.length);
  assert.equal(got.report.output.file, 'newt.mrw');
  writeFileSync(join(site, 'newt.json'), JSON.stringify(got.report));
  assert.equal(newt.length, readFileSync(glb).length);  // the page's bytes are still its own
});

// A dance whose bytes stand in a file of their own.
const json = JSON.parse(readFileSync(join(import.meta.dirname, '../../tests/golden/dance.gltf')));
const bin = new Uint8Array(Buffer.from(json.buffers[0].uri.split(',')[1], 'base64'));
json.buffers[0].uri = 'parts/the%20dance.bin';
const text = new TextEncoder().encode(JSON.stringify(json));
const dance = async (...files) => Buffer.from(
  (await cook('dance.gltf', new Map([['dance.gltf', text], ...files]), '', quiet, never)).file);
const exact = await dance(['parts/the dance.bin', bin], ['other/the dance.bin', text]);
await test('files are found by their path, or by their name alone', async () => {
  assert.ok(exact.equals(await dance(['some/where/The Dance.bin', bin])));
  assert.ok(exact.equals(await dance(['a/parts/the dance.bin', bin], ['b/the dance.bin', text])));
});
await test('what is missing is said with its place', async () => {
  const { message, code } = await failure('dance.gltf', new Map([['dance.gltf', text]]));
  assert.equal(code, 2);
  assert.match(message, /^dance\.gltf: \/buffers\/0\S*: no such file: drop parts\/the dance\.bin together with the model$/);
  const several = new Map([['dance.gltf', text], ['a/the dance.bin', bin], ['b/the dance.bin', bin]]);
  assert.equal((await failure('dance.gltf', several)).code, 2);
});
await test('bad files and options are refused in the cooker\'s words', async () => {
  const wrong = new TextEncoder().encode('{"asset": {"version": "2.0"}, "nodes": 3}');
  const bad = await failure('bad.gltf', new Map([['bad.gltf', wrong]]));
  assert.equal(bad.code, 3);
  assert.match(bad.message, /^bad\.gltf: \/nodes: /);
  const files = new Map([['newt.glb', newt]]);
  assert.match((await failure('newt.glb', files, 'clip-error = ')).message, /^options: 1:\d+: no TOML: /);
  assert.match((await failure('newt.glb', files, 'clip-eror = 1')).message, /^options: 1:1: /);
  const skeleton = await failure('newt.glb', files, "auto-skeleton = 'cow.toml'");
  assert.equal(skeleton.code, 1);
  assert.match(skeleton.message, /^--auto-skeleton: "cow\.toml" is neither built in nor a file: /);
});
await test('a cook is cancelled, and the next one works', async () => {
  const files = new Map([['newt.glb', newt]]), cancel = new AbortController(), waiting = new AbortController();
  const before = made;
  const first = cook('newt.glb', files, '', (stage) => stage === 'mesh' && cancel.abort(), cancel.signal);
  const second = cook('newt.glb', files, '', quiet, waiting.signal);
  const third = dance(['the dance.bin', bin]);
  waiting.abort();
  await assert.rejects(second, { name: 'AbortError' });
  await assert.rejects(first, { name: 'AbortError' });
  assert.ok(exact.equals(await third));
  assert.equal(made, before + 1);
  await assert.rejects(cook('newt.glb', files, '', quiet, AbortSignal.abort()), { name: 'AbortError' });
});
console.log(`a page's cooker: ${tried} tests passed`);
process.exit(0);
