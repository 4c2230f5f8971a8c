// Hands on the picture: they turn, move and zoom the camera, pick joints, and drag goals.
import type { App } from './app';
import type { Stage } from './stage';

const kClick = 4;   // pixels that a click may move
const kReach = 16;  // pixels from what it means

interface Finger {
  x: number;
  y: number;
}

export function useHands(app: App, stage: Stage): void {
  const canvas = stage.canvas;
  const fingers = new Map<number, Finger>();
  let moved = 0, goal = -1;

  const place = (event: PointerEvent): Finger => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const look = (orbit: () => void): void => {
    orbit();
    if (app.now) app.settings.orbit = app.now.orbit;
    stage.touch();
  };
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    const at = place(event);
    fingers.set(event.pointerId, at);
    moved = fingers.size > 1 ? kClick + 1 : 0;
    goal = fingers.size === 1 && app.viewer ? nearest(at, app.settings.goals.map((_, index) => app.viewer!.about.joints.length + index)) : -1;
  });
  canvas.addEventListener('pointermove', (event) => {
    const from = fingers.get(event.pointerId);
    if (!from || !app.viewer) return;
    const to = place(event), dx = to.x - from.x, dy = to.y - from.y;
    moved += Math.abs(dx) + Math.abs(dy);
    if (fingers.size === 2) {
      const other = [...fingers].find(([id]) => id !== event.pointerId)![1];
      const apart = (a: Finger) => Math.hypot(a.x - other.x, a.y - other.y);
      look(() => {
        app.viewer!.move(dx / 2, dy / 2, canvas.clientHeight);
        app.viewer!.zoom(8 * Math.log(Math.max(apart(to), 1) / Math.max(apart(from), 1)));
      });
    } else if (goal >= 0) {
      app.settings.goals[goal]!.at = app.viewer.dragGoal(goal, dx, dy, canvas.clientHeight);
      stage.touch();
    } else if (event.buttons & 6 || event.shiftKey) {
      look(() => app.viewer!.move(dx, dy, canvas.clientHeight));
    } else if (moved > kClick) {
      look(() => app.viewer!.turn(dx, dy));
    }
    fingers.set(event.pointerId, to);
  });
  const up = (event: PointerEvent): void => {
    const at = fingers.get(event.pointerId);
    fingers.delete(event.pointerId);
    if (!at || event.type !== 'pointerup' || moved > kClick || goal >= 0 || !app.viewer) return;
    const joint = nearest(at, app.viewer.about.joints.map((_, index) => index));
    app.set(joint < 0 ? { picked: false } : { joint, picked: true });
  };
  canvas.addEventListener('pointerup', up);
  canvas.addEventListener('pointercancel', up);
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    look(() => app.viewer?.zoom(-Math.sign(event.deltaY)));
  }, { passive: false });

  // Which of these joints is there, by its place among them; -1: none.
  function nearest(at: Finger, joints: number[]): number {
    const places = app.viewer?.places();
    if (!places) return -1;
    let found = -1, least = kReach;
    joints.forEach((joint, index) => {
      const [x, y, depth] = places.subarray(3 * joint, 3 * joint + 3);
      const far = Math.hypot(x! * canvas.clientWidth - at.x, y! * canvas.clientHeight - at.y);
      if (depth! <= 0 || far >= least) return;
      least = far;
      found = index;
    });
    return found;
  }
}
