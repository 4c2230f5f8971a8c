// Tests of the page in a headless Chromium; tools/check/page.sh calls it.
// usage: node tests/page/run.mjs MARROW SITE PACKAGES [NAME ...]
// The program; the folder of the built site; where npm has installed tools/page/package.json; files beside this one by
// their names, or all of them. MARROW_TESTS=all: with what takes minutes. MARROW_ASSETS, MARROW_CORPUS: models, and files
// that are wrong. Prints a line a test; exit 1 if one fails.
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { launch, open, serve } from './browser.mjs';

const kFiles = ['start', 'hands', 'link', 'graph', 'lost', 'models', 'hostile', 'access', 'soak'];
const [marrow, folder, packages, ...wanted] = process.argv.slice(2).map((word, i) => i < 3 ? path.resolve(word) : word);
const root = path.join(import.meta.dirname, '../..');
const beside = (name, variable) => process.env[variable] ?? path.join(root, '../shared', name);

const site = await serve(folder), browser = await launch(packages);
const work = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-page-'));
const t = {
  marrow, folder, packages, root, work, site, browser,
  all: process.env.MARROW_TESTS === 'all', assets: beside('assets', 'MARROW_ASSETS'), corpus: beside('corpus', 'MARROW_CORPUS'),
  // By how much this machine is slower than an idle one.
  slower: () => Math.max(1, os.loadavg()[0] / os.cpus().length),
  open: (options) => open(browser, site, { slower: t.slower(), ...options }),
};
if (!fs.existsSync(t.assets)) console.log(`no models at ${t.assets}: only the project's own are tried`);
if (!fs.existsSync(t.corpus)) console.log(`no wrong files at ${t.corpus}: those of tests/page alone are tried`);
let failures = 0, count = 0;
for (const file of wanted.length > 0 ? wanted : kFiles) {
  const { tests } = await import(`./${file}.mjs`);
  for (const [name, test] of Object.entries(tests)) {
    const began = performance.now();
    let said = '', failure;
    try {
      said = await test(t) ?? '';
    } catch (error) {
      failure = error;
      ++failures;
    }
    ++count;
    console.log(`${failure ? 'FAILED' : 'ok    '} ${file}: ${name}${said ? `: ${said}` : ''} ` +
      `(${((performance.now() - began) / 1000).toFixed(1)} s)${failure ? `\n${failure.stack ?? failure}` : ''}`);
    for (const context of browser.contexts()) await context.close();
  }
}
await browser.close();
site.close();
fs.rmSync(work, { recursive: true, force: true });
console.log(`${count} tests, ${failures} failed`);
process.exit(failures > 0 || count === 0 ? 1 : 0);
