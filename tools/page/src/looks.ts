// How the surface is looked at: which deformers, in which colours, with which lines.
import type { App } from './app';
import { by, checkbox, choice, element, section, slider } from './controls';
import { nameOf } from './overlay';
import type { Settings } from './viewer';

// Distances are between deformers of one file.
const paired = (deformer: string): string => deformer === 'plain' ? 'ssd' : deformer;

export function useLooks(app: App): void {
  const root = by('looks'), legend = by('legend');
  let redraw = (): void => {};
  app.on('file', () => {
    redraw = app.viewer ? build() : () => {};
    redraw();
  });
  app.on('settings', () => app.viewer && redraw());
  app.on('frame', (now) => {
    const end = legend.querySelector('.end');
    if (end && app.settings.colours === 'distance') end.textContent = `${(1000 * now.heat_m).toPrecision(3)} mm`;
  });

  function build(): () => void {
    const { about } = app.viewer!;
    const deformers = about.deformers.map((d): [string, string] => [d, nameOf(d, about.deformers)]);
    const colours = choice('Colours', [['surface', 'of the surface'], ['distance', 'how far the two are apart'],
                                       ['weights', 'weights of the chosen joint'], ['uv', 'a checker']],
                           (value) => app.set({ colours: value as Settings['colours'] }));
    const left = choice('Left', deformers, (value) => app.set({ deformer: value, pair: [paired(value), app.settings.pair[1]] }));
    const right = choice('Right', deformers, (value) => app.set({ other: value, pair: [app.settings.pair[0], paired(value)] }));
    const halves = checkbox('Two halves', (on) => app.set({ split: on ? 0.5 : 1 }));
    const level = slider('Level of detail', 0, about.levels - 1, 1, (value) => app.set({ level: value }));
    const flags: [keyof Settings, string][] = [['wireframe', 'Wireframe'], ['show_normals', 'Normals'], ['grid', 'Grid']];
    const boxes = flags.map(([key, label]) => ({ key, box: checkbox(label, (on) => app.set({ [key]: on })) }));
    const bones = checkbox('Bones', (on) => { app.overlay.bones = on; app.set({}); });
    const names = checkbox('Names', (on) => { app.overlay.names = on; app.set({}); });
    const ghosts = slider('Ghosts', 0, 4, 1, (value) => app.set({ ghosts: value }));
    level.root.hidden = about.levels < 2;
    root.replaceChildren(section('Look', true, left.root, right.root, halves.root, colours.root, level.root,
      element('div', { class: 'checks' }, ...boxes.map(({ box }) => box.root), bones.root, names.root), ghosts.root));
    drawLegend();
    return () => {
      const { settings } = app;
      colours.show(settings.colours);
      left.show(settings.colours === 'distance' ? settings.pair[0] : settings.deformer);
      right.show(settings.colours === 'distance' ? settings.pair[1] : settings.other);
      right.root.hidden = settings.split >= 1 && settings.colours !== 'distance';
      halves.show(settings.split < 1);
      halves.root.hidden = settings.colours !== 'surface';
      level.show(settings.level);
      for (const { key, box } of boxes) box.show(Boolean(settings[key]));
      bones.show(app.overlay.bones);
      names.show(app.overlay.names);
      ghosts.show(settings.ghosts);
      legend.hidden = settings.colours !== 'distance' && settings.colours !== 'weights';
      const end = legend.querySelector('.end');
      if (end && settings.colours === 'weights') end.textContent = '1';
    };
  }

  function drawLegend(): void {
    const ramp = element('canvas', { width: '64', height: '1', class: 'ramp' });
    const pen = ramp.getContext('2d')!;
    for (let i = 0; i < 64; ++i) {
      pen.fillStyle = `rgb(${app.viewer!.heatColour(i / 63).join(' ')})`;
      pen.fillRect(i, 0, 1, 1);
    }
    legend.replaceChildren(element('span', {}, '0'), ramp, element('span', { class: 'end' }));
  }
}
