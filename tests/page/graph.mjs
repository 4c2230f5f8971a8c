// The newt goes by its graph of behaviour.
import assert from 'node:assert/strict';
import { frame, now, set } from './hand.mjs';

const state = async (page, machine) => (await now(page)).states.find((one) => one.machine === machine)?.state;

export const tests = {
  async 'parameters move it, a trigger makes it jump'(t) {
    const { page, troubles } = await t.open({ viewport: { width: 480, height: 400 } });
    await page.locator('#graphs select').selectOption('0');
    await frame(page);
    assert.equal(await state(page, 'body'), 'stand');
    await page.locator('#graphs label', { hasText: 'going' }).locator('input').evaluate((box) => box.click());
    const until = (wanted) => page.waitForFunction((name) =>
      marrowPage.now.states.some(({ machine, state: is }) => machine === 'body' && name.split('|').includes(is)), wanted);
    await until('start|move');
    await until('move');
    await page.locator('#graphs button.trigger', { hasText: 'jump' }).evaluate((button) => button.click());
    await until('jump|air');
    assert.deepEqual(troubles, []);
    await set(page, { graph: -1 });
    await frame(page);
    assert.deepEqual((await now(page)).states, []);
  },
  async 'one that is not there is told, and all else stays'(t) {
    const { page } = await t.open();
    await set(page, { playing: false, time_s: 0.4, wireframe: true });
    await frame(page);
    await set(page, { graph: 7 });
    await page.waitForFunction(() => marrowPage.viewer && document.querySelector('#alert p'));
    assert.match(await page.locator('#alert p').innerText(), /no graph 7/);
    const { time_s } = await frame(page);
    assert.ok(Math.abs(time_s - 0.4) < 1e-6, `${time_s} s`);
    assert.deepEqual(await page.evaluate(() => [marrowPage.settings.graph, marrowPage.settings.wireframe]), [-1, true]);
  },
};
