// The stage in WebAssembly: one file on one canvas. An instance shows one file, and whatever fails ends it.
import { glImports } from '../../../platform/web/gl.mjs';
import { Failure } from './failure';

export type Vec3 = [number, number, number];
export interface Clip {
  name: string;
  duration_s: number;
  rate_hz: number;
  events: { name: string; time_s: number }[];
  contacts: { role: string; from_s: number; until_s: number }[];
}
export interface Joint {
  name: string;
  parent: number;  // an index of joints; -1: none
  skeleton: number;
  limited: boolean;
  role: string;
}
export interface Graph {
  name: string;
  parameters: { name: string; kind: 'number' | 'flag' | 'trigger'; least: number; most: number; initial: number }[];
  machines: { name: string; states: string[] }[];
}
// What a file has.
export interface About {
  clips: Clip[];  // the first is the rest pose
  joints: Joint[];
  meshes: { name: string; vertices: number; triangles: number; levels: number; skeleton: number }[];
  morphs: { name: string; mesh: number }[];
  parameters: string[];  // of example shapes
  deformers: string[];
  levels: number;
  springs: boolean;
  limits: boolean;
  parts: { name: string; bytes: number }[];  // as the file is stored
  bytes: number;
  graphs: Graph[];
}
export interface Orbit {
  target: Vec3;
  yaw: number;
  pitch: number;
  distance: number;
}
export interface Settings {
  clip: number;
  second: number;  // 0: none
  second_weight: number;
  time_s: number;
  playing: boolean;
  speed: number;
  loop: boolean;
  deformer: string;
  other: string;  // to the right of the divide
  split: number;  // the divide's place, a share of the width; 1: there is none
  normals: 'blended' | 'tangents';
  level: number;
  colours: 'surface' | 'distance' | 'weights' | 'uv';
  pair: [string, string];
  joint: number;
  picked: boolean;
  wireframe: boolean;
  show_normals: boolean;
  grid: boolean;
  steps: boolean;
  ghosts: number;
  goals: { joint: number; at: Vec3 }[];
  solver: string;  // "auto": two bones, in closed form
  chain: number;   // joints
  limits: boolean;
  springs: boolean;
  turns: { joint: number; degrees: Vec3 }[];
  weights: { morph: number; weight: number }[];
  parameters: { name: string; value: number }[];
  graph: number;  // -1: clips play
  set: { name: string; value: number }[];  // of the graph; a trigger fires
  coarseness: number;
  orbit: Orbit | null;  // null: framed anew
}
// After a frame.
export interface Now {
  time_s: number;
  duration_s: number;
  orbit: Orbit;
  heat_m: number;  // that the hottest colour stands for
  trouble: string;
  states: { machine: string; state: string; seconds: number }[];
  values: number[];  // of the graph's parameters
  events: { name: string; time_s: number }[];  // of the last second
  pose_ms: number;
  skin_ms: number;
}
// An image of the file: its name, where it lies beside the file, or its own bytes.
export interface FileImage {
  name: string;
  uri: string;
  bytes: Uint8Array | null;
}
export type Decode = (image: FileImage) => Promise<ImageData | null>;

interface Exports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  take_memory(size: number): number;
  load(name: number, nameLength: number, bytes: number, size: number): number;
  show(): void;
  show_plain(): number;
  about(): number;
  set(json: number, length: number): void;
  frame(dt_s: number, width: number, height: number): number;
  places(): number;
  turn(dx: number, dy: number): void;
  move(dx: number, dy: number, height: number): void;
  zoom(steps: number): void;
  joint_at(joint: number): number;
  drag_goal(goal: number, dx: number, dy: number, height: number): number;
  heat_colour(t: number): number;
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

export class Viewer {
  about!: About;
  private readonly exports: Exports;
  private readonly gl: { imports: Record<string, unknown>; release(): void };
  private readonly instance: WebAssembly.Instance;
  private images: (ImageData | null)[] = [];
  private scratch = 0;  // of put()
  private scratchSize = 0;
  private wanted = 0;  // goals
  private goals = 0;   // of the last frame

  // Throws Failure for a file that cannot be shown; then nothing is left of it. Images that decode() has not are left out.
  static async open(module: WebAssembly.Module, context: WebGL2RenderingContext, name: string, bytes: Uint8Array,
                    decode: Decode): Promise<Viewer> {
    const viewer = new Viewer(module, context);
    try {
      viewer.images = await Promise.all(viewer.load(name, bytes).map(decode));
      viewer.exports.show();
      viewer.about = JSON.parse(viewer.text(viewer.exports.about())) as About;
      viewer.images = [];
      return viewer;
    } catch (failure) {
      viewer.close();
      throw failure;
    }
  }

  // Has the same character, cooked without a better deformer, as the deformer "plain". Another character is left out.
  async addPlain(bytes: Uint8Array, decode: Decode): Promise<void> {
    this.images = await Promise.all(this.load('plain.mrw', bytes).map(decode));
    if (this.exports.show_plain() === 1 && !this.about.deformers.includes('plain')) this.about.deformers.unshift('plain');
    this.images = [];
  }

