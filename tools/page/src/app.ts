// What the page shows, and what it is set to; parts of the page listen to it.
import type { Decode, Now, Settings, Viewer } from './viewer';
import type { Report } from './report';

// A model as it was dropped.
export interface Source {
  document: string;
  files: Map<string, Uint8Array>;
  bytes: number;
}
// A file on show.
export interface Shown {
  name: string;
  cooked: Uint8Array;
  plain: Uint8Array | null;  // the same without a better deformer; null: it has none, or nobody knows
  options: string;           // of the cooker
  source: Source | null;  // null: it was cooked elsewhere
  report: Report | null;
  seconds: number;        // that cooking took
  decode: Decode;
}

export const kFirst: Settings = {
  clip: 1, second: 0, second_weight: 0.5, time_s: 0, playing: true, speed: 1, loop: true,
  deformer: 'ssd', other: 'as', split: 0.5, normals: 'tangents', level: 0,
  colours: 'surface', pair: ['ssd', 'as'], joint: 0, picked: false,
  wireframe: false, show_normals: false, grid: false, steps: false, ghosts: 0,
  goals: [], solver: 'auto', chain: 3, limits: false, springs: false, turns: [], weights: [], parameters: [],
  graph: -1, set: [], coarseness: 1, orbit: null,
};

type Events = {
  file: void; settings: Partial<Settings>; frame: Now; status: string; error: string;
  broken: { failure: unknown; before: Settings };  // the viewer, by what was set: it is not to be used any more
};

export class App {
  shown: Shown | null = null;
  viewer: Viewer | null = null;
  now: Now | null = null;
  settings: Settings = structuredClone(kFirst);
  overlay = { bones: false, names: false };
  options = '';  // of the cooker, as marrow.toml has them
  private listeners: { [K in keyof Events]?: ((what: Events[K]) => void)[] } = {};

  on<K extends keyof Events>(event: K, listener: (what: Events[K]) => void): void {
    ((this.listeners[event] ??= []) as ((what: Events[K]) => void)[]).push(listener);
  }
  tell<K extends keyof Events>(event: K, what: Events[K]): void {
    for (const listener of this.listeners[event] ?? []) listener(what);
  }

  // Settings from a hand. A trigger of a graph is told, and not kept.
  set(some: Partial<Settings>): void {
    const before = { ...this.settings };
    Object.assign(this.settings, some);
    try {
      this.viewer?.set(some);
    } catch (failure) {
      return this.tell('broken', { failure, before });
    }
    if (some.set) this.settings.set = [];
    this.tell('settings', some);
  }
}
