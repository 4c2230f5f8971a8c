// Models are cooked in the page to the program's bytes, and drawn as `marrow render` draws them.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { differ, download, frame, set, take, withOthers } from './hand.mjs';

// Drivers differ at edges: there are as many pixels as the picture has of them. Within them they do not.
const kMostWrong = 0.005;
const kOwn = ['dance.gltf', 'looks.gltf'];  // of tests/golden
const kShort = ['RiggedSimple.glb', 'AnimatedMorphCube.glb', 'Fox.glb', 'CesiumMan.glb', 'godot_robot.glb', 'RiggedFigure.glb'];
const kLong = ['SimpleSkin.gltf', 'greenman.glb', 'm2m_shark.glb', 'webxr_hand_right.glb'];

const run = (marrow, ...words) => execFileSync(marrow, words, { stdio: ['ignore', 'ignore', 'pipe'] });

const own = (t, name) => path.join(t.root, 'tests/golden', name);

async function compare(t, page, source) {
  const name = path.basename(source), cooked = path.join(t.work, `${path.parse(name).name}.mrw`);
  const picture = path.join(t.work, `${path.parse(name).name}.png`);
  run(t.marrow, 'cook', source, '-o', cooked);
  const { error, changed } = await take(page, withOthers(source));
  assert.equal(error, '');
  assert.ok(changed);
  const made = await download(page, 'save-mrw');
  assert.deepEqual([made.name, made.bytes.equals(fs.readFileSync(cooked))], [path.basename(cooked), true], `${name}: other bytes`);
  const { clips } = await page.evaluate(() => marrowPage.viewer.about);
  const clip = clips.length > 1 ? 1 : 0, time_s = clip > 0 ? clips[clip].duration_s / 2 : 0;
  await set(page, { clip, time_s, playing: false, deformer: 'ssd', split: 1, normals: 'blended', orbit: null });
  await frame(page);
  const drawn = await download(page, 'save-picture');
  const [width, height] = [drawn.bytes.readUInt32BE(16), drawn.bytes.readUInt32BE(20)];
  run(t.marrow, 'render', cooked, ...(clip > 0 ? ['--clip', String(clip - 1), '--time', String(time_s)] : []),
      '--images-from', source.endsWith('.gltf') ? path.dirname(source) : source, '--size', `${width}x${height}`, '-o', picture);
  const { wrong, busy, size } = await differ(page, drawn.bytes, fs.readFileSync(picture));
  if (process.env.MARROW_KEEP) {
    fs.writeFileSync(path.join(process.env.MARROW_KEEP, `${name}.page.png`), drawn.bytes);
    fs.copyFileSync(picture, path.join(process.env.MARROW_KEEP, `${name}.program.png`));
  }
  assert.equal(size, undefined);
  assert.ok(busy > 0.003, `${name}: next to nothing is drawn`);
  assert.ok(wrong <= kMostWrong, `${name}: ${(100 * wrong).toFixed(2)} % of the pixels differ`);
  return `${name} ${(100 * wrong).toFixed(2)} %`;
}

