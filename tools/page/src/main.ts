// The page: drop a model, see what Marrow makes of it.
import { App, kFirst, type Shown, type Source } from './app';
import { button, by, bytesText, durationText, element } from './controls';
import { cook, estimate } from './cooker';
import { useCookPanel } from './cook_panel';
import { useCost } from './cost';
import { sentence } from './failure';
import { chosen, dropped, isCooked, sourceOf } from './files';
import { useHands } from './hand';
import { decoder } from './images';
import { useJoints } from './joints';
import { useKeys } from './keys';
import { fromLink, toLink } from './link';
import { useLooks } from './looks';
import { useDivide, useOverlay } from './overlay';
import { useGraphs, useShapes } from './shapes';
import { Stage } from './stage';
import { useTimeline } from './timeline';

const kMuch = 200e6;  // bytes, before which somebody is asked
const kSample = ['newt.glb', 'newt_moves.glb', 'newt.anim.toml'];
const kSampleOptions = "retarget = ['newt_moves.glb']\ngraph = ['newt.anim.toml']\nroot = ['*=ground']\nmirror = ['turn_right=turn_left']";

// The newt's left arm has no twist joints: there the two differ most.
const kSampleFirst = { ...kFirst, deformer: 'as', other: 'plain' };

const app = new App();
const alertBox = by('alert'), statusBox = by('status'), busy = by('busy') as HTMLDialogElement;
app.on('error', (text) => {
  alertBox.replaceChildren(element('p', {}, text), button('Close', () => alertBox.replaceChildren(), { 'aria-label': 'Close the message' }));
});
app.on('status', (text) => { statusBox.textContent = text; });

async function start(): Promise<void> {
  // In a page of the manual: the picture, and a part of the panel.
  const part = new URLSearchParams(location.search).get('embed');
  document.body.classList.toggle('embed', part !== null);
  document.body.dataset.part = part ?? '';
  const stage = new Stage(app);
  useHands(app, stage);
  useOverlay(app);
  useDivide(app);
  useTimeline(app);
  useLooks(app);
  useGraphs(app);
  useJoints(app);
  useShapes(app);
  useCost(app);
  useCookPanel(app, () => void again(stage));
  useKeys(app);
  useFiles(stage);
  useDownloads(stage);
  const link = fromLink(location.hash, app);
  app.options = link.options;
  const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
  await showSample(stage, { ...(still ? { playing: false } : {}), ...link.settings });
  app.set(link.named(app));
  document.body.classList.add('ready');
}

async function showSample(stage: Stage, settings: Partial<typeof kFirst>): Promise<void> {
  const response = await fetch('newt.mrw');
  const cooked = new Uint8Array(await response.arrayBuffer());
  await stage.open({ name: 'newt.mrw', cooked, options: '', source: null, report: null, seconds: 0, decode: async () => null, plain: null },
                   { ...kSampleFirst, ...settings });
  const first = app.viewer!.about.clips.findIndex((clip) => clip.name === 'twist');
  if (settings.clip === undefined && first > 0) app.set({ clip: first });
  sample = true;
  void comparePlain(stage, settings).catch((failure) => app.tell('error', sentence(failure)));
  title('the newt', 'the sample that Marrow brings');
}
let sample = false;

// Once the first picture is there: the newt as any engine draws it.
async function comparePlain(stage: Stage, { deformer = 'as', other = 'plain' }: Partial<typeof kFirst>): Promise<void> {
  const plain = new Uint8Array(await (await fetch('newt_plain.mrw')).arrayBuffer());
  if (sample) await stage.addPlain(plain, { deformer, other });
}

function title(name: string, more: string): void {
  by('name').textContent = name;
  by('about').textContent = more;
  app.tell('status', `${name} is shown.`);
}

