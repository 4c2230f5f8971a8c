// Morph targets and example shapes by hand; graphs of behaviour.
import type { App } from './app';
import { button, by, checkbox, choice, element, section, slider, type Control } from './controls';

export function useShapes(app: App): void {
  const root = by('shapes');
  app.on('file', () => {
    root.replaceChildren();
    if (!app.viewer) return;
    const { morphs, parameters } = app.viewer.about;
    const weight = (morph: number, value: number) => {
      const rest = app.settings.weights.filter((w) => w.morph !== morph);
      app.set({ weights: [...rest, { morph, weight: value }] });
    };
    if (morphs.length > 0) {
      const sliders = morphs.map(({ name }, i) => {
        const one = slider(name || `target ${i}`, 0, 1, 0.01, (value) => weight(i, value));
        one.show(app.settings.weights.find((w) => w.morph === i)?.weight ?? 0);
        return one;
      });
      const reset = button('As the clip has them', () => {
        app.set({ weights: [] });
        sliders.forEach((one) => one.show(0));
      });
      root.append(section(`Shapes (${morphs.length})`, false, ...sliders.map((one) => one.root), reset));
    }
    if (parameters.length > 0) {
      const sliders = parameters.map((name) => slider(name, 0, 1, 0.01, (value) => {
        const rest = app.settings.parameters.filter((p) => p.name !== name);
        app.set({ parameters: [...rest, { name, value }] });
      }));
      root.append(section('Parameters of shapes', false, ...sliders.map((one) => one.root)));
    }
  });
}

export function useGraphs(app: App): void {
  const root = by('graphs');
  let redraw = (): void => {};
  app.on('file', () => {
    root.replaceChildren();
    redraw = app.viewer && app.viewer.about.graphs.length > 0 ? build() : () => {};
    redraw();
  });
  app.on('frame', () => app.viewer && redraw());
  app.on('settings', () => app.viewer && redraw());

  function build(): () => void {
    const graphs = app.viewer!.about.graphs;
    const which = choice('It goes by', [['-1', 'the chosen clip'], ...graphs.map((g, i): [string, string] => [String(i), `the graph ${g.name}`])],
                         (value) => app.set({ graph: Number(value), playing: true, orbit: null }));
    const body = element('div');
    const states = element('p', { class: 'states', role: 'status' });
    const events = element('p', { class: 'quiet' });
    root.append(section('Behaviour', true, which.root, body, states, events));
    let built = -2, controls: Control<number>[] = [];
    return () => {
      const { settings, now } = app;
      which.show(String(settings.graph));
      if (built !== settings.graph) {
        built = settings.graph;
        controls = built < 0 ? [] : parametersOf(app, built);
        body.replaceChildren(...controls.map((control) => control.root));
      }
      now?.values.forEach((value, i) => controls[i]?.show(value));
      const lines = (now?.states ?? []).filter(({ state }) => state).map(({ machine, state }) => `${machine}: ${state}`);
      if (states.textContent !== lines.join(', ')) states.textContent = lines.join(', ');
      events.textContent = settings.graph < 0 ? '' : (now?.events ?? []).map(({ name }) => name.replace('_', ' ')).join(' · ');
    };
  }
}

function parametersOf(app: App, graph: number): Control<number>[] {
  return app.viewer!.about.graphs[graph]!.parameters.map((parameter) => {
    const set = (value: number) => app.set({ set: [{ name: parameter.name, value }] });
    if (parameter.kind === 'number')
      return slider(parameter.name, parameter.least, parameter.most, (parameter.most - parameter.least) / 100, set);
    if (parameter.kind === 'flag') {
      const box = checkbox(parameter.name, (on) => set(on ? 1 : 0));
      return { root: box.root, show: (value) => box.show(value > 0.5) };
    }
    const fire = button(parameter.name, () => set(1), { class: 'trigger' });
    return { root: fire, show: (value) => fire.classList.toggle('waits', value > 0.5) };
  });
}
