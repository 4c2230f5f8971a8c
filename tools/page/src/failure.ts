// What cannot be done, in the cooker's words, with the program's exit code: one class for cooker and viewer.
export { CookFailure as Failure } from '../../cook/instance.mjs';
export const sentence = (error: unknown): string => error instanceof Error ? error.message : String(error);
