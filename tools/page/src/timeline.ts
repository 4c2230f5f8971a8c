// What plays, and when: clips, the line of time with contacts and events on it, speed, a blend.
import type { App } from './app';
import { button, by, checkbox, choice, element, slider } from './controls';
import type { Clip } from './viewer';

const kRoles = ['left_foot', 'right_foot', 'left_hand', 'right_hand'];

export function useTimeline(app: App): void {
  const root = by('time');
  let redraw = (): void => {};
  app.on('file', () => {
    root.replaceChildren();
    redraw = app.viewer ? build() : () => {};
    redraw();
  });
  app.on('settings', () => app.viewer && redraw());
  app.on('frame', () => app.viewer && redraw());

  function build(): () => void {
    const clips = app.viewer!.about.clips;
    const names = clips.map((clip, index): [string, string] => [String(index), clip.name]);
    const clip = choice('Clip', names, (value) => app.set({ clip: Number(value), time_s: 0, playing: true, orbit: null }));
    const play = button('Pause', () => app.set({ playing: !app.settings.playing }), { class: 'primary', id: 'play' });
    const frames = element('input', { type: 'range', min: '0', step: '1', 'aria-label': 'Frame', id: 'frame' });
    const count = element('output', { class: 'frames' });
    const rows = element('div', { class: 'rows', 'aria-hidden': 'true' });
    const needle = element('div', { class: 'needle' });
    const speed = slider('Speed', 0, 2, 0.05, (value) => app.set({ speed: value }), ' ×');
    const loop = checkbox('Loop', (on) => app.set({ loop: on }));
    const second = choice('Blend with', [['0', 'nothing'], ...names.slice(1)], (value) => app.set({ second: Number(value) }));
    const weight = slider('How much', 0, 1, 0.01, (value) => app.set({ second_weight: value }));
    frames.addEventListener('input', () => goTo(app, frames.valueAsNumber));
    const step = (by_frames: number, label: string, sign: string) =>
      button(sign, () => stepFrames(app, by_frames), { 'aria-label': label });
    const line = element('div', { class: 'line' }, frames, rows);
    const playing = element('div', { class: 'playing' }, clip.root, step(-1, 'A frame back', '‹'), play, step(1, 'A frame on', '›'), count);
    root.append(playing, line, element('div', { class: 'more' }, speed.root, loop.root, second.root, weight.root));

    let drawn: Clip | null = null;
    return () => {
      const { settings, now } = app;
      const is = clips[settings.clip]!;
      if (is !== drawn) {
        drawn = is;
        frames.max = String(Math.max(1, lastFrame(is)));
        rows.replaceChildren(...marks(is), needle);
        line.hidden = is.duration_s === 0;
      }
      root.classList.toggle('by-graph', settings.graph >= 0);
      clip.show(String(settings.clip));
      play.textContent = settings.playing ? 'Pause' : 'Play';
      speed.show(settings.speed);
      loop.show(settings.loop);
      second.show(String(settings.second));
      weight.show(settings.second_weight);
      weight.root.hidden = settings.second === 0;
      const frame = frameNow(app);
      if (document.activeElement !== frames || settings.playing) frames.value = String(frame);
      frames.setAttribute('aria-valuetext', `frame ${frame} of ${lastFrame(is)}`);
      count.textContent = is.duration_s > 0 ? `${frame} / ${lastFrame(is)}` : '';
      const share = is.duration_s > 0 ? (now?.time_s ?? settings.time_s) / is.duration_s : 0;
      needle.style.left = `${100 * Math.min(1, share)}%`;
    };
  }
}

const lastFrame = (clip: Clip): number => Math.floor(clip.duration_s * clip.rate_hz + 1e-3);
export const clipOf = (app: App): Clip => app.viewer!.about.clips[app.settings.clip]!;
export const frameNow = (app: App): number =>
  Math.round((app.settings.playing ? app.now?.time_s ?? 0 : app.settings.time_s) * clipOf(app).rate_hz);

export function goTo(app: App, frame: number): void {
  const clip = clipOf(app), last = lastFrame(clip);
  const wrapped = ((frame % (last + 1)) + last + 1) % (last + 1);
  app.set({ time_s: Math.min(wrapped / clip.rate_hz, clip.duration_s), playing: false });
}
export function stepFrames(app: App, by_frames: number): void {
  goTo(app, frameNow(app) + by_frames);
}

// A bar where a foot stands, a tick where an event is.
function marks(clip: Clip): HTMLElement[] {
  const out: HTMLElement[] = [];
  const share = (seconds: number) => `${(100 * seconds / clip.duration_s).toFixed(2)}%`;
  for (const role of kRoles) {
    const contacts = clip.contacts.filter((contact) => contact.role === role);
    if (contacts.length === 0) continue;
    const row = element('div', { class: `row ${role}`, title: role.replace('_', ' ') });
    for (const { from_s, until_s } of contacts) {
      const parts: [number, number][] = [[from_s, Math.min(until_s, clip.duration_s)]];
      if (until_s > clip.duration_s) parts.push([0, Math.min(until_s - clip.duration_s, clip.duration_s)]);
      for (const [from, until] of parts) {
        const bar = element('i');
        bar.style.left = share(from);
        bar.style.width = share(until - from);
        row.append(bar);
      }
    }
    out.push(row);
  }
  if (clip.events.length > 0) {
    const row = element('div', { class: 'row events' });
    for (const event of clip.events) {
      const tick = element('b', { title: `${event.name}, ${event.time_s.toFixed(2)} s` }, event.name);
      tick.style.left = share(event.time_s);
      row.append(tick);
    }
    out.push(row);
  }
  return out;
}
