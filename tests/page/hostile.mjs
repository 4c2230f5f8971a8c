// Files that are wrong: each is refused in words or shown, and the page lives on.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { frame, take, withOthers } from './hand.mjs';

const kShort = 40, kLong = 200;

// A generator of numbers in 0 … 1 that gives the same ones each time.
function chance(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function walk(folder) {
  return fs.readdirSync(folder, { withFileTypes: true, recursive: true })
    .filter((one) => one.isFile() && /\.(gltf|glb|vrm|mrw)$/.test(one.name))
    .map((one) => path.join(one.parentPath ?? one.path, one.name)).sort();
}

async function all(t, page, files) {
  let refused = 0, shown = 0;
  for (const file of files) {
    const { error, changed } = await take(page, withOthers(file)).catch((failure) => assert.fail(`${file}: ${failure.message}`));
    if (error) {
      ++refused;
      assert.ok(error.length > 20 && !/undefined|\[object|RuntimeError|unreachable/.test(error), `${file}: ${error}`);
    } else {
      ++shown;
    }
    assert.ok(changed || error, file);
    assert.ok(await page.evaluate(() => !!marrowPage.viewer && !document.getElementById('busy').open), `${file}: nothing is on show`);
  }
  await frame(page);
  return { refused, shown };
}

export const tests = {
  async 'those of the corpus'(t) {
    if (!fs.existsSync(t.corpus)) return 'none are here';
    const { page, troubles, outside } = await t.open({ viewport: { width: 640, height: 500 } });
    if (t.all) page.setDefaultTimeout(300_000);  // some take the program half a minute
    await page.evaluate(() => { globalThis.alive = true; });
    const every = walk(t.corpus), count = t.all ? kLong : kShort, files = [];
    for (let i = 0; i < count; ++i) files.push(every[Math.floor(i * every.length / count)]);
    const { refused, shown } = await all(t, page, files);
    assert.equal(await page.evaluate(() => globalThis.alive), true, 'the page was loaded again');
    assert.deepEqual(troubles, []);
    assert.deepEqual(outside, []);
    assert.ok(refused >= count / 10 && shown >= 1, `${refused} refused, ${shown} shown`);
    return `${refused} refused, ${shown} shown`;
  },
  async 'cooked ones with other bits, and cut off'(t) {
    const { page, troubles } = await t.open({ viewport: { width: 640, height: 500 } });
    const good = fs.readFileSync(path.join(t.folder, 'newt.mrw')), next = chance(7), files = [];
    for (let i = 0; i < (t.all ? 60 : 16); ++i) {
      const bytes = i % 4 === 3 ? good.subarray(0, Math.floor(next() * good.length)) : Buffer.from(good);
      for (let k = 0; i % 4 !== 3 && k < 1 + i; ++k) bytes[Math.floor(next() * bytes.length)] ^= 1 << Math.floor(8 * next());
      files.push(path.join(t.work, `hostile${i}.mrw`));
      fs.writeFileSync(files.at(-1), bytes);
    }
    const { refused, shown } = await all(t, page, files);
    assert.ok(refused > 0);
    assert.deepEqual(troubles, []);
    return `${refused} refused, ${shown} shown`;
  },
  async 'nothing, a text, a folder without a model'(t) {
    const { page } = await t.open({ viewport: { width: 640, height: 500 } });
    const empty = path.join(t.work, 'empty.glb'), text = path.join(t.work, 'readme.txt');
    fs.writeFileSync(empty, '');
    fs.writeFileSync(text, 'no model');
    assert.match((await take(page, [empty])).error, /empty\.glb/);
    assert.match((await take(page, [text])).error, /no model/i);
    assert.ok(await page.evaluate(() => marrowPage.shown.name === 'newt.mrw'), 'the newt stays');
  },
  async 'one of 201 MB is asked about before it is read'(t) {
    const { page } = await t.open({ viewport: { width: 640, height: 500 } });
    await page.evaluate(() => {
      const read = Blob.prototype.arrayBuffer;
      globalThis.reads = 0;
      Blob.prototype.arrayBuffer = function () { ++globalThis.reads; return read.call(this); };
      const transfer = new DataTransfer(), part = new Blob([new Uint8Array(1 << 20)]);
      transfer.items.add(new File(Array(201).fill(part), 'large.glb'));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
    });
    await page.locator('#ask').waitFor({ state: 'visible' });
    const said = await page.locator('#ask').innerText();
    assert.match(said, /GB|MB/);
    await page.keyboard.press('Escape');
    await page.locator('#ask').waitFor({ state: 'hidden' });
    assert.equal(await page.evaluate(() => globalThis.reads), 0);
    assert.equal(await page.locator('#alert p').count(), 0);
    return said.replace(/\s+/g, ' ');
  },
};
