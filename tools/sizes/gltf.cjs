// glTF files as scenes that can be posed: whatever compresses them is undone.
"use strict";
const fs = require("fs"), path = require("path");
const modules = require("module").createRequire(path.resolve(process.argv[2], "package.json"));
const { MeshoptDecoder } = modules("meshoptimizer");
const draco3d = modules("draco3dgltf");

const kTypes = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const kArrays = { 5120: Int8Array, 5121: Uint8Array, 5122: Int16Array, 5123: Uint16Array, 5125: Uint32Array,
                  5126: Float32Array };
const kLargest = { 5120: 127, 5121: 255, 5122: 32767, 5123: 65535 };

function open(file) {
  const data = fs.readFileSync(file);
  if (data.toString("latin1", 0, 4) !== "glTF") {
    const json = JSON.parse(data);
    const load = (b) => b.uri.startsWith("data:") ? Buffer.from(b.uri.slice(b.uri.indexOf(",") + 1), "base64")
                                                  : fs.readFileSync(path.join(path.dirname(file), decodeURI(b.uri)));
    return { json, buffers: json.buffers.map(load) };
  }
  const n = data.readUInt32LE(12);
  return { json: JSON.parse(data.toString("utf8", 20, 20 + n)), buffers: [data.subarray(28 + n)] };
}

const compressed = (view) => (view.extensions || {}).EXT_meshopt_compression ||
                             (view.extensions || {}).KHR_meshopt_compression;

// The bytes of a buffer view as they are stored, and as they are meant.
function stored(doc, view) {
  const at = compressed(view) || view;
  return doc.buffers[at.buffer].subarray(at.byteOffset || 0, (at.byteOffset || 0) + at.byteLength);
}
function decoded(doc, number) {
  doc.views = doc.views || [];
  if (doc.views[number]) return doc.views[number];
  const view = doc.json.bufferViews[number], c = compressed(view);
  let bytes = stored(doc, view);
  if (c) {
    const out = new Uint8Array(c.count * c.byteStride);
    MeshoptDecoder.decodeGltfBuffer(out, c.count, c.byteStride, bytes, c.mode, c.filter || "NONE");
    bytes = out;
  }
  return doc.views[number] = bytes;
}

// An accessor as floats, normalised integers between -1 and 1.
function read(doc, number) {
  const a = doc.json.accessors[number], parts = kTypes[a.type], kind = kArrays[a.componentType];
  if (a.values) return a.values;
  const size = kind.BYTES_PER_ELEMENT, out = new Float32Array(a.count * parts);
  const fetch = (bytes, offset) => new kind(bytes.buffer.slice(bytes.byteOffset + offset, bytes.byteOffset + offset + parts * size));
  const largest = a.normalized ? kLargest[a.componentType] : 0;
  const put = (i, values) => {
    for (let c = 0; c < parts; ++c) out[i * parts + c] = largest ? Math.max(values[c] / largest, -1) : values[c];
  };
  if (a.bufferView !== undefined) {
    const view = doc.json.bufferViews[a.bufferView], bytes = decoded(doc, a.bufferView);
    const stride = view.byteStride || parts * size;
    for (let i = 0; i < a.count; ++i) put(i, fetch(bytes, (a.byteOffset || 0) + i * stride));
  }
  if (a.sparse) {
    const s = a.sparse, index = kArrays[s.indices.componentType];
    const indices = decoded(doc, s.indices.bufferView), values = decoded(doc, s.values.bufferView);
    for (let i = 0; i < s.count; ++i) {
      const from = indices.byteOffset + (s.indices.byteOffset || 0) + i * index.BYTES_PER_ELEMENT;
      put(new index(indices.buffer.slice(from, from + index.BYTES_PER_ELEMENT))[0],
          fetch(values, (s.values.byteOffset || 0) + i * parts * size));
    }
  }
  return a.values = out;
}

