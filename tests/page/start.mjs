// What comes first: the newt at once, from the page's own files alone, within its budget of bytes.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';
import { frame } from './hand.mjs';

const kFirst_s = 2;
const kBudgets = { 'viewer.wasm': 420_000, 'cook.wasm': 1_500_000, 'main.js': 25_000, 'style.css': 6_000, 'newt.mrw': 260_000 };

export const tests = {
  async 'the newt moves within two seconds'(t) {
    const { page, troubles, outside } = await t.open();
    await page.waitForFunction(() => marrowPage.now);
    const [first_s, load_s] = await page.evaluate(() => [performance.getEntriesByName('first picture')[0].startTime / 1000,
                                                         performance.getEntriesByType('navigation')[0].loadEventEnd / 1000]);
    const before = await frame(page);
    await page.waitForTimeout(300);
    const after = await frame(page);
    assert.notEqual(after.time_s, before.time_s, 'nothing moves');
    assert.ok(await page.evaluate(() => marrowPage.viewer.about.clips[marrowPage.settings.clip].duration_s > 0), 'the rest pose');
    assert.deepEqual(troubles, []);
    assert.deepEqual(outside, []);
    const said = `the first picture comes ${(first_s - load_s).toFixed(2)} s after the page is loaded, ${first_s.toFixed(2)} s after it is asked for`;
    assert.ok(first_s - load_s < kFirst_s * t.slower(), said);
    return `${said}, at ${t.slower().toFixed(1)} times the load of an idle machine`;
  },
  async 'it asks for its own files, and they are there'(t) {
    t.site.asked.length = 0;
    const { page } = await t.open();
    await page.waitForFunction(() => marrowPage.viewer?.about.deformers.includes('plain'));
    const asked = t.site.asked.map((address) => address.replace(/^\/|\?.*$/g, '')).sort();
    assert.deepEqual(asked, ['index.html', 'main.js', 'newt.mrw', 'newt_plain.mrw', 'style.css', 'viewer.wasm']);
    return asked.join(' ');
  },
  async 'the policy stands'(t) {
    const { page } = await t.open();
    const broken = await page.evaluate(async () => {
      const out = [];
      addEventListener('securitypolicyviolation', (event) => out.push(event.effectiveDirective));
      const script = document.createElement('script');
      script.textContent = 'globalThis.inlineRan = true';
      const picture = new Image();
      picture.src = 'http://127.0.0.1:1/picture.png';
      const style = document.createElement('style');
      style.textContent = 'body { color: red }';
      document.head.append(script, style, picture);
      await fetch('http://127.0.0.1:1/').catch(() => {});
      await new Promise((done) => setTimeout(done, 100));
      return { out: out.sort(), ran: globalThis.inlineRan ?? false };
    });
    assert.deepEqual(broken, { out: ['connect-src', 'img-src', 'script-src-elem', 'style-src-elem'], ran: false });
  },
  async 'it is small'(t) {
    const said = [];
    for (const [name, most] of Object.entries(kBudgets)) {
      const bytes = fs.readFileSync(path.join(t.folder, name));
      const sent = zlib.brotliCompressSync(bytes, { params: { [zlib.constants.BROTLI_PARAM_SIZE_HINT]: bytes.length } }).length;
      said.push(`${name} ${sent} B`);
      assert.ok(sent <= most, `${name} has ${sent} B by brotli, more than ${most}`);
    }
    return said.join(', ');
  },
  async 'who wants less motion gets a still picture'(t) {
    const { page } = await t.open({ reducedMotion: 'reduce' });
    assert.equal(await page.evaluate(() => marrowPage.settings.playing), false);
  },
};
