// What of marrow::gles3 calls no driver, in JavaScript: where a joint of a crowd is. usage: gles3.mjs marrow.wasm FILE
import { readFile } from 'node:fs/promises';
import { GLES3_ABI, Gles3SkinningPath, Marrow, Status } from './marrow.mjs';

const [wasm, name] = process.argv.slice(2);
const m = await Marrow.load(await readFile(wasm));
if (m.gles3_abi() !== GLES3_ABI) throw new Error('the library is of another ABI');
const file = m.make('File');
m.must(m.load(m.bytes(await readFile(name)), file, null));
const skeleton = m.make('Skeleton');
m.must(m.file_skeleton(file, 0, skeleton));

const sources = m.list('Gles3CrowdSource', 1);
m.must(m.file_clip(file, 0, sources.at(0).clip));
const clips = m.list('Gles3CrowdClip', 1);
const frameCount = m.list('u32', 1);
m.must(m.gles3_plan_crowd(sources, 30, clips, frameCount));
const matrices = m.list('Affine', frameCount.array[0] * skeleton.joint_count);
const frames = m.make('Gles3CrowdFrames');
const scratch = m.list('SoaTransform', m.skeleton_soa_size(skeleton));
m.must(m.gles3_bake_crowd(skeleton, sources, clips, scratch, matrices, frames));

const instance = m.make('Gles3CrowdInstance');
instance.a.clip = 0;
instance.a.phase_s = clips.at(0).duration_s / clips.at(0).steps * 3;  // frame 3
const joint = m.make('Affine');
m.must(m.gles3_crowd_joint(frames, instance, 0, 5, joint));
const wanted = matrices.at(3 * skeleton.joint_count + 5).rows;
if (joint.rows.some((x, i) => Math.abs(x - wanted[i]) > 1e-4)) throw new Error(`${joint.rows} is not ${wanted}`);
// Entry points that load_api() has not filled are none.
if (m.gles3_query_caps(m.make('Gles3Api'), m.make('Gles3Caps')) !== Status.BAD_ARGUMENT) throw new Error('no driver');
console.log(`${m.gles3_skinning_path_text(Gles3SkinningPath.TEXTURE)}: a joint of a crowd is where its frame has it`);
