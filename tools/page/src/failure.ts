// What cannot be done, in the cooker's words: file, place, rule, advice. code: as the program's exit codes.
export class Failure extends Error {
  constructor(message: string, readonly code: number) { super(message); }
}
export const sentence = (error: unknown): string => error instanceof Error ? error.message : String(error);