// Decodes a Draco primitive and puts its attributes where read() finds them.
function undraco(doc, primitive, draco) {
  const extension = (primitive.extensions || {}).KHR_draco_mesh_compression;
  if (!extension) return;
  const bytes = stored(doc, doc.json.bufferViews[extension.bufferView]);
  const buffer = new draco.DecoderBuffer(), decoder = new draco.Decoder(), mesh = new draco.Mesh();
  buffer.Init(new Int8Array(bytes), bytes.length);
  if (!decoder.DecodeBufferToMesh(buffer, mesh).ok()) throw new Error("Draco data cannot be decoded");
  for (const [name, id] of Object.entries(extension.attributes)) {
    const a = doc.json.accessors[primitive.attributes[name]], floats = new draco.DracoFloat32Array();
    decoder.GetAttributeFloatForAllPoints(mesh, decoder.GetAttributeByUniqueId(mesh, id), floats);
    const largest = a.normalized ? kLargest[a.componentType] : 1;
    a.values = Float32Array.from({ length: floats.size() }, (_, i) => floats.GetValue(i) / largest);
    a.count = mesh.num_points();
    draco.destroy(floats);
  }
  [mesh, decoder, buffer].forEach((o) => draco.destroy(o));
}

// Column-major 4x4 matrices.
function multiply(a, b) {
  const out = new Float64Array(16);
  for (let c = 0; c < 4; ++c)
    for (let r = 0; r < 4; ++r)
      for (let k = 0; k < 4; ++k) out[c * 4 + r] += a[k * 4 + r] * b[c * 4 + k];
  return out;
}
function matrixOf(node) {
  if (node.matrix) return Float64Array.from(node.matrix);
  const [x, y, z, w] = node.rotation || [0, 0, 0, 1], s = node.scale || [1, 1, 1], t = node.translation || [0, 0, 0];
  return Float64Array.of(
    (1 - 2 * (y * y + z * z)) * s[0], 2 * (x * y + z * w) * s[0], 2 * (x * z - y * w) * s[0], 0,
    2 * (x * y - z * w) * s[1], (1 - 2 * (x * x + z * z)) * s[1], 2 * (y * z + x * w) * s[1], 0,
    2 * (x * z + y * w) * s[2], 2 * (y * z - x * w) * s[2], (1 - 2 * (x * x + y * y)) * s[2], 0, t[0], t[1], t[2], 1);
}
function pose(doc, nodes) {
  const world = [];
  const visit = (n, above) => {
    world[n] = above ? multiply(above, matrixOf(nodes[n])) : matrixOf(nodes[n]);
    for (const child of nodes[n].children || []) visit(child, world[n]);
  };
  for (const root of doc.json.scenes[doc.json.scene || 0].nodes) visit(root);
  return world;
}

// glTF 2.0, appendix C.
function sampled(doc, sampler, time, rotation) {
  const times = read(doc, sampler.input), values = read(doc, sampler.output);
  const parts = kTypes[doc.json.accessors[sampler.output].type], cubic = sampler.interpolation === "CUBICSPLINE";
  const key = (k, part = 1) => Array.from(values.subarray((cubic ? 3 * k + part : k) * parts, (cubic ? 3 * k + part + 1 : k + 1) * parts));
  const unit = (q) => rotation ? q.map((c) => c / Math.hypot(...q)) : q;
  let k = 0;
  for (let high = times.length; high - k > 1;) {  // times[k] ≤ time < times[high]
    const middle = (k + high) >> 1;
    if (times[middle] <= time) k = middle; else high = middle;
  }
  if (k + 1 === times.length || time <= times[0] || sampler.interpolation === "STEP") return unit(key(k));
  const span = times[k + 1] - times[k], u = (time - times[k]) / span;
  if (cubic) {
    const a = key(k), b = key(k + 1), out = key(k, 2), into = key(k + 1, 0), u2 = u * u, u3 = u2 * u;
    return unit(a.map((_, i) => (2 * u3 - 3 * u2 + 1) * a[i] + span * (u3 - 2 * u2 + u) * out[i] +
                                (3 * u2 - 2 * u3) * b[i] + span * (u3 - u2) * into[i]));
  }
  const a = unit(key(k)), b = unit(key(k + 1));
  if (!rotation) return a.map((_, i) => a[i] + (b[i] - a[i]) * u);
  const dot = a.reduce((sum, c, i) => sum + c * b[i], 0), angle = Math.acos(Math.min(Math.abs(dot), 1));
  const wa = angle > 1e-6 ? Math.sin(angle * (1 - u)) / Math.sin(angle) : 1 - u;
  const wb = (angle > 1e-6 ? Math.sin(angle * u) / Math.sin(angle) : u) * (dot < 0 ? -1 : 1);
  return unit(a.map((_, i) => wa * a[i] + wb * b[i]));
}
function poseAt(doc, animation, time) {
  const nodes = doc.json.nodes.map((node) => ({ ...node }));
  for (const channel of animation.channels) {
    const { node, path: which } = channel.target;
    if (node === undefined || !["translation", "rotation", "scale"].includes(which)) continue;
    delete nodes[node].matrix;
    nodes[node][which] = sampled(doc, animation.samplers[channel.sampler], time, which === "rotation");
  }
  return pose(doc, nodes);
}

