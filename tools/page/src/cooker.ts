// Cooks models in a worker, which is made for the first of them. cook_worker.js and cook.wasm lie beside the page's script.
import { CookFailure, type Stage } from '../../cook/instance.mjs';
import type { Report } from './report';

export { CookFailure, type Stage };

export interface Cooked {
  file: Uint8Array<ArrayBuffer>;
  report: Report;
  seconds: number;       // of cooking alone
  memory_bytes: number;  // that the cooker came to
}

// What the worker is asked, and says.
export interface Order {
  document: string;
  files: Map<string, Uint8Array>;
  options: string;
}
export type Answer =
  { stage: Stage; done: number; count: number } | { cooked: Cooked } | { failed: string; code: number };

type OnProgress = (stage: Stage, done: number, count: number) => void;

const kInternal = 5;
const kMostKept_bytes = 256 << 20;  // of a worker that waits for the next cook: what it used goes with it alone

let worker: Worker | undefined;
let before: Promise<unknown> = Promise.resolve();

// Cooks `document`, the name of one of `files`; those that it refers to are found among them by findFile(). options: text
// as marrow.toml has it for all files. onProgress: 0 of 0 as a stage begins. Rejects with CookFailure, which has the
// cooker's own sentence, and with signal.reason once that is aborted, which ends the worker. Cooks wait for each other.
export function cook(document: string, files: Map<string, Uint8Array>, options: string, onProgress: OnProgress,
                     signal: AbortSignal): Promise<Cooked> {
  const cooked = before.then(() => cookNow({ document, files, options }, onProgress, signal));
  before = cooked.catch(() => undefined);
  return new Promise((resolve, reject) => {
    const cancel = (): void => reject(signal.reason);  // at once, also while it waits
    signal.addEventListener('abort', cancel);
    cooked.then(resolve, reject).finally(() => signal.removeEventListener('abort', cancel));
  });
}

function cookNow(order: Order, onProgress: OnProgress, signal: AbortSignal): Promise<Cooked> {
  return new Promise((resolve, reject) => {
    signal.throwIfAborted();
    const at = (worker ??= new Worker(new URL('cook_worker.js', import.meta.url), { type: 'module' }));
    const end = (isKept: boolean): void => {
      signal.removeEventListener('abort', cancel);
      at.onmessage = at.onerror = null;
      if (isKept) return;
      at.terminate();
      worker = undefined;
    };
    const fail = (text: string, code: number): void => {
      end(code !== kInternal);
      reject(new CookFailure(text, code));
    };
    const cancel = (): void => {
      end(false);
      reject(signal.reason);
    };
    signal.addEventListener('abort', cancel);
    at.onerror = (event) => fail(`cook_worker.js: ${event.message || 'cannot be loaded'}`, kInternal);
    at.onmessage = ({ data }: MessageEvent<Answer>) => {
      if ('stage' in data) return onProgress(data.stage, data.done, data.count);
      if ('failed' in data) return fail(data.failed, data.code);
      end(data.cooked.memory_bytes <= kMostKept_bytes);
      resolve(data.cooked);
    };
    at.postMessage(order);
  });
}

// What cooking a model of so many bytes takes in a page, about: of a byte, ten of memory and two microseconds. Models of
// 2 MB to 5 MB took 5 to 20, and 0.4 to 3.6; those that move much take the most.
export function estimate(bytes: number): { memory_bytes: number; seconds: number } {
  return { memory_bytes: 10e6 + 10 * bytes, seconds: 0.5 + 2e-6 * bytes };
}
