// A context that is lost comes back to the same picture.
import assert from 'node:assert/strict';
import { differ, download, frame, set } from './hand.mjs';

export const tests = {
  async 'the same picture once it is back'(t) {
    const { page, troubles } = await t.open();
    await set(page, { playing: false, time_s: 0.5, grid: true });
    await frame(page);
    const before = await download(page, 'save-picture');
    const loses = () => page.evaluate(() => {
      globalThis.loser ??= document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
      globalThis.loser.loseContext();
    });
    for (let i = 0; i < 2; ++i) {
      await loses();
      await page.waitForFunction(() => !marrowPage.viewer);
      await page.evaluate(() => marrowPage.set({ level: 0 }));  // hands go on
      await page.evaluate(() => setTimeout(() => globalThis.loser.restoreContext(), 50));
      await page.waitForFunction(() => marrowPage.viewer);
      await frame(page);
    }
    const after = await download(page, 'save-picture');
    const { wrong, busy, size } = await differ(page, before.bytes, after.bytes);
    assert.equal(size, undefined);
    assert.ok(busy > 0.01, 'nothing is drawn');
    assert.equal(wrong, 0);
    assert.equal(await page.locator('#alert p').count(), 0);
    assert.deepEqual(troubles.filter((text) => !/CONTEXT_LOST|context.*lost/i.test(text)), []);
  },
};