function useFiles(stage: Stage): void {
  for (const id of ['files', 'folder']) {
    const input = by(id) as HTMLInputElement;
    by(`open-${id}`).addEventListener('click', () => input.click());
    input.addEventListener('change', () => {
      const found = input.files ? chosen(input.files) : [];
      input.value = '';
      if (found.length > 0) void take(stage, async () => found);
    });
  }
  const cover = by('drop');
  let depth = 0;
  window.addEventListener('dragenter', () => { cover.hidden = ++depth === 0; });
  window.addEventListener('dragleave', () => { cover.hidden = --depth <= 0; });
  window.addEventListener('dragover', (event) => event.preventDefault());
  window.addEventListener('drop', (event) => {
    event.preventDefault();
    depth = 0;
    cover.hidden = true;
    if (event.dataTransfer) {
      const transfer = event.dataTransfer;
      void take(stage, () => dropped(transfer));
    }
  });
}

// What comes: shown as it is if it is cooked, and cooked first otherwise.
async function take(stage: Stage, found: () => ReturnType<typeof dropped>): Promise<void> {
  alertBox.replaceChildren();
  try {
    const source = await sourceOf(await found(), mayRead);
    if (!source) return;
    app.options = settingsOf(source);
    await show(stage, source, { ...kFirst, playing: app.settings.playing, coarseness: app.settings.coarseness });
  } catch (failure) {
    app.tell('error', sentence(failure));
  }
}

async function again(stage: Stage): Promise<void> {
  alertBox.replaceChildren();
  try {
    await show(stage, app.shown!.source!, app.settings);
  } catch (failure) {
    app.tell('error', sentence(failure));
  }
}

// Options that make linear blend skinning another one than the source's.
const kBetter = /^\s*(as|helpers|mwe|psd|eigenskin)\b/m;

async function show(stage: Stage, source: Source, settings: Partial<typeof kFirst>): Promise<void> {
  // What was cooked of it before without a better deformer is what the better one is compared with.
  const before = app.shown?.source === source ? app.shown : null;
  const plain = before?.plain ?? (before && !kBetter.test(before.options) ? before.cooked : null);
  const shown = isCooked(source) ? opened(source) : await cooked(source);
  if (!shown) return;
  if (kBetter.test(shown.options)) shown.plain = plain;
  await stage.open(shown, settings);
  sample = false;
  const { about } = app.viewer!;
  if (about.deformers.includes('plain')) app.set({ deformer: 'plain', other: 'as' });
  app.set({ split: !about.deformers.includes('as') ? 1 : app.settings.split < 1 ? app.settings.split : 0.5 });
  title(source.document, shown.source
    ? `${bytesText(source.bytes)} → ${bytesText(shown.cooked.length)}, cooked in ${shown.seconds.toFixed(1)} s`
    : bytesText(shown.cooked.length));
}

function opened(source: Source): Shown {
  const cookedBytes = source.files.get(source.document)!;
  return { name: source.document, cooked: cookedBytes, options: '', plain: null, source: null, report: null, seconds: 0,
           decode: decoder('', source.files) };
}

