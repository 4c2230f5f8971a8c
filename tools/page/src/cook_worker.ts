// The cooker, in a worker. cook.wasm is fetched for the first model; each cook has an instance of its own.
import { cook, CookFailure, type Stage } from '../../cook/instance.mjs';
import type { Answer, Order } from './cooker';
import { findFile } from './find_file';
import type { Report } from './report';

const kBetweenAnswers_ms = 50;

const answer = (what: Answer, transfer: Transferable[] = []): void =>
  (self as unknown as DedicatedWorkerGlobalScope).postMessage(what, transfer);

let compiled: WebAssembly.Module | undefined;

async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(new URL('cook.wasm', import.meta.url)).catch((error: Error) => {
    throw new CookFailure(`cook.wasm: cannot be fetched: ${error.message}`, 2);
  });
  if (!response.ok) throw new CookFailure(`cook.wasm: cannot be fetched: the server says ${response.status}`, 2);
  // Some servers do not know the type, without which browsers refuse to compile while it comes in.
  if (response.headers.get('content-type') === 'application/wasm') return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

// Each stage's beginning and end, and between them what a bar can show.
function teller(): (stage: Stage, done: number, count: number) => void {
  let last = 0;
  return (stage, done, count) => {
    const now = performance.now();
    if (count > 0 && done < count && now - last < kBetweenAnswers_ms) return;
    last = now;
    answer({ stage, done, count });
  };
}

self.onmessage = async ({ data }: MessageEvent<Order>): Promise<void> => {
  const { document, files, options } = data;
  try {
    const module = (compiled ??= await compile());
    const began = performance.now();
    const { file, report, memory_bytes } = cook(module, document, options, (name) => findFile(files, name), teller());
    const seconds = (performance.now() - began) / 1000;
    answer({ cooked: { file, report: report as Report, seconds, memory_bytes } }, [file.buffer]);
  } catch (failure) {
    const told = failure instanceof CookFailure ? failure : new CookFailure(`cook.wasm: ${failure}`, 5);
    answer({ failed: told.message, code: told.code });
  }
};
