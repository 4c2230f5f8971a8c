// The keyboard, where no control has it.
import type { App } from './app';
import { by } from './controls';
import { goTo, stepFrames } from './timeline';

export function useKeys(app: App): void {
  const help = by('help') as HTMLDialogElement;
  by('show-help').addEventListener('click', () => help.showModal());
  by('close-help').addEventListener('click', () => help.close());
  const acts: Record<string, () => void> = {
    ' ': () => app.set({ playing: !app.settings.playing }),
    ArrowLeft: () => stepFrames(app, -1),
    ArrowRight: () => stepFrames(app, 1),
    Home: () => goTo(app, 0),
    End: () => goTo(app, -1),
    f: () => app.set({ orbit: null }),
    '1': () => app.set({ split: 1, deformer: app.settings.deformer === 'ssd' ? 'as' : 'ssd' }),
    '2': () => app.set({ split: app.settings.split < 1 ? 1 : 0.5, colours: 'surface' }),
    '3': () => app.set({ colours: app.settings.colours === 'distance' ? 'surface' : 'distance' }),
    w: () => app.set({ wireframe: !app.settings.wireframe }),
    g: () => app.set({ grid: !app.settings.grid }),
    b: () => { app.overlay.bones = !app.overlay.bones; app.set({}); },
    '?': () => help.showModal(),
  };
  window.addEventListener('keydown', (event) => {
    const target = event.target as HTMLElement;
    if (!app.viewer || event.ctrlKey || event.metaKey || event.altKey || target.closest('input, select, textarea, summary, dialog, [role=listbox]')) return;
    if (event.key === ' ' && target.closest('button')) return;
    const act = acts[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
}
