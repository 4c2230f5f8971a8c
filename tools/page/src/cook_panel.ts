// Options by which the cooker is asked again.
import type { App } from './app';
import { button, by, choice, element, section } from './controls';

const kChoices: { label: string; choices: [string, string][] }[] = [
  { label: 'Deformer', choices: [
    ['', 'linear blend skinning, lifted'],
    ["as = 'fit'\ntruth = 'dqs'", 'animation space, learnt from dual quaternions'],
    ["as = 'fit'\ntruth = 'elastic'", 'animation space, learnt from elastic flesh (slow)'],
    ["as = 'fit'\ntruth = 'delta-mush'", 'animation space, learnt from delta mush'],
    ["as = 'smooth'", 'animation space, smoothed'],
  ] },
  { label: 'Helpers', choices: [['', 'none of its own'], ["helpers = 'auto'", 'as many as pay'], ["helpers = '16'", '16'], ["helpers = '80'", '80']] },
  { label: 'Clips may stray', choices: [['', '0.1 mm'], ["clip-error = '0.02mm'", '0.02 mm'], ["clip-error = '0.5mm'", '0.5 mm'], ["clip-error = '2mm'", '2 mm']] },
  { label: 'Meshes', choices: [['', 'Draco'], ["mesh-codec = 'draco-smallest'", 'Draco, smallest'], ["mesh-codec = 'meshopt'", 'meshoptimizer'], ["mesh-codec = 'none'", 'not packed']] },
  { label: 'Levels of detail', choices: [['', 'one'], ["lod = '0.5'", 'a half'], ["lod = '0.5,0.25'", 'a half, a quarter'], ["lod = '0.5,0.25,0.1'", 'a half, a quarter, a tenth']] },
  { label: 'Images', choices: [['', 'by their names'], ["images = 'embed'", 'in the file'], ["images = 'none'", 'none']] },
];

// What the button over the picture adds: a few seconds for most models.
const kLearnt = "as = 'fit'\ntruth = 'dqs'";

// again: cooks what is on show by the options of `app`.
export function useCookPanel(app: App, again: () => void): void {
  const root = by('cook'), learn = by('learn');
  learn.addEventListener('click', () => {
    app.options = [app.options, kLearnt].filter((text) => text.trim()).join('\n');
    again();
  });
  app.on('file', () => {
    learn.hidden = !app.shown?.source || !app.viewer || app.viewer.about.deformers.includes('as') ||
      /^as\b/m.test(app.options) || app.viewer.about.joints.length < 2;
    if (!app.shown?.source) return root.replaceChildren();
    const lines = new Set(app.options.split('\n').filter((line) => line.trim()));
    const controls = kChoices.map(({ label, choices }) => {
      const chosen = choices.find(([toml]) => toml && toml.split('\n').every((line) => lines.has(line)));
      for (const line of chosen?.[0].split('\n') ?? []) lines.delete(line);
      const control = choice(label, choices, () => {});
      control.show(chosen?.[0] ?? '');
      return control;
    });
    const more = element('textarea', { rows: '3', spellcheck: 'false', id: 'more-options', placeholder: 'strict = true' });
    more.value = [...lines].join('\n');
    const cook = button('Cook again', () => {
      const chosen = controls.map(({ root: field }) => field.querySelector('select')!.value);
      app.options = [...chosen, more.value].filter((text) => text.trim()).join('\n');
      again();
    }, { class: 'primary', id: 'again' });
    root.replaceChildren(section('Cook it otherwise', false, ...controls.map((control) => control.root),
      element('label', { class: 'field tall' }, element('span', {}, 'More, as in marrow.toml'), more), cook));
  });
}