// A marrow.toml that was dropped along says what it says for all files.
function settingsOf(source: Source): string {
  const own = [...source.files].find(([path]) => path === 'marrow.toml' || path.endsWith('/marrow.toml'));
  const text = own ? new TextDecoder().decode(own[1]) : '';
  return text.split(/^\s*\[\[?\s*file\b/m)[0]!.trim();
}

async function cooked(source: Source): Promise<Shown | null> {
  cooking?.abort();
  const stop = cooking = new AbortController();
  const stageName = element('p', { role: 'status' }, 'The cooker is loaded.'), bar = element('progress', { 'aria-label': 'Progress' });
  busy.replaceChildren(element('h2', {}, source.document), stageName, bar, button('Cancel', () => stop.abort()));
  busy.oncancel = () => stop.abort();
  if (!busy.open) busy.showModal();
  try {
    const made = await cook(source.document, source.files, app.options, (name, done, count) => {
      stageName.textContent = kStages[name] ?? name;
      if (count > 0) Object.assign(bar, { max: count, value: done });
      else bar.removeAttribute('value');
    }, stop.signal);
    return { name: source.document, cooked: made.file, plain: null, options: app.options, source, report: made.report, seconds: made.seconds,
             decode: decoder(source.document, source.files) };
  } catch (failure) {
    if (stop.signal.aborted) return null;
    throw failure;
  } finally {
    if (cooking === stop) {
      cooking = undefined;
      busy.close();
    }
  }
}
let cooking: AbortController | undefined;
const kStages: Record<string, string> = {
  read: 'Reading the model', prepare: 'Looking at skeleton and skin', clip: 'Packing clips', mesh: 'Preparing meshes',
  learn: 'Learning how it deforms', write: 'Packing meshes',
};

// Somebody is asked before much is read.
async function mayRead(bytes: number): Promise<boolean> {
  if (bytes <= kMuch) return true;
  const { memory_bytes, seconds } = estimate(bytes);
  const dialog = by('ask') as HTMLDialogElement;
  return new Promise((resolve) => {
    const end = (yes: boolean) => () => { dialog.close(); resolve(yes); };
    dialog.oncancel = () => resolve(false);
    dialog.replaceChildren(element('h2', {}, `${bytesText(bytes)} is much for a page`),
      element('p', {}, `Cooking it takes about ${bytesText(memory_bytes)} of memory and ${durationText(seconds)} here. ` +
        'The program marrow takes less of both, and uses all processors.'),
      button('Try it', end(true), { class: 'primary' }), button('Leave it', end(false)));
    dialog.showModal();
  });
}

function useDownloads(stage: Stage): void {
  const save = (name: string, content: BlobPart, type: string) => {
    const address = URL.createObjectURL(new Blob([content], { type }));
    const anchor = element('a', { href: address, download: name });
    anchor.click();
    setTimeout(() => URL.revokeObjectURL(address), 10_000);
  };
  const stem = () => app.shown!.name.replace(/^.*\//, '').replace(/\.[^.]*$/, '');
  by('save-mrw').addEventListener('click', () => app.shown && save(`${stem()}.mrw`, app.shown.cooked as Uint8Array<ArrayBuffer>, 'application/octet-stream'));
  by('save-report').addEventListener('click', () =>
    app.shown?.report && save(`${stem()}.json`, JSON.stringify(app.shown.report, null, 2), 'application/json'));
  by('save-picture').addEventListener('click', () => {
    if (!app.viewer) return;
    stage.draw(stage.canvas.width, stage.canvas.height);
    stage.canvas.toBlob((blob) => blob && save(`${stem()}.png`, blob, 'image/png'));
  });
  by('copy-link').addEventListener('click', () => {
    if (!app.viewer) return;
    const first = sample ? { ...kSampleFirst, clip: app.viewer!.about.clips.findIndex((clip) => clip.name === 'twist') } : kFirst;
    const hash = toLink(app, first);
    history.replaceState(null, '', hash ? `#${hash}` : location.pathname + location.search);
    void navigator.clipboard?.writeText(location.href).catch(() => {});
    app.tell('status', sample ? 'The link is copied.' : 'The link is copied. It holds what is set, not the file: who opens it drops the same file.');
  });
  by('show-newt').addEventListener('click', () => void cookSample(stage));
  app.on('file', () => {
    (by('save-report') as HTMLButtonElement).disabled = !app.shown?.report;
  });
}

// The newt from its source, so that it can be cooked otherwise.
async function cookSample(stage: Stage): Promise<void> {
  const files = new Map<string, Uint8Array>();
  for (const name of kSample) files.set(name, new Uint8Array(await (await fetch(name)).arrayBuffer()));
  app.options = kSampleOptions;
  const source = { document: kSample[0]!, files, bytes: files.get(kSample[0]!)!.length };
  await show(stage, source, kFirst).catch((failure) => app.tell('error', sentence(failure)));
}

start().catch((failure) => app.tell('error', sentence(failure)));
Object.assign(globalThis, { marrowPage: app });
