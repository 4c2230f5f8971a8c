// Measures a glTF file that a peer has made beside its source: bytes by what they are for, and how far positions and
// joints have moved. Prints one line of JSON.
// usage: node measure.cjs MODULES SOURCE.glb FILE.glb GEOMETRY.bin ANIMATION.bin REST.bin
// The last three are written: the bytes that geometry (joints and weights with it), animation and everything else take,
// textures left out.
"use strict";
const fs = require("fs");
const { open, stored, read, pose, poseAt, vertices, diagonal, jointsOf, origins, load } = require("./gltf.cjs");

// The largest distance from one of `from` to its nearest of `to`, by a grid whose cells hold a few points each.
function farthest(from, to, size) {
  const cell = size / Math.max(4, Math.cbrt(to.length) * 2), grid = new Map();
  const number = (p) => p.map((c) => Math.floor(c / cell));
  for (const p of to) {
    const key = number(p).join();
    if (!grid.has(key)) grid.set(key, []);
    grid.get(key).push(p);
  }
  let worst = 0;
  for (const p of from) {
    const [x, y, z] = number(p);
    let best = Infinity;
    for (let ring = 1; ring < 64 && best > (ring - 1) * cell; ++ring)
      for (let i = -ring; i <= ring; ++i)
        for (let j = -ring; j <= ring; ++j)
          for (let k = -ring; k <= ring; ++k)
            for (const q of grid.get([x + i, y + j, z + k].join()) || [])
              best = Math.min(best, Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    worst = Math.max(worst, best);
  }
  return worst;
}

// The largest distance between joints at up to 100 moments of each animation, animations and joints in their order; null where
// these are not comparable.
function animationError(source, doc) {
  const a = source.json.animations || [], b = doc.json.animations || [];
  const from = (source.json.skins || []).flatMap((s) => s.joints), to = (doc.json.skins || []).flatMap((s) => s.joints);
  if (a.length !== b.length || from.length !== to.length || !from.length) return null;
  let worst = 0;
  a.forEach((animation, i) => {
    const end = Math.max(...animation.samplers.map((s) => read(source, s.input).at(-1)));
    const moments = Math.min(Math.ceil(end * 60), 100);
    for (let f = 0; f <= moments; ++f) {
      const time = moments ? end * f / moments : 0;
      const p = origins(poseAt(source, animation, time), from), q = origins(poseAt(doc, b[i], time), to);
      p.forEach((v, j) => worst = Math.max(worst, Math.hypot(v[0] - q[j][0], v[1] - q[j][1], v[2] - q[j][2])));
    }
  });
  return worst;
}

// Which buffer views hold what; a view that holds vertices and something else counts as vertices.
function purposes(json) {
  const of = new Map(), accessor = (number, what) => {
    const a = json.accessors[number];
    for (const view of [a.bufferView, a.sparse && a.sparse.indices.bufferView, a.sparse && a.sparse.values.bufferView])
      if (view !== undefined && !of.has(view)) of.set(view, what);
  };
  for (const { primitives } of json.meshes || [])
    for (const p of primitives) {
      const draco = (p.extensions || {}).KHR_draco_mesh_compression;
      if (draco) of.set(draco.bufferView, "geometry");
      for (const group of [p.attributes, ...(p.targets || [])]) Object.values(group).forEach((n) => accessor(n, "geometry"));
      if (p.indices !== undefined) accessor(p.indices, "geometry");
    }
  for (const skin of json.skins || []) if (skin.inverseBindMatrices !== undefined) accessor(skin.inverseBindMatrices, "skin");
  for (const { samplers } of json.animations || []) for (const s of samplers) { accessor(s.input, "animation"); accessor(s.output, "animation"); }
  for (const image of json.images || []) if (image.bufferView !== undefined) of.set(image.bufferView, "image");
  return of;
}
const withoutTextures = (value) => value === null || typeof value !== "object" ? value
  : Array.isArray(value) ? value.map(withoutTextures)
  : Object.fromEntries(Object.entries(value).filter(([key]) => !/Texture$|^images$|^textures$|^samplers_of_textures$/.test(key))
                                            .map(([key, v]) => [key, withoutTextures(v)]));

async function main() {
  const [, , , sourceFile, file, ...outputs] = process.argv;
  const [source, doc] = await load([sourceFile, file]);
  const purpose = purposes(doc.json), chunks = { geometry: [], skin: [], animation: [], image: [], other: [] };
  (doc.json.bufferViews || []).forEach((view, i) => chunks[purpose.get(i) || "other"].push(stored(doc, view)));
  const json = withoutTextures(open(file).json);
  delete json.samplers;
  const text = Buffer.from(JSON.stringify(json));
  const size = (list) => list.reduce((sum, c) => sum + c.length, 0);
  const files = { geometry: chunks.geometry, animation: chunks.animation, rest: [text, ...chunks.skin, ...chunks.other] };
  Object.values(files).forEach((list, i) => outputs[i] && fs.writeFileSync(outputs[i], Buffer.concat(list)));
  const restOf = (d) => vertices(d, pose(d, d.json.nodes));
  const p = restOf(source), q = restOf(doc), across = diagonal(p);
  const joints = jointsOf(source), rest = pose(source, source.json.nodes);
  const skeleton = joints.length ? diagonal(origins(rest, joints)) : 0, moved = animationError(source, doc);
  console.log(JSON.stringify({
    geometry: size(chunks.geometry), skin: size(chunks.skin), animation: size(chunks.animation), json: text.length,
    whole: size(files.geometry) + size(files.animation) + size(files.rest) + 28, vertices: p.length, diagonal: across,
    skeleton_diagonal: skeleton, position_error: across ? Math.max(farthest(p, q, across), farthest(q, p, across)) / across : null,
    animation_error: moved === null || !skeleton ? null : moved / skeleton }));
}
main().catch((e) => { console.error(`measure: ${e.stack}`); process.exit(1); });
