// A link holds what is set.
import assert from 'node:assert/strict';
import { frame, set, settings } from './hand.mjs';

const kWanted = {
  playing: false, speed: 0.5, loop: false, split: 0.3, wireframe: true, grid: true, ghosts: 2,
  orbit: { target: [0.1, 0.6, 0], yaw: 1.25, pitch: 0.5, distance: 3.5 },
};

export const tests = {
  async 'it opens as it was copied'(t) {
    const { page, context } = await t.open({ permissions: ['clipboard-read', 'clipboard-write'] });
    const names = await page.evaluate(() => ({ clips: marrowPage.viewer.about.clips.map((c) => c.name),
                                              joints: marrowPage.viewer.about.joints.map((j) => j.name) }));
    const joint = names.joints.indexOf('forearm.L'), clip = names.clips.indexOf('walk');
    const turns = [{ joint, degrees: [10, -20, 30] }];
    await set(page, { ...kWanted, clip, time_s: 0.7, joint, picked: true, turns });
    await frame(page);
    await page.evaluate(() => document.getElementById('copy-link').click());
    const hash = await page.evaluate(() => location.hash);
    assert.match(hash, /clip=walk/);
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), page.url());
    await context.close();
    const again = await t.open({ hash });
    await frame(again.page);
    const is = await settings(again.page);
    for (const [key, value] of Object.entries({ ...kWanted, clip, joint, picked: true, turns }))
      assert.deepEqual(is[key], value, key);
    assert.ok(Math.abs(is.time_s - 0.7) < 1e-4);
    assert.deepEqual(again.troubles, []);
    return hash;
  },
  async 'one of nonsense opens the newt all the same'(t) {
    const { page, troubles } = await t.open({
      hash: '#clip=no%20such&time_s=-9&split=x&camera=1,2&turn=a,b,c,d&pull=,,,&graph=99&level=1e99&deformer=%00&pair=as,none&options=%zz' });
    const { time_s, orbit } = await frame(page);
    assert.ok(time_s >= 0 && Number.isFinite(orbit.distance));
    assert.equal(await page.locator('#alert p').count(), 0);
    assert.deepEqual(troubles, []);
  },
};