  private constructor(module: WebAssembly.Module, context: WebGL2RenderingContext) {
    this.gl = glImports(context, () => this.instance.exports);
    const marrow = {
      failed: (at: number, length: number, code: number) => {
        throw new Failure(decoder.decode(this.bytes(at, length).slice()), code);
      },
      image: (index: number, most: number, width: number, height: number) => {
        const pixels = this.images[index];
        if (!pixels || Math.max(pixels.width, pixels.height) > most) return 0;
        const at = this.exports.take_memory(pixels.data.length);
        this.bytes(at, pixels.data.length).set(pixels.data);
        const view = new DataView(this.exports.memory.buffer);
        view.setInt32(width, pixels.width, true);
        view.setInt32(height, pixels.height, true);
        return at;
      },
    };
    this.instance = new WebAssembly.Instance(module, {
      gl: this.gl.imports as WebAssembly.ModuleImports, marrow, wasi_snapshot_preview1: system(() => this.exports.memory),
    });
    this.exports = this.instance.exports as unknown as Exports;
    this.exports._initialize();
  }

  private load(name: string, bytes: Uint8Array): FileImage[] {
    const [title, length] = this.put(name);
    const at = this.exports.take_memory(bytes.length);
    if (at === 0) throw new Failure(`${name}: there is not enough memory`, 4);
    this.bytes(at, bytes.length).set(bytes);
    const images = JSON.parse(this.text(this.exports.load(title, length, at, bytes.length))) as
      { name: string; uri: string; at: number; size: number }[];
    return images.map(({ name, uri, at, size }) => ({ name, uri, bytes: size > 0 ? this.bytes(at, size).slice() : null }));
  }

  set(settings: Partial<Settings>): void {
    this.exports.set(...this.put(JSON.stringify(settings)));
    if (settings.goals) this.wanted = settings.goals.length;
  }

  // Draws to the canvas. width, height: its pixels.
  frame(dt_s: number, width: number, height: number): Now {
    this.goals = this.wanted;
    return JSON.parse(this.text(this.exports.frame(dt_s, width, height))) as Now;
  }

  // Of each joint, then of each goal: x and y, shares of the picture to the right and down, and its depth, none behind the
  // camera.
  places(): Float32Array {
    return new Float32Array(this.exports.memory.buffer, this.exports.places(), 3 * (this.about.joints.length + this.goals));
  }
  // Where a joint is in the scene.
  jointAt(joint: number): Vec3 { return this.three(this.exports.joint_at(joint)); }

  // Of a hand, in pixels of CSS.
  turn(dx: number, dy: number): void { this.exports.turn(dx, dy); }
  move(dx: number, dy: number, height: number): void { this.exports.move(dx, dy, height); }
  zoom(steps: number): void { this.exports.zoom(steps); }
  dragGoal(goal: number, dx: number, dy: number, height: number): Vec3 {
    return this.three(this.exports.drag_goal(goal, dx, dy, height));
  }

  // sRGB of the ramp at t, 0 to 1.
  heatColour(t: number): Vec3 { return this.three(this.exports.heat_colour(t)); }

  // Gives back what it has on the graphics processor. It is not to be used any more.
  close(): void { this.gl.release(); }

  private three(at: number): Vec3 { return [...new Float32Array(this.exports.memory.buffer, at, 3)] as Vec3; }
  private bytes(at: number, size: number): Uint8Array { return new Uint8Array(this.exports.memory.buffer, at, size); }
  private text(at: number): string {
    const all = new Uint8Array(this.exports.memory.buffer, at);
    return decoder.decode(all.slice(0, all.indexOf(0)));
  }
  // A text in memory that the next one takes.
  private put(text: string): [number, number] {
    const line = encoder.encode(text);
    if (line.length > this.scratchSize) {
      this.scratchSize = 2 * line.length;
      this.scratch = this.exports.take_memory(this.scratchSize);
    }
    this.bytes(this.scratch, line.length).set(line);
    return [this.scratch, line.length];
  }
}

// What the C library asks of a system: the time, and where warnings go.
function system(memory: () => WebAssembly.Memory): WebAssembly.ModuleImports {
  const view = () => new DataView(memory().buffer);
  return {
    clock_time_get(_clock: number, _precision: bigint, to: number) {
      view().setBigUint64(to, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    fd_write(_file: number, parts: number, count: number, written: number) {
      let size = 0, line = '';
      for (let i = 0; i < count; ++i) {
        const at = view().getUint32(parts + 8 * i, true), length = view().getUint32(parts + 8 * i + 4, true);
        line += decoder.decode(new Uint8Array(memory().buffer, at, length).slice());
        size += length;
      }
      if (line.trim()) console.warn(line.trim());
      view().setUint32(written, size, true);
      return 0;
    },
    environ_get: () => 0,
    environ_sizes_get(count: number, size: number) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    fd_close: () => 8,
    fd_seek: () => 8,
    proc_exit(code: number) { throw new Failure(`the viewer ended with code ${code}`, 5); },
  };
}
