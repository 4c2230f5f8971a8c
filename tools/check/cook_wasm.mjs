// Cooks in WebAssembly what the program cooks, and compares: the same bytes, or the same sentence and code. A new instance
// each, of one module. usage: node cook_wasm.mjs MARROW cook.wasm short|all FOLDER ...
// A folder: of models, or with a manifest.json of bad inputs. short: models of kShort, and each so many-th bad input.
// Prints a line of what differs, and of each folder how many there were; exit 1 if anything differs.
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, extname, join, relative } from 'node:path';
import { cook, CookFailure } from '../cook/instance.mjs';

// Each for a reason: what the larger ones have, in little time.
const kShort = {
  'RiggedSimple.glb': 'two joints',
  'Fox.glb': 'long clips, an image',
  'Fox_cubicspline_step.glb': 'splines and steps',
  'CesiumMan_draco_in/CesiumMan.gltf': 'Draco decoded, files beside',
  'CesiumMan_u8.glb': 'small integers',
  'AnimatedMorphCube.glb': 'morph targets',
  'sparseBlendshapeCube.glb': 'sparse accessors',
  'webxr_hand_right.glb': 'no clips',
  'assimp_quad_skin_10inf.glb': 'many influences',
  'InterpolationTest.glb': 'nodes without skins',
  'm2m_shark.glb': 'fins: learning animation space',
};
const kModels = ['.glb', '.gltf', '.vrm', '.bvh'];
const kEachBadInput = 4;
const kWays = [{}, { 'mesh-codec': 'meshopt', lod: '0.5' }, { as: 'fit', mwe: 'true' }];

const [marrow, wasm, form, ...folders] = process.argv.slice(2);
const module = new WebAssembly.Module(readFileSync(wasm));
const work = mkdtempSync(join(tmpdir(), 'marrow-cook-'));
const out = join(work, 'out.mrw');

function program(input, way) {
  const flags = Object.entries(way).flatMap(([name, value]) => value === 'true' ? [`--${name}`] : [`--${name}`, value]);
  const child = spawn(marrow, ['cook', basename(input), '-o', out, '--jobs', '1', ...flags],
                      { cwd: dirname(input), stdio: ['ignore', 'ignore', 'pipe'] });
  let said = '';
  child.stderr.on('data', (text) => said += text);
  return new Promise((resolve) => child.on('close', (code) => resolve({
    code, said: said.trim(), file: code === 0 ? readFileSync(out) : null })));
}

function page(input, way) {
  const toml = Object.entries(way)
    .map(([name, value]) => `${name} = ${value === 'true' ? value : `'${value}'`}\n`).join('');
  const read = (name) => {
    const path = join(dirname(input), name);
    return statSync(path, { throwIfNoEntry: false })?.isFile() ? readFileSync(path) : null;
  };
  const began = performance.now();
  try {
    return { code: 0, said: '', ...cook(module, basename(input), toml, read), seconds: (performance.now() - began) / 1000 };
  } catch (failure) {
    if (!(failure instanceof CookFailure)) throw failure;
    return { code: failure.code, said: failure.message, file: null };
  }
}

// A page says of a missing file what can be done there, and has no folders.
const common = (text) => text.replace(/no such file: (check the name|drop .* together with the model)$/, 'no such file')
  .replace(/is a directory: name a file in it$/, 'no such file');

async function compare(input, way, told) {
  const theirs = program(input, way), ours = page(input, way), { code, said, file } = await theirs;
  const same = code === ours.code &&
    (code === 0 ? file.equals(ours.file) : common(said.split('\n').at(-1)) === common(ours.said));
  if (!same)
    console.log(`DIFFERS ${told} ${JSON.stringify(way)}: ` + (code === 0 && ours.code === 0 ?
      `${file.length} and ${ours.file.length} bytes` : `${code} "${said}" and ${ours.code} "${ours.said}"`));
  else if (process.env.MARROW_VERBOSE && code === 0)
    console.log(`${told}: ${ours.seconds.toFixed(2)} s, ${ours.memory_bytes >> 20} MiB`);
  rmSync(out, { force: true });
  return { same, cooked: code === 0 };
}

function inputsOf(folder) {
  const manifest = join(folder, 'manifest.json');
  const listed = statSync(manifest, { throwIfNoEntry: false }) ? JSON.parse(readFileSync(manifest)).files : undefined;
  if (listed) return listed.map(({ file }) => file).filter((_, i) => form === 'all' || i % kEachBadInput === 0);
  const all = readdirSync(folder, { recursive: true }).filter((path) => kModels.includes(extname(path))).sort();
  return form === 'all' ? all : all.filter((path) => path in kShort || folder.endsWith('sample'));
}

let isGood = true;
for (const folder of folders) {
  const began = performance.now(), inputs = inputsOf(folder);
  const count = { cooked: 0, refused: 0, differ: 0 };
  for (const input of inputs)
    for (const way of basename(input) === 'newt.glb' ? kWays : [{}]) {
      const { same, cooked } = await compare(join(folder, input), way, relative(process.cwd(), join(folder, input)));
      if (!same) count.differ++;
      count[cooked ? 'cooked' : 'refused']++;
    }
  console.log(`${basename(folder)}: ${count.cooked} cooked, ${count.refused} refused, ` +
    `${count.differ} of them other than by the program; ${((performance.now() - began) / 1000).toFixed(0)} s`);
  isGood &&= count.differ === 0 && count.cooked > 0;
}
rmSync(work, { recursive: true });
process.exit(isGood ? 0 : 1);
