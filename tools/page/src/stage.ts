// The canvas: which file is on it, and when it is drawn.
import { App, kFirst, type Shown } from './app';
import { by } from './controls';
import { Failure, sentence } from './failure';
import { Viewer, type Settings } from './viewer';

const kLongestStep_s = 0.25;
const kSlow_ms = 55, kFast_ms = 20;  // a frame, while it plays
const kCoarsest = 4;
const kStill_ms = 250;  // after which a still picture is drawn in full

export class Stage {
  readonly canvas = by('canvas') as HTMLCanvasElement;
  private readonly context: WebGL2RenderingContext;
  private readonly module: Promise<WebAssembly.Module>;
  private before_ms = 0;
  private changed_ms = 0;
  private dirty = true;
  private frame_ms = 30;
  private coarseness = 1;
  private least = 1;
  private lost = false;
  private first = true;  // picture of the page

  constructor(private readonly app: App) {
    const context = this.canvas.getContext('webgl2', { antialias: false, alpha: false, powerPreference: 'high-performance' });
    if (!context) throw new Failure('This browser has no WebGL 2, by which the picture is drawn.', 4);
    this.context = context;
    this.module = WebAssembly.compileStreaming(fetch('viewer.wasm'));
    if (bySoftware(context)) this.coarseness = 3;
    this.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();  // otherwise it never comes back
      this.lost = true;
      app.viewer = null;
    });
    this.canvas.addEventListener('webglcontextrestored', () => {
      this.lost = false;
      if (app.shown) void this.open(app.shown, app.settings);
    });
    app.on('settings', () => this.touch());
    app.on('broken', ({ failure, before }) => this.fail(failure, before));
    new ResizeObserver(() => this.touch()).observe(this.canvas);
    requestAnimationFrame(this.tick);
  }

  // Shows a file. What was on show stays if it cannot be. settings: to begin with; if the file refuses them, it is shown
  // without, and why is told.
  async open(shown: Shown, settings: Partial<Settings>): Promise<void> {
    const wanted = { ...this.app.settings, ...settings };
    const [viewer, all] = await this.opened(shown, wanted).catch((failure) => {
      this.app.tell('error', sentence(failure));
      return this.opened(shown, kFirst);
    });
    this.app.viewer?.close();
    Object.assign(this.app, { viewer, shown, settings: all });
    this.touch();
    this.app.tell('file', undefined);
    this.app.tell('settings', all);
  }

  private async opened(shown: Shown, wanted: Settings): Promise<[Viewer, Settings]> {
    const viewer = await Viewer.open(await this.module, this.context, shown.name, shown.cooked, shown.decode);
    try {
      if (shown.plain) await viewer.addPlain(shown.plain, shown.decode);
      const all = { ...fitting(viewer, wanted), coarseness: this.coarseness };
      viewer.set(all);
      return [viewer, all];
    } catch (failure) {
      viewer.close();
      throw failure;
    }
  }

  // The plain file of what is on show came later.
  async addPlain(plain: Uint8Array, settings: Partial<Settings>): Promise<void> {
    const { app } = this;
    if (!app.viewer || !app.shown) return;
    app.shown.plain = plain;
    await app.viewer.addPlain(plain, app.shown.decode);
    app.tell('file', undefined);
    app.set(fitting(app.viewer, { ...app.settings, ...settings }));
  }

  touch(): void {
    this.dirty = true;
    this.changed_ms = performance.now();
  }

  // Draws now, in full: for pictures that are kept.
  draw(width: number, height: number): void {
    const { viewer, settings } = this.app;
    if (!viewer) return;
    Object.assign(this.canvas, { width, height });
    viewer.set({ coarseness: 1 });
    viewer.frame(0, width, height);
    viewer.set({ coarseness: settings.coarseness });
    this.touch();
  }

  private readonly tick = (now_ms: number): void => {
    requestAnimationFrame(this.tick);
    const { app } = this;
    const passed_ms = now_ms - this.before_ms;
    this.before_ms = now_ms;
    if (!app.viewer || this.lost || document.hidden) return;
    const plays = app.settings.playing;
    const still = !plays && now_ms - this.changed_ms > kStill_ms;
    const coarseness = still ? this.least : this.coarseness;
    if (!plays && !this.dirty && coarseness === app.settings.coarseness) return;
    if (plays) this.adapt(passed_ms);
    this.paint(plays ? Math.min(passed_ms / 1000, kLongestStep_s) : 0, coarseness);
  };

  private adapt(passed_ms: number): void {
    this.frame_ms += 0.12 * (Math.min(passed_ms, 400) - this.frame_ms);
    if (this.frame_ms > kSlow_ms && this.coarseness < kCoarsest) ++this.coarseness;
    else if (this.frame_ms < kFast_ms && this.coarseness > this.least) --this.coarseness;
    else return;
    this.frame_ms = 0.5 * (kSlow_ms + kFast_ms);
  }

  private paint(dt_s: number, coarseness: number): void {
    const { app, canvas } = this;
    const ratio = Math.min(devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio)), height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    try {
      if (coarseness !== app.settings.coarseness) app.viewer!.set({ coarseness });
      app.settings.coarseness = coarseness;
      // The very first picture is of one half: the shaders of the other take their time.
      if (this.first) app.viewer!.set({ split: 1 });
      app.now = app.viewer!.frame(dt_s, width, height);
      this.dirty = this.first;
      if (this.first) app.viewer!.set({ split: app.settings.split });
      if (this.first) performance.mark('first picture');
      this.first = false;
      app.tell('frame', app.now);
    } catch (failure) {
      this.fail(failure, { ...kFirst, playing: false });
    }
  }

  // What fails ends the instance: the file is opened anew, by these settings.
  private fail(failure: unknown, settings: Settings): void {
    const { app } = this;
    const viewer = app.viewer, shown = app.shown;
    app.viewer = null;
    if (this.context.isContextLost()) return;
    viewer?.close();
    app.tell('error', sentence(failure));
    if (shown) this.open(shown, settings).catch((again) => app.tell('error', sentence(again)));
  }
}

function bySoftware(context: WebGL2RenderingContext): boolean {
  const info = context.getExtension('WEBGL_debug_renderer_info');
  const name = String(context.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : context.RENDERER));
  return /swiftshader|llvmpipe|softpipe|software/i.test(name);
}

// Of another file's settings those that make sense here.
function fitting(viewer: Viewer, wanted: Settings): Settings {
  const { about } = viewer;
  const out = { ...wanted };
  const can = (deformer: string) => about.deformers.includes(deformer);
  const best = can('as') ? 'as' : 'ssd';
  const first = can('plain') ? 'plain' : 'ssd';
  if (!can(out.deformer)) out.deformer = first;
  if (!can(out.other)) out.other = out.deformer === best ? first : best;
  if (!out.pair.every(can) || out.pair.includes('plain')) out.pair = ['ssd', best];
  if (out.deformer === out.other) out.split = 1;
  out.clip = Math.min(out.clip, about.clips.length - 1);
  out.second = out.second < about.clips.length ? out.second : 0;
  out.level = Math.min(out.level, about.levels - 1);
  if (out.joint >= about.joints.length) Object.assign(out, { joint: 0, picked: false });
  out.goals = out.goals.filter((goal) => goal.joint < about.joints.length);
  out.turns = out.turns.filter((turn) => turn.joint < about.joints.length);
  out.graph = out.graph < about.graphs.length ? out.graph : -1;
  out.set = [];
  return out;
}
