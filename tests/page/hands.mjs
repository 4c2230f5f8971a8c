// The keyboard, fingers and the mouse.
import assert from 'node:assert/strict';
import { frame, now, set, settings } from './hand.mjs';

const share = (page) => page.evaluate(() => document.querySelector('#divide').getAttribute('aria-valuenow'));
const middle = (page, joint) => page.evaluate((index) => {
  const box = document.getElementById('canvas').getBoundingClientRect(), places = marrowPage.viewer.places();
  return [box.left + box.width * places[3 * index], box.top + box.height * places[3 * index + 1]];
}, joint);

export const tests = {
  async 'the keyboard plays, steps, divides and asks for help'(t) {
    const { page } = await t.open();
    await page.waitForFunction(() => marrowPage.now);
    await page.locator('body').press(' ');
    assert.equal((await settings(page)).playing, false);
    await page.locator('body').press('Home');
    const rate = await page.evaluate(() => marrowPage.viewer.about.clips[marrowPage.settings.clip].rate_hz);
    for (let i = 0; i < 3; ++i) await page.locator('body').press('ArrowRight');
    assert.ok(Math.abs((await settings(page)).time_s * rate - 3) < 1e-3, 'three frames on');
    await page.locator('body').press('ArrowLeft');
    assert.ok(Math.abs((await frame(page)).time_s * rate - 2) < 1e-3, 'one back');
    await page.locator('#divide').focus();
    for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowLeft');
    assert.equal(await share(page), '40');
    assert.ok(Math.abs((await settings(page)).time_s * rate - 2) < 1e-3, 'the handle alone moves');
    await page.keyboard.press('End');
    assert.equal(await share(page), '98');
    await page.locator('body').press('3');
    assert.equal((await settings(page)).colours, 'distance');
    await page.keyboard.press('?');
    assert.ok(await page.locator('#help').isVisible());
    await page.keyboard.press('Escape');
    assert.ok(!(await page.locator('#help').isVisible()));
  },
  async 'the list of joints goes by arrow keys, and finds names'(t) {
    const { page } = await t.open();
    await page.locator('#joints summary').click();
    await page.locator('#joints [role=listbox]').focus();
    for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowDown');
    const { joint, picked } = await settings(page);
    assert.deepEqual([joint, picked], [2, true]);
    await page.locator('#joints input[type=text]').fill('hand');
    const shown = await page.locator('#joints [role=option]:visible').allTextContents();
    assert.ok(shown.length > 0 && shown.every((name) => name.includes('hand')), shown.join(' '));
  },
  async 'a tap chooses the joint below it'(t) {
    const { page } = await t.open({ hasTouch: true, viewport: { width: 390, height: 844 } });
    await set(page, { playing: false, time_s: 0, split: 1 });  // the handle between the halves covers no joint
    await frame(page);
    const joints = await page.evaluate(() => marrowPage.viewer.about.joints.map(({ name }) => name));
    const wanted = joints.indexOf('hand.L');
    const [x, y] = await middle(page, wanted);
    await page.touchscreen.tap(x, y);
    const { joint, picked } = await settings(page);
    assert.ok(picked);
    const [tx, ty] = await middle(page, joint);
    assert.ok(Math.hypot(tx - x, ty - y) <= Math.hypot(1, 1), `${joints[joint]} is chosen, ${Math.hypot(tx - x, ty - y)} px off`);
  },
  async 'one finger turns, two come nearer'(t) {
    const { page, context } = await t.open({ hasTouch: true, viewport: { width: 390, height: 844 } });
    await set(page, { playing: false });
    const first = (await frame(page)).orbit;
    const box = await page.locator('#canvas').boundingBox(), x = box.x + box.width / 4, y = box.y + box.height / 2;
    const session = await context.newCDPSession(page);
    const touch = (type, ...points) => session.send('Input.dispatchTouchEvent',
      { type, touchPoints: points.map(([px, py], id) => ({ x: px, y: py, id })) });
    await touch('touchStart', [x, y]);
    for (let i = 1; i <= 5; ++i) await touch('touchMove', [x + 10 * i, y]);
    await touch('touchEnd');
    const turned = (await frame(page)).orbit;
    assert.ok(Math.abs(turned.yaw - first.yaw) > 0.1 && turned.distance === first.distance, 'it turns');
    await touch('touchStart', [x, y], [x + 40, y]);
    for (let i = 1; i <= 5; ++i) await touch('touchMove', [x - 4 * i, y], [x + 40 + 4 * i, y]);
    await touch('touchEnd');
    const near = (await frame(page)).orbit;
    // Twice as far apart: half as far away.
    assert.ok(Math.abs(near.distance / turned.distance - 0.5) < 0.1, `${turned.distance} m became ${near.distance} m`);
    assert.ok(Math.abs(near.yaw - turned.yaw) < 1e-6);
  },
  async 'a joint is pulled to where it is dragged'(t) {
    const { page, troubles } = await t.open();
    await set(page, { playing: false, time_s: 0 });
    const joint = await page.evaluate(() => marrowPage.viewer.about.joints.findIndex(({ name }) => name === 'hand.L'));
    await set(page, { joint, picked: true });
    await frame(page);
    await page.evaluate(() => document.getElementById('pull').click());
    await frame(page);
    const [x, y] = await middle(page, joint);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 10, y - 15, { steps: 4 });
    await page.mouse.up();
    const { trouble } = await frame(page);
    const [tx, ty] = await middle(page, joint);
    assert.equal(trouble, '');
    assert.ok(Math.hypot(tx - x - 10, ty - y + 15) < 2, `the hand is ${tx - x}, ${ty - y} px off where it was`);
    assert.deepEqual(troubles, []);
  },
  async 'nothing covers a control that is gone to by keyboard'(t) {
    for (const [width, height] of [[390, 700], [820, 620]]) {
      const { page } = await t.open({ viewport: { width, height }, reducedMotion: 'reduce' });
      const covered = await page.evaluate(() => {
        for (const details of document.querySelectorAll('aside details')) details.open = true;
        return [...document.querySelectorAll('aside :is(input, select, button, summary)')].filter((one) => {
          if (!one.offsetParent || one.disabled) return false;
          one.focus();
          const box = one.getBoundingClientRect(), x = box.left + box.width / 2, y = box.top + box.height / 2;
          const top = document.elementFromPoint(x, y);
          return !(top === one || one.contains(top) || top?.closest('label')?.contains(one));
        }).map((one) => one.closest('label')?.textContent || one.textContent);
      });
      assert.deepEqual(covered, [], `at ${width}x${height}`);
    }
  },
  async 'what stands still is not drawn again'(t) {
    const { page } = await t.open();
    await set(page, { playing: false });
    await page.waitForFunction(() => marrowPage.settings.coarseness === 1);
    await page.waitForTimeout(500);
    const drawn = await page.evaluate(async () => {
      let frames = 0;
      marrowPage.on('frame', () => { ++frames; });
      await new Promise((done) => setTimeout(done, 700));
      return frames;
    });
    assert.equal(drawn, 0);
    assert.ok(await now(page));
  },
};
