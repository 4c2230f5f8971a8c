// What the tests do on the page, as somebody who uses it would, and what they read of it.
import fs from 'node:fs';
import path from 'node:path';

// Files into the field that the button opens. Resolves once a new file is on show or the page says why not.
export async function take(page, files) {
  await page.evaluate(() => { globalThis.shownBefore = marrowPage.shown; });
  await page.setInputFiles('#files', files);
  await page.waitForFunction(() => document.querySelector('#alert p') || marrowPage.shown !== globalThis.shownBefore);
  return page.evaluate(() => ({
    error: document.querySelector('#alert p')?.textContent ?? '', changed: marrowPage.shown !== globalThis.shownBefore }));
}

// A file, and what it names beside it.
export function withOthers(file) {
  const beside = [];
  try {
    const { buffers = [], images = [] } = JSON.parse(fs.readFileSync(file, 'utf8'));
    for (const { uri } of [...buffers, ...images]) beside.push(path.join(path.dirname(file), decodeURIComponent(uri)));
  } catch { /* no JSON, or a wrong one */ }
  return [file, ...new Set(beside.filter((one) => fs.existsSync(one) && fs.statSync(one).isFile() && one !== file))];
}

export const set = (page, settings) => page.evaluate((some) => marrowPage.set(some), settings);
export const settings = (page) => page.evaluate(() => structuredClone(marrowPage.settings));
export const now = (page) => page.evaluate(() => structuredClone(marrowPage.now));

// Waits for the next frame, and gives what is then.
export async function frame(page) {
  await page.evaluate(() => new Promise((done) => {
    const last = marrowPage.now;
    const look = () => marrowPage.now !== last ? done() : requestAnimationFrame(look);
    marrowPage.set({});
    look();
  }));
  return now(page);
}

export async function download(page, id) {
  const [file] = await Promise.all([
    page.waitForEvent('download', { timeout: 120_000 }), page.evaluate((name) => document.getElementById(name).click(), id)]);
  return { name: file.suggestedFilename(), bytes: fs.readFileSync(await file.path()) };
}

// How two PNG files differ: shares of the pixels with a channel that is more than 8 levels off, and of those that are
// not as the corner is, by the second.
export function differ(page, one, other) {
  return page.evaluate(async (both) => {
    const [a, b] = await Promise.all(both.map(async (text) => {
      const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d', { willReadFrequently: true });
      context.drawImage(bitmap, 0, 0);
      return context.getImageData(0, 0, bitmap.width, bitmap.height);
    }));
    if (a.width !== b.width || a.height !== b.height) return { size: `${a.width}x${a.height}, not ${b.width}x${b.height}` };
    let wrong = 0, busy = 0, largest = 0;
    for (let i = 0; i < a.data.length; i += 4) {
      let off = 0, edge = 0;
      for (let c = 0; c < 3; ++c) {
        off = Math.max(off, Math.abs(a.data[i + c] - b.data[i + c]));
        edge = Math.max(edge, Math.abs(b.data[i + c] - b.data[i + c - (i % (4 * a.width) >= 8 ? 8 : 0)]));
      }
      largest = Math.max(largest, off);
      if (off > 8) ++wrong;
      if (edge > 8) ++busy;
    }
    const count = a.data.length / 4;
    return { wrong: wrong / count, busy: busy / count, largest };
  }, [one, other].map((bytes) => bytes.toString('base64')));
}
