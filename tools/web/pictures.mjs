// Makes the pictures by `marrow render` that what a browser draws is held to.
import fs from 'node:fs';
import path from 'node:path';
import { execFileSync } from 'node:child_process';

const root = path.join(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), '../..');

export const kWidth = 640, kHeight = 480, kDistance_m = 4.6, kFrames = 32, kDt_s = 1 / 64;  // exact in binary

// The sample, its materials without light, which is what newt.cpp and the package's example draw; with a colour that one
// instead of its own.
function write_variant(to, colour) {
  const glb = fs.readFileSync(path.join(root, 'tools/sample/newt.glb')), size = glb.readUInt32LE(12);
  const json = JSON.parse(glb.toString('utf8', 20, 20 + size));
  json.extensionsUsed = [...(json.extensionsUsed ?? []), 'KHR_materials_unlit'];
  for (const material of json.materials) {
    material.extensions = { KHR_materials_unlit: {} };
    if (colour) material.pbrMetallicRoughness.baseColorFactor = colour;
  }
  if (colour) for (const mesh of json.meshes) for (const part of mesh.primitives) delete part.attributes.COLOR_0;
  const text = Buffer.from(JSON.stringify(json)), padded = Buffer.alloc(Math.ceil(text.length / 4) * 4, ' ');
  text.copy(padded);
  const head = Buffer.from(glb.subarray(0, 20)), rest = glb.subarray(20 + size);
  head.writeUInt32LE(20 + padded.length + rest.length, 8);
  head.writeUInt32LE(padded.length, 12);
  fs.writeFileSync(to, Buffer.concat([head, padded, rest]));
}

// To `work` newt.mrw, to `pictures` NAME_DEFORMER.png: plain, and red and green, which say where it is.
export function renderAll(marrow, work, pictures) {
  const run = (...words) => execFileSync(marrow, words, { stdio: ['ignore', 'ignore', 'pipe'] });
  // Smoothed, so that animation space is another picture than SSD; not packed.
  const cook = (from, to) =>
    run('cook', from, '--as', 'smooth', '--mesh-codec', 'none', '--clip-codec', 'raw', '-o', to);
  fs.mkdirSync(pictures, { recursive: true });
  cook(path.join(root, 'tools/sample/newt.glb'), path.join(work, 'newt.mrw'));
  for (const [name, colour] of [['plain', null], ['red', [1, 0, 0, 1]], ['green', [0, 1, 0, 1]]]) {
    const model = path.join(work, `${name}.glb`), cooked = path.join(work, `${name}.mrw`);
    write_variant(model, colour);
    cook(model, cooked);
    for (const deformer of ['ssd', 'as'])
      run('render', cooked, '--clip', 'walk', '--time', String(kFrames * kDt_s), '--deformer', deformer,
        '--normals', 'blended', '--look-at', 'pelvis', '--distance', String(kDistance_m),
        '--size', `${kWidth}x${kHeight}`, '-o', path.join(pictures, `${name}_${deformer}.png`));
  }
}
