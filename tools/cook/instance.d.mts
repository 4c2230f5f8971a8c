// Types of instance.mjs.
export const stages: Stage[];
export type Stage = 'read' | 'prepare' | 'clip' | 'mesh' | 'learn' | 'write';
export class CookFailure extends Error {
  constructor(message: string, code: number);
  readonly code: number;
}
export function cook(module: WebAssembly.Module, name: string, options: string,
                     read: (name: string) => Uint8Array | null | undefined,
                     progress?: (stage: Stage, done: number, count: number) => void):
  { file: Uint8Array<ArrayBuffer>; report: unknown; memory_bytes: number };
