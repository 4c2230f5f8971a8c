// What tests/c/road.c does, in JavaScript: the same lines must come of it. usage: road.mjs marrow.wasm FILE
import { readFile } from 'node:fs/promises';
import { Marrow, Status } from './marrow.mjs';

const [wasm, name] = process.argv.slice(2);
const m = await Marrow.load(await readFile(wasm));
const bytes = m.bytes(await readFile(name));

let hash = 2166136261;
function add(list, words = list.array.byteLength / 4) {
  const array = new Uint32Array(list.array.buffer, list.ptr, words);
  for (let i = 0; i < words; ++i) hash = Math.imul(hash ^ array[i], 16777619);
}

function expect(status, wanted, what) {
  if (status !== wanted) throw new Error(`${what}: ${m.status_text(status)}`);
}

function refuse(file) {
  const copy = m.list('byte', bytes.length + 4);
  const pose = m.list('SoaTransform', 64);
  const [skeleton, clip, mesh] = [m.make('Skeleton'), m.make('Clip'), m.make('Mesh')];
  const other = m.make('File');
  m.must(m.file_skeleton(file, 0, skeleton));
  m.must(m.file_clip(file, 0, clip));
  m.must(m.file_mesh(file, 0, 0, mesh));
  let told = 0;
  m.onCallError((called, condition) => { told += called !== '' && condition !== ''; });
  const nowhere = (length) => ({ ptr: 0, length });
  const bad = Status.BAD_ARGUMENT;
  expect(m.load(null, other, null), bad, 'no file');
  expect(m.load(nowhere(64), other, null), bad, 'null with a size');
  expect(m.load(bytes, null, null), bad, 'nowhere to load to');
  const short = { ptr: pose.ptr, length: m.skeleton_soa_size(skeleton) - 1 };
  expect(m.sample(skeleton, clip, 0, short, null), bad, 'short');
  expect(m.solve_two_bone(m.make('Pose'), m.make('TwoBoneLimb'), m.make('TwoBone'), null), bad, 'zeros');
  expect(m.skin_ssd(mesh, nowhere(3), m.make('SkinOutput')), bad, 'a null palette');
  copy.array.set(bytes.array, 4);
  expect(m.load({ ptr: copy.ptr + 4, length: bytes.length }, other, null), bad, 'off its boundary');
  copy.array.set(bytes.array);
  expect(m.load({ ptr: copy.ptr, length: bytes.length - 16 }, other, null), Status.TRUNCATED, 'cut');
  ++copy.array[4];
  expect(m.load({ ptr: copy.ptr, length: bytes.length }, other, null), Status.BAD_VERSION, 'another version');
  m.onCallError(null);
  console.log(`9 refused, ${told} told`);
}

const file = m.make('File');
m.must(m.load(bytes, file, null));
refuse(file);

const animations = m.make('Animations');
m.must(m.make_animations(file, file, m.list('byte', m.animations_bytes(file, file)), animations));
const options = m.make('CharacterOptions', { animation_space: true });
const character = m.make('Character');
m.must(m.make_character(file, options, m.list('byte', m.character_bytes(file, options)), character));
const [walk, idle] = ['walk', 'idle'].map((clip) => m.find_animation(animations, clip));
const { pose } = character.skeletons.at(0);
const { skeleton } = pose;
const joint = (text) => m.file_find_joint(file, skeleton, text);

const joints = m.list('SpringJoint', 4);
for (let i = 0; i < 4; ++i) joints.at(i).joint = joint(`tail_${3 + i}`);
const chains = m.list('SpringChain', 1);
chains.at(0).joints = joints;
const tail = m.make('Springs');
m.must(m.make_springs(skeleton, chains, m.list('byte', m.springs_bytes(skeleton, chains)), tail));

const neck = m.list('u32', 2);
neck.array.set([joint('neck'), joint('head')]);
const look = m.make('Aim', { target: [0.5, 1.25, 2], weight: 0.5 });
const leg = m.make('TwoBoneLimb', { start: joint('thigh.L'), mid: joint('shin.L'), end: joint('foot.L') });
const step = m.make('TwoBone');
const dt_s = Math.fround(1 / 60);
const frame = m.make('SpringFrame', { dt_s });
function reach() {
  m.must(m.solve_look_at(pose, neck, look, 0.5, null));
  const foot = pose.model_from_joint.at(leg.end).rows;
  step.target.set([3, 7, 11].map((i) => foot[i] + 0.0625));
  m.must(m.solve_two_bone(pose, leg, step, null));
  m.must(m.simulate_springs(pose, frame, tail));
}

const meshes = Array.from({ length: character.meshes.length }, (_, i) => {
  const of = character.meshes.at(i);
  const floats = 3 * of.mesh.geometry.slot_count;
  const [positions, normals] = [m.list('f32', floats), m.list('f32', floats)];
  return { of, positions, both: m.make('SkinOutput', { positions, normals }), normals, one: m.make('SkinOutput', { positions }) };
});

const playback = m.make('Playback');
const layers = m.list('AnimationLayer', 2);
layers.at(0).animation = walk;
layers.at(1).animation = idle;
layers.at(1).weight = 0.25;
for (let i = 0; i < 30; ++i) {
  m.must(m.advance(playback, walk.duration_s, dt_s));
  layers.at(0).time_s = layers.at(1).time_s = m.clip_time(playback);
  m.must(m.pose_character(character, layers));
  reach();
  m.must(m.finish_character(character));
  add(pose.local);
  add(pose.model_from_joint);
  for (const { of, positions, normals, both, one } of meshes) {
    m.must(m.skin_ssd(of.mesh, of.palette, both));
    add(of.palette);
    add(positions);
    add(normals);
    m.must(m.skin_as(of.mesh, of.coordinates, of.palette, one, null));
    add(positions);
  }
}
console.log((hash >>> 0).toString(16).padStart(8, '0'));
