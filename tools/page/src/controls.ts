// The page's controls: each has a label, and says by a function what it is set to.
type Content = Node | string;

export function element<K extends keyof HTMLElementTagNameMap>(
  name: K, attributes: Record<string, string | boolean> = {}, ...content: Content[]): HTMLElementTagNameMap[K] {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === true) made.setAttribute(key, '');
    else if (value !== false) made.setAttribute(key, value);
  }
  made.append(...content);
  return made;
}

export function button(label: string, act: () => void, attributes: Record<string, string> = {}): HTMLButtonElement {
  const made = element('button', { type: 'button', ...attributes }, label);
  made.addEventListener('click', act);
  return made;
}

const field = (label: string, control: Node, ...more: Content[]): HTMLLabelElement =>
  element('label', { class: 'field' }, element('span', {}, label), control, ...more);

export interface Control<T> {
  root: HTMLElement;
  show(value: T): void;  // without telling anybody
}

export function slider(label: string, least: number, most: number, step: number, act: (value: number) => void,
                       unit = ''): Control<number> {
  const input = element('input', { type: 'range', min: String(least), max: String(most), step: String(step) });
  const output = element('output', {});
  const show = (value: number) => {
    if (document.activeElement !== input || input.valueAsNumber !== value) input.value = String(value);
    output.textContent = `${Number(value.toFixed(3))}${unit}`;
    input.setAttribute('aria-valuetext', output.textContent);
  };
  input.addEventListener('input', () => {
    show(input.valueAsNumber);
    act(input.valueAsNumber);
  });
  return { root: field(label, input, output), show };
}

export function checkbox(label: string, act: (on: boolean) => void): Control<boolean> {
  const input = element('input', { type: 'checkbox' });
  input.addEventListener('change', () => act(input.checked));
  const root = element('label', { class: 'check' }, input, element('span', {}, label));
  return { root, show: (on) => { input.checked = on; } };
}

// choices: values and their names.
export function choice(label: string, choices: [string, string][], act: (value: string) => void): Control<string> {
  const input = element('select', {}, ...choices.map(([value, name]) => element('option', { value }, name)));
  input.addEventListener('change', () => act(input.value));
  return { root: field(label, input), show: (value) => { input.value = value; } };
}

export function entry(label: string, hint: string, act: (value: string) => void): Control<string> {
  const input = element('input', { type: 'text', placeholder: hint, spellcheck: 'false', autocomplete: 'off' });
  input.addEventListener('change', () => act(input.value));
  return { root: field(label, input), show: (value) => { input.value = value; } };
}

// A part of the panel that folds.
export function section(title: string, open: boolean, ...content: Content[]): HTMLDetailsElement {
  return element('details', { open }, element('summary', {}, title), element('div', { class: 'body' }, ...content));
}

export const bytesText = (bytes: number): string =>
  bytes < 1000 ? `${bytes} B` : bytes < 1e6 ? `${(bytes / 1e3).toFixed(1)} kB` :
  bytes < 1e9 ? `${(bytes / 1e6).toFixed(bytes < 1e8 ? 2 : 0)} MB` : `${(bytes / 1e9).toFixed(1)} GB`;
export const durationText = (seconds: number): string =>
  seconds < 90 ? `${Math.ceil(seconds)} s` : `${Math.round(seconds / 60)} minutes`;
export const by = (id: string): HTMLElement => document.getElementById(id)!;
