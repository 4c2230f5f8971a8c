// Over the picture: bones, names, the picked joint, goals; and the handle between its halves.
import type { App } from './app';
import { by } from './controls';

const kBone = '#ece9e2', kPicked = '#ffb040', kGoal = '#5adcd2';

export function useOverlay(app: App): void {
  const canvas = by('overlay') as HTMLCanvasElement;
  const pen = canvas.getContext('2d')!;
  app.on('frame', () => {
    const ratio = Math.min(devicePixelRatio || 1, 2), width = canvas.clientWidth, height = canvas.clientHeight;
    if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
    if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    draw(width, height);
  });

  function draw(width: number, height: number): void {
    const { settings, viewer, overlay } = app;
    if (!viewer) return;
    const marks = settings.picked || settings.colours === 'weights';
    if (!overlay.bones && !overlay.names && !marks && settings.goals.length === 0) return;
    const places = viewer.places(), joints = viewer.about.joints;
    const at = (joint: number): [number, number] | null =>
      places[3 * joint + 2]! > 0 ? [places[3 * joint]! * width, places[3 * joint + 1]! * height] : null;
    const line = (width_px: number, colour: string, from: [number, number], to: [number, number]) => {
      for (const [wide, ink] of [[width_px + 2, '#0008'], [width_px, colour]] as const) {
        pen.beginPath();
        pen.lineWidth = wide;
        pen.strokeStyle = ink;
        pen.moveTo(...from);
        pen.lineTo(...to);
        pen.stroke();
      }
    };
    const dot = (radius: number, colour: string, [x, y]: [number, number]) => {
      pen.beginPath();
      pen.arc(x, y, radius, 0, 7);
      pen.fillStyle = colour;
      pen.strokeStyle = '#000a';
      pen.lineWidth = 1.5;
      pen.fill();
      pen.stroke();
    };
    const taken: [number, number][] = [];
    const words = (text: string, colour: string, [x, y]: [number, number]) => {
      if (taken.some(([a, b]) => Math.abs(a - x) < 60 && Math.abs(b - y) < 13)) return;
      taken.push([x, y]);
      pen.font = '12px system-ui, sans-serif';
      pen.lineWidth = 3;
      pen.strokeStyle = '#000b';
      pen.strokeText(text, x + 8, y + 4);
      pen.fillStyle = colour;
      pen.fillText(text, x + 8, y + 4);
    };
    joints.forEach((joint, index) => {
      const here = at(index), parent = joint.parent >= 0 ? at(joint.parent) : null;
      if (overlay.bones && here && parent) line(1.5, kBone, parent, here);
    });
    joints.forEach((_, index) => {
      const here = at(index);
      if (overlay.bones && here) dot(2.5, kBone, here);
    });
    const picked = marks ? at(settings.joint) : null;
    if (picked) {
      dot(5, kPicked, picked);
      words(joints[settings.joint]!.name, kPicked, picked);
    }
    if (overlay.names) joints.forEach((joint, index) => {
      const here = at(index);
      if (here && !(marks && index === settings.joint)) words(joint.name, kBone, here);
    });
    for (let i = joints.length; 3 * i < places.length; ++i) {
      const here = at(i);
      if (here) {
        pen.strokeStyle = kGoal;
        pen.lineWidth = 3;
        pen.strokeRect(here[0] - 9, here[1] - 9, 18, 18);
      }
    }
  }
}

export function useDivide(app: App): void {
  const handle = by('divide'), left = by('left-name'), right = by('right-name');
  const show = () => {
    const { settings, viewer } = app;
    const halves = settings.split < 1 && settings.colours === 'surface' && !!viewer;
    handle.hidden = left.hidden = right.hidden = !halves;
    handle.style.left = `${100 * settings.split}%`;
    handle.setAttribute('aria-valuenow', String(Math.round(100 * settings.split)));
    left.textContent = nameOf(settings.deformer, viewer?.about.deformers ?? []);
    right.textContent = nameOf(settings.other, viewer?.about.deformers ?? []);
  };
  const to = (share: number) => app.set({ split: Math.min(0.98, Math.max(0.02, share)) });
  handle.addEventListener('pointerdown', (event) => {
    handle.setPointerCapture(event.pointerId);
    event.preventDefault();
    handle.focus();
  });
  handle.addEventListener('pointermove', (event) => {
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const box = handle.parentElement!.getBoundingClientRect();
    to((event.clientX - box.left) / box.width);
  });
  handle.addEventListener('keydown', (event) => {
    const by_share = { ArrowLeft: -0.02, ArrowRight: 0.02, PageDown: -0.1, PageUp: 0.1 }[event.key];
    if (by_share === undefined && event.key !== 'Home' && event.key !== 'End') return;
    event.preventDefault();
    event.stopPropagation();
    to(event.key === 'Home' ? 0 : event.key === 'End' ? 1 : app.settings.split + by_share!);
  });
  app.on('settings', show);
  app.on('file', show);
}

const kNames: Record<string, string> = {
  plain: 'Linear blend skinning', rigid: 'Rigid', ssd: 'Linear blend skinning', as: 'Animation space', mwe: 'Multi-weights', psd: 'Pose space',
};
// all: those that there are. Helpers make linear blend skinning of the cooked file better than any engine's.
export const nameOf = (deformer: string, all: string[]): string =>
  deformer === 'ssd' && all.includes('plain') ? 'Linear blend skinning, with helpers' : kNames[deformer] ?? deformer;
