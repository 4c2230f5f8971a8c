// Who uses it otherwise: axe-core finds nothing, at three widths, light and dark.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';

const kWidths = [390, 820, 1600];

export const tests = Object.fromEntries(kWidths.flatMap((width) => ['light', 'dark'].map((colorScheme) =>
  [`${width} px, ${colorScheme}`, async (t) => {
    const axe = fs.readFileSync(createRequire(path.join(t.packages, '/')).resolve('axe-core/axe.min.js'), 'utf8');
    const { page } = await t.open({ viewport: { width, height: 900 }, colorScheme, reducedMotion: 'reduce', hasTouch: width < 500 });
    for (const details of await page.locator('aside details').all()) await details.evaluate((one) => { one.open = true; });
    await page.evaluate(() => marrowPage.set({ joint: 2, picked: true, colours: 'surface' }));
    await page.evaluate(axe);
    const { violations, passes } = await page.evaluate(() => axe.run({ resultTypes: ['violations'] }));
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join(', ')}`), []);
    const small = await page.evaluate(() => [...document.querySelectorAll('button, select, input[type=range], [role=option], summary, .check')]
      .filter((one) => one.offsetParent && one.getBoundingClientRect().height < 32).map((one) => one.textContent || one.id));
    assert.deepEqual(small, [], 'targets that are less than 32 px high');
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, `the page is ${wide} px wider than the window`);
    return `${passes.length} rules`;
  }])));