export const tests = {
  async 'the bytes and the picture of the program'(t) {
    // What differs are edges, where drivers lay their samples elsewhere: the more of a picture the smaller it is.
    const viewport = t.all ? { width: 1280, height: 900 } : { width: 700, height: 520 };
    const { page, troubles, outside } = await t.open({ viewport });
    const said = [];
    t.site.asked.length = 0;
    const models = [...kShort, ...(t.all ? kLong : [])].map((name) => path.join(t.assets, name)).filter((file) => fs.existsSync(file));
    for (const source of [...kOwn.map((name) => own(t, name)), ...models]) said.push(await compare(t, page, source));
    assert.deepEqual(troubles, []);
    assert.deepEqual(outside, []);
    assert.deepEqual(t.site.asked.sort(), ['/cook.wasm', '/cook_worker.js'], 'cooking fetches the cooker alone, and once');
    return said.join(', ');
  },
  async 'the plain newt is drawn as its own file is'(t) {
    const { page, troubles } = await t.open({ viewport: { width: 700, height: 520 } });
    await page.waitForFunction(() => marrowPage.viewer?.about.deformers.includes('plain'));
    const { clips } = await page.evaluate(() => marrowPage.viewer.about);
    const clip = clips.findIndex(({ name }) => name === 'twist'), picture = path.join(t.work, 'plain.png');
    const look = { clip, time_s: 0.7, playing: false, split: 1, normals: 'blended', orbit: null };
    const drawn = {};
    for (const deformer of ['plain', 'as']) {
      await set(page, { ...look, deformer });
      await frame(page);
      drawn[deformer] = (await download(page, 'save-picture')).bytes;
    }
    const [width, height] = [drawn.plain.readUInt32BE(16), drawn.plain.readUInt32BE(20)];
    // The page has it in the other's pose: its own clips are as close to the source here.
    const sample = (name) => path.join(t.folder, name), cooked = path.join(t.work, 'plain.mrw');
    run(t.marrow, 'cook', sample('newt.glb'), '--retarget', sample('newt_moves.glb'), '--root', '*=ground', '-o', cooked);
    run(t.marrow, 'render', cooked, '--clip', 'twist', '--time', '0.7', '--size', `${width}x${height}`, '-o', picture);
    const { wrong } = await differ(page, drawn.plain, fs.readFileSync(picture));
    const { wrong: other } = await differ(page, drawn.as, fs.readFileSync(picture));
    assert.deepEqual(troubles, []);
    assert.ok(wrong <= kMostWrong, `${(100 * wrong).toFixed(2)} % of the pixels differ`);
    assert.ok(other > 2 * wrong, 'animation space is another picture');
    return `${(100 * wrong).toFixed(2)} %, and ${(100 * other).toFixed(2)} % by animation space`;
  },
  async 'options of the panel and of the text, and what is wrong in them'(t) {
    const { page } = await t.open({ viewport: { width: 820, height: 700 } });
    const source = own(t, 'dance.gltf'), cooked = path.join(t.work, 'options.mrw');
    assert.equal((await take(page, [source])).error, '');
    const again = async (more, mesh) => {
      await page.evaluate(() => { globalThis.shownBefore = marrowPage.shown; });
      await page.locator('#cook details').evaluate((details) => { details.open = true; });
      if (mesh) await page.locator('#cook label', { hasText: 'Meshes' }).locator('select').selectOption({ label: mesh });
      await page.locator('#more-options').fill(more);
      await page.locator('#again').click();
      await page.waitForFunction(() => document.querySelector('#alert p') || marrowPage.shown !== globalThis.shownBefore);
      return page.evaluate(() => document.querySelector('#alert p')?.textContent ?? '');
    };
    assert.equal(await again("lod = '0.5'", 'meshoptimizer'), '');
    run(t.marrow, 'cook', source, '--mesh-codec', 'meshopt', '--lod', '0.5', '-o', cooked);
    assert.ok((await download(page, 'save-mrw')).bytes.equals(fs.readFileSync(cooked)));
    assert.match(await again('lods = 3'), /lods/);
    assert.ok((await download(page, 'save-mrw')).bytes.equals(fs.readFileSync(cooked)), 'the old character stays');
    const report = await download(page, 'save-report');
    assert.equal(JSON.parse(report.bytes).output.bytes, fs.readFileSync(cooked).length);
  },
  async 'of two that are dropped at once the second is shown'(t) {
    const { page, troubles } = await t.open({ viewport: { width: 640, height: 500 } });
    const texts = ['dance.gltf', 'elbow.gltf'].map((name) => fs.readFileSync(own(t, name)).toString('base64'));
    await page.evaluate((models) => models.forEach((text, i) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], `model${i}.gltf`));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
    }), texts);
    await page.waitForFunction(() => marrowPage.shown.name !== 'newt.mrw' && !document.getElementById('busy').open);
    await page.waitForTimeout(1000);
    assert.equal(await page.evaluate(() => marrowPage.shown.name), 'model1.gltf');
    assert.equal(await page.locator('#alert p').count(), 0);
    assert.deepEqual(troubles, []);
  },
  async 'a marrow.toml beside it counts, for all files'(t) {
    const { page } = await t.open({ viewport: { width: 640, height: 500 } });
    const folder = path.join(t.work, 'beside'), source = path.join(folder, 'dance.gltf');
    fs.mkdirSync(folder);
    fs.copyFileSync(own(t, 'dance.gltf'), source);
    fs.writeFileSync(path.join(folder, 'marrow.toml'), "mesh-codec = 'none'\n[roles]\nhead = 'joint5'\n[[file]]\nmatch = 'other.glb'\nlod = '0.5'\n");
    run(t.marrow, 'cook', source, '-o', path.join(folder, 'program.mrw'));
    assert.equal((await take(page, [source, path.join(folder, 'marrow.toml')])).error, '');
    assert.ok((await download(page, 'save-mrw')).bytes.equals(fs.readFileSync(path.join(folder, 'program.mrw'))));
  },
  async 'cancelled, the old character stays'(t) {
    const { page } = await t.open({ viewport: { width: 640, height: 500 } });
    await page.setInputFiles('#files', [path.join(t.folder, 'newt.glb')]);
    await page.locator('#busy button', { hasText: 'Cancel' }).click();
    await page.locator('#busy').waitFor({ state: 'hidden' });
    assert.equal(await page.evaluate(() => marrowPage.shown.name), 'newt.mrw');
    assert.equal(await page.locator('#alert p').count(), 0);
    assert.equal((await take(page, [own(t, 'dance.gltf')])).error, '', 'and the next is cooked');
  },
};
