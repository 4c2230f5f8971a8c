// A link that holds what is set, in words: #clip=walk&left=ssd&right=as&split=0.5
import type { App } from './app';
import type { Settings, Vec3 } from './viewer';

const kNumbers = ['second_weight', 'time_s', 'speed', 'split', 'level', 'ghosts', 'chain'] as const;
const kFlags = ['playing', 'loop', 'wireframe', 'show_normals', 'grid', 'limits', 'springs'] as const;
const kWords = ['deformer', 'other', 'colours', 'solver', 'normals'] as const;
const short = (x: number): string => String(Number(x.toFixed(4)));

// What differs from `first`.
export function toLink(app: App, first: Settings): string {
  const { settings, viewer } = app;
  const out = new URLSearchParams();
  if (viewer) {
    const { clips, joints } = viewer.about;
    if (settings.clip !== first.clip) out.set('clip', clips[settings.clip]!.name);
    if (settings.second > 0) out.set('second', clips[settings.second]!.name);
    if (settings.picked) out.set('joint', joints[settings.joint]!.name);
    for (const { joint, degrees } of settings.turns) out.append('turn', `${joints[joint]!.name},${degrees.map(short).join(',')}`);
    for (const { joint, at } of settings.goals) out.append('pull', `${joints[joint]!.name},${at.map(short).join(',')}`);
  }
  for (const key of [...kNumbers, ...kFlags, ...kWords])
    if (settings[key] !== first[key]) out.set(key, typeof settings[key] === 'number' ? short(settings[key] as number) : String(settings[key]));
  if (settings.graph >= 0) out.set('graph', String(settings.graph));
  if (settings.colours === 'distance') out.set('pair', settings.pair.join(','));
  if (app.overlay.bones) out.set('bones', 'true');
  if (app.overlay.names) out.set('names', 'true');
  if (settings.orbit) {
    const { target, yaw, pitch, distance } = settings.orbit;
    out.set('camera', [...target, yaw, pitch, distance].map(short).join(','));
  }
  if (app.options.trim()) out.set('options', app.options);
  // Commas are as good as their codes, and are read by people.
  return out.toString().replaceAll('%2C', ',');
}

// Those of a link that make sense; what does not is left as it is. options: of the cooker.
export function fromLink(hash: string, app: App): { settings: Partial<Settings>; options: string; named: (app: App) => Partial<Settings> } {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  const settings: Partial<Settings> = {};
  const number = (text: string | null): number | null => text !== null && text !== '' && Number.isFinite(Number(text)) ? Number(text) : null;
  for (const key of kNumbers) {
    const value = number(given.get(key));
    if (value !== null) settings[key] = value;
  }
  for (const key of kFlags) if (given.has(key)) settings[key] = given.get(key) === 'true';
  for (const key of kWords) {
    const value = given.get(key);
    if (value && kAllowed[key].includes(value)) (settings as Record<string, unknown>)[key] = value;
  }
  const pair = given.get('pair')?.split(',');
  if (pair?.length === 2 && pair.every((word) => kAllowed.deformer.includes(word))) settings.pair = pair as [string, string];
  const camera = given.get('camera')?.split(',').map(Number);
  if (camera?.length === 6 && camera.every(Number.isFinite))
    settings.orbit = { target: camera.slice(0, 3) as Vec3, yaw: camera[3]!, pitch: camera[4]!, distance: camera[5]! };
  const graph = number(given.get('graph'));
  if (graph !== null) settings.graph = Math.round(graph);
  app.overlay.bones = given.get('bones') === 'true';
  app.overlay.names = given.get('names') === 'true';
  return { settings, options: given.get('options') ?? '', named: (to) => named(given, to) };
}

// Clips and joints by their names, once the file is there.
function named(given: URLSearchParams, app: App): Partial<Settings> {
  const out: Partial<Settings> = {};
  const { clips, joints } = app.viewer!.about;
  const clip = clips.findIndex(({ name }) => name === given.get('clip'));
  const second = clips.findIndex(({ name }) => name === given.get('second'));
  const joint = (name: string | null) => joints.findIndex((one) => one.name === name);
  if (clip >= 0) out.clip = clip;
  if (second > 0) out.second = second;
  if (joint(given.get('joint')) >= 0) Object.assign(out, { joint: joint(given.get('joint')), picked: true });
  const places = (key: string) => given.getAll(key).flatMap((text) => {
    const parts = text.split(','), numbers = parts.slice(-3).map(Number), of = joint(parts.slice(0, -3).join(','));
    return of >= 0 && numbers.length === 3 && numbers.every(Number.isFinite) ? [{ joint: of, three: numbers as Vec3 }] : [];
  });
  const turns = places('turn'), goals = places('pull');
  if (turns.length > 0) out.turns = turns.map(({ joint: of, three }) => ({ joint: of, degrees: three }));
  if (goals.length > 0) out.goals = goals.map(({ joint: of, three }) => ({ joint: of, at: three }));
  if (given.has('time_s')) out.time_s = Math.max(0, Number(given.get('time_s')) || 0);
  return out;
}

const kDeformers = ['plain', 'rigid', 'ssd', 'as', 'mwe', 'psd'];
const kAllowed: Record<(typeof kWords)[number], string[]> = {
  deformer: kDeformers, other: kDeformers, colours: ['surface', 'distance', 'weights', 'uv'],
  solver: ['auto', 'fabrik', 'ccd', 'dls'], normals: ['blended', 'tangents'],
};
