// Joints: chosen by name, turned, pulled.
import type { App } from './app';
import { button, by, checkbox, choice, element, entry, section, slider } from './controls';
import type { Vec3 } from './viewer';

export function useJoints(app: App): void {
  const root = by('joints');
  let redraw = (): void => {};
  app.on('file', () => {
    root.replaceChildren();
    redraw = app.viewer && app.viewer.about.joints.length > 0 ? build() : () => {};
    redraw();
  });
  app.on('settings', () => app.viewer && redraw());

  function build(): () => void {
    const { about } = app.viewer!;
    const depths: number[] = [];
    about.joints.forEach((joint, i) => { depths[i] = joint.parent < 0 ? 0 : depths[joint.parent]! + 1; });
    const list = element('div', { class: 'list', role: 'listbox', 'aria-label': 'Joints', tabindex: '0' });
    const rows = about.joints.map((joint, index) => {
      const row = element('div', { role: 'option', id: `joint-${index}`, title: joint.role.replace('_', ' ') }, joint.name);
      row.style.paddingInlineStart = `${8 + 10 * Math.min(depths[index]!, 12)}px`;
      row.addEventListener('click', () => pick(index));
      return row;
    });
    list.append(...rows);
    const pick = (joint: number) => app.set({ joint, picked: true });
    list.addEventListener('keydown', (event) => {
      const by_rows = { ArrowDown: 1, ArrowUp: -1 }[event.key];
      if (by_rows === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      let next = app.settings.picked ? app.settings.joint : -1;
      do next += by_rows; while (rows[next]?.hidden);
      if (rows[next]) pick(next);
    });
    const filter = entry('Find', 'a name', () => {});
    filter.root.querySelector('input')!.addEventListener('input', (event) => {
      const wanted = (event.target as HTMLInputElement).value.toLowerCase();
      about.joints.forEach((joint, i) => { rows[i]!.hidden = !joint.name.toLowerCase().includes(wanted); });
    });

    const turn = (axis: number, degrees: number) => {
      const { turns, joint } = app.settings;
      const mine: Vec3 = [...(turns.find((t) => t.joint === joint)?.degrees ?? [0, 0, 0])] as Vec3;
      mine[axis] = degrees;
      const rest = turns.filter((t) => t.joint !== joint);
      app.set({ turns: mine.some((x) => x !== 0) ? [...rest, { joint, degrees: mine }] : rest });
    };
    const axes = ['x', 'y', 'z'].map((name, axis) =>
      slider(`Turn about ${name}`, -180, 180, 1, (value) => turn(axis, value), '°'));
    const pull = button('Pull it', () => togglePull(app), { id: 'pull' });
    const solver = choice('By', [['auto', 'two bones'], ['fabrik', 'FABRIK'], ['ccd', 'CCD'], ['dls', 'damped least squares']],
                          (value) => app.set({ solver: value, goals: app.settings.goals }));
    const chain = slider('Joints above', 1, 12, 1, (value) => app.set({ chain: value }));
    const limits = checkbox('Keep limits', (on) => app.set({ limits: on }));
    const springs = checkbox(about.springs ? 'Springs of the file' : 'Springs below it', (on) => app.set({ springs: on }));
    const reset = button('As the clip has it', () => app.set({ turns: [], goals: [], springs: false }));
    const chosen = element('div', { class: 'chosen' }, ...axes.map((axis) => axis.root), pull, solver.root, chain.root,
      element('div', { class: 'checks' }, limits.root, springs.root), reset);
    root.append(section(`Joints (${about.joints.length})`, document.body.dataset.part === 'joints', filter.root, list, chosen));

    return () => {
      const { settings } = app;
      rows.forEach((row, index) => {
        const is = settings.picked && index === settings.joint;
        if (is && row.getAttribute('aria-selected') !== 'true') row.scrollIntoView({ block: 'nearest' });
        row.setAttribute('aria-selected', String(is));
      });
      list.setAttribute('aria-activedescendant', settings.picked ? `joint-${settings.joint}` : '');
      chosen.hidden = !settings.picked;
      const degrees = settings.turns.find((t) => t.joint === settings.joint)?.degrees ?? [0, 0, 0];
      axes.forEach((axis, i) => axis.show(degrees[i]!));
      const pulled = settings.goals.some((goal) => goal.joint === settings.joint);
      pull.textContent = pulled ? 'Let it go' : 'Pull it: drag the square';
      solver.show(settings.solver);
      solver.root.hidden = chain.root.hidden = settings.goals.length === 0;
      chain.root.hidden ||= settings.solver === 'auto';
      chain.show(settings.chain);
      limits.show(settings.limits);
      limits.root.hidden = !about.limits;
      springs.show(settings.springs);
    };
  }
}

// A goal where the chosen joint is, or none any more. Its place in the scene comes back from a drag by nothing.
export function togglePull(app: App): void {
  const { goals, joint } = app.settings;
  if (goals.some((goal) => goal.joint === joint)) return app.set({ goals: goals.filter((goal) => goal.joint !== joint) });
  const at = app.viewer!.jointAt(joint);
  app.set({ goals: [...goals, { joint, at }] });
}