function transform(m, x, y, z) {
  return [0, 1, 2].map((r) => m[r] * x + m[4 + r] * y + m[8 + r] * z + m[12 + r]);
}
// All vertices in model space, by the world matrices that pose() and poseAt() give.
function vertices(doc, world) {
  const out = [];
  doc.json.nodes.forEach((node, n) => {
    if (node.mesh === undefined || !world[n]) return;
    const skin = node.skin === undefined ? null : doc.json.skins[node.skin];
    const bind = skin && skin.inverseBindMatrices !== undefined ? read(doc, skin.inverseBindMatrices) : null;
    const palette = skin && skin.joints.map((j, i) => bind ? multiply(world[j], bind.subarray(16 * i, 16 * i + 16)) : world[j]);
    for (const { attributes, mode } of doc.json.meshes[node.mesh].primitives) {
      if (attributes.POSITION === undefined || (mode !== undefined && mode < 4)) continue;
      const p = read(doc, attributes.POSITION), sets = [];
      for (let s = 0; palette && attributes["JOINTS_" + s] !== undefined; ++s)
        sets.push([read(doc, attributes["JOINTS_" + s]), read(doc, attributes["WEIGHTS_" + s])]);
      for (let v = 0; v < p.length / 3; ++v) {
        const at = [0, 0, 0];
        let sum = 0;
        for (const [joints, weights] of sets)
          for (let i = 4 * v; i < 4 * v + 4; ++i) {
            if (!(weights[i] > 0)) continue;
            sum += weights[i];
            transform(palette[joints[i]], p[3 * v], p[3 * v + 1], p[3 * v + 2]).forEach((c, r) => at[r] += c * weights[i]);
          }
        if (sets.length && !(sum > 0)) continue;  // bound to nothing
        out.push(sets.length ? at.map((c) => c / sum) : transform(world[n], p[3 * v], p[3 * v + 1], p[3 * v + 2]));
      }
    }
  });
  return out;
}

function diagonal(points) {
  let squared = 0;
  for (let r = 0; r < 3; ++r) {
    let low = Infinity, high = -Infinity;
    for (const p of points) { low = Math.min(low, p[r]); high = Math.max(high, p[r]); }
    squared += (high - low) ** 2;
  }
  return Math.sqrt(squared);
}

const jointsOf = (doc) => [...new Set((doc.json.skins || []).flatMap((s) => s.joints))];
const origins = (world, joints) => joints.map((j) => Array.from(world[j] || pose.none).slice(12, 15));

pose.none = new Float64Array(16);

// Files, decoded.
async function load(files) {
  await MeshoptDecoder.ready;
  const draco = await draco3d.createDecoderModule(), docs = files.map(open);
  for (const doc of docs) for (const m of doc.json.meshes || []) for (const p of m.primitives) undraco(doc, p, draco);
  return docs;
}

module.exports = { open, stored, read, pose, poseAt, vertices, diagonal, jointsOf, origins, load };
