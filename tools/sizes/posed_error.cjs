// How far joints and vertices of a glTF file stray from its source's while its clips play. Prints one line of JSON: the
// largest distances and root mean squares, of joints as shares of the skeleton's diagonal, of vertices of the model's;
// null where joints or clips do not correspond.
// usage: node posed_error.cjs MODULES SOURCE.glb FILE.glb
// Joints and clips are paired by name where names serve, else in their order. A vertex is paired with that one near it
// at rest which moves most as it does.
"use strict";
const { read, pose, poseAt, vertices, diagonal, jointsOf, origins, load } = require("./gltf.cjs");

const kMostMoments = 240;  // of all clips together
const kProbes = 3;         // moments that vertices are paired by, beside rest

// For each of `from`, the number in `to` of the one that corresponds; null if there is none for one of them.
function paired(from, to) {
  const number = new Map(to.map((name, i) => [name, i]));
  if (number.size === to.length && from.every((name) => name !== undefined && number.has(name)))
    return from.map((name) => number.get(name));
  return from.length === to.length ? from.map((_, i) => i) : null;
}

const lengthOf = (doc, animation) => Math.max(...animation.samplers.map((s) => read(doc, s.input).at(-1)));
const between = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);

// Clip and time in the source of every moment that is looked at.
function momentsOf(source) {
  const clips = source.json.animations || [], each = Math.max(2, Math.floor(kMostMoments / clips.length));
  return clips.flatMap((clip, i) => {
    const end = lengthOf(source, clip), count = Math.max(2, Math.min(each, Math.ceil(end * 60)));
    return Array.from({ length: count }, (_, f) => [i, end * f / (count - 1)]);
  });
}

// from, to: vertices at rest and at the probes. For each of `from` a number in `to`.
function pairVertices(from, to, size) {
  const cell = size / Math.max(4, Math.cbrt(to[0].length) * 2), grid = new Map();
  const place = (p) => p.map((c) => Math.floor(c / cell));
  to[0].forEach((p, i) => {
    const key = place(p).join();
    if (!grid.has(key)) grid.set(key, []);
    grid.get(key).push(i);
  });
  return from[0].map((p, v) => {
    const [x, y, z] = place(p), near = [];
    let nearest = Infinity;
    for (let ring = 1; ring < 64 && nearest > (ring - 1) * cell; ++ring) {
      near.length = 0;
      for (let i = -ring; i <= ring; ++i)
        for (let j = -ring; j <= ring; ++j)
          for (let k = -ring; k <= ring; ++k) near.push(...grid.get([x + i, y + j, z + k].join()) || []);
      for (const i of near) nearest = Math.min(nearest, between(p, to[0][i]));
    }
    let best = -1, least = Infinity;
    for (const i of near) {
      if (between(p, to[0][i]) > Math.max(2 * nearest, 2e-4 * size)) continue;
      const apart = from.reduce((sum, at, probe) => sum + between(at[v], to[probe][i]), 0);
      if (apart < least) { least = apart; best = i; }
    }
    return best;
  });
}

class Errors {
  constructor(size) { Object.assign(this, { size, largest: 0, squares: 0, count: 0 }); }
  add(error) {
    this.largest = Math.max(this.largest, error);
    this.squares += error * error;
    ++this.count;
  }
  get max() { return this.size ? this.largest / this.size : null; }
  get rms() { return this.size && this.count ? Math.sqrt(this.squares / this.count) / this.size : null; }
}

async function main() {
  const [source, doc] = await load(process.argv.slice(3, 5));
  const nameOf = (d) => (j) => d.json.nodes[j].name;
  const joints = [jointsOf(source), jointsOf(doc)];
  const jointPairs = paired(joints[0].map(nameOf(source)), joints[1].map(nameOf(doc)));
  const named = (d) => (d.json.animations || []).map((a) => a.name);
  const clipPairs = paired(named(source), named(doc));
  const rest = [source, doc].map((d) => pose(d, d.json.nodes));
  if (!jointPairs || !clipPairs || !joints[0].length || !clipPairs.length) return console.log("null");
  const moments = momentsOf(source);
  const posed = ([clip, time]) => [poseAt(source, source.json.animations[clip], time),
                                   poseAt(doc, doc.json.animations[clipPairs[clip]], time)];
  const probes = Array.from({ length: kProbes }, (_, i) => posed(moments[Math.floor(moments.length * (i + 1) / (kProbes + 1))]));
  const shapes = [rest, ...probes].map(([a, b]) => [vertices(source, a), vertices(doc, b)]);
  const size = diagonal(shapes[0][0]);
  const pairs = pairVertices(shapes.map((s) => s[0]), shapes.map((s) => s[1]), size);
  const of = { joint: new Errors(diagonal(origins(rest[0], joints[0]))), vertex: new Errors(size) };
  for (const moment of moments) {
    const [a, b] = posed(moment), p = origins(a, joints[0]), q = origins(b, joints[1]);
    p.forEach((at, j) => of.joint.add(between(at, q[jointPairs[j]])));
    const v = vertices(source, a), w = vertices(doc, b);
    v.forEach((at, i) => of.vertex.add(between(at, w[pairs[i]])));
  }
  console.log(JSON.stringify({ joint_max: of.joint.max, joint_rms: of.joint.rms, vertex_max: of.vertex.max,
                               vertex_rms: of.vertex.rms }));
}
main().catch((e) => { console.error(`posed_error: ${e.stack}`); process.exit(1); });
