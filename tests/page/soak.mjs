// Memory: what plays, and files that come and go, take no more of it.
import assert from 'node:assert/strict';
import path from 'node:path';
import { frame, take } from './hand.mjs';

const kMostGrowth = 4e6;  // bytes, of JavaScript and of WebAssembly

const heap = (page) => page.evaluate(() => {
  gc();
  gc();
  return { js: performance.memory.usedJSHeapSize, wasm: marrowPage.viewer.exports.memory.buffer.byteLength };
});

export const tests = {
  async 'it plays'(t) {
    const seconds = Number(process.env.MARROW_SOAK_S ?? (t.all ? 60 : 6));
    const { page, troubles } = await t.open({ viewport: { width: 480, height: 400 } });
    await page.waitForTimeout(2000);
    const before = await heap(page);
    await page.waitForTimeout(1000 * seconds);
    const after = await heap(page);
    assert.ok(after.js - before.js < kMostGrowth, `${after.js - before.js} B more of JavaScript`);
    assert.equal(after.wasm, before.wasm);
    assert.deepEqual(troubles, []);
    return `${seconds} s, ${((after.js - before.js) / 1e3).toFixed(0)} kB of JavaScript more, ${(after.wasm / 1e6).toFixed(0)} MB of WebAssembly`;
  },
  async 'files come and go'(t) {
    const { page } = await t.open({ viewport: { width: 480, height: 400 } });
    const files = ['dance.gltf', 'elbow.gltf'].map((name) => path.join(t.root, 'tests/golden', name));
    const rounds = t.all ? 20 : 4;
    for (const file of files) assert.equal((await take(page, [file])).error, '');
    await frame(page);
    const before = await heap(page);
    for (let i = 0; i < rounds; ++i) assert.equal((await take(page, [files[i % 2]])).error, '');
    await frame(page);
    const after = await heap(page);
    assert.ok(after.js - before.js < kMostGrowth, `${after.js - before.js} B more of JavaScript after ${rounds} files`);
    return `${rounds} files, ${((after.js - before.js) / 1e3).toFixed(0)} kB more`;
  },
};
