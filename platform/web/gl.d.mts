// Types of gl.mjs.
export function glImports(context: WebGL2RenderingContext, exports: () => WebAssembly.Exports): {
  // What WebAssembly imports as "gl".
  imports: WebAssembly.ModuleImports;
  // The context's own of a name, as a WebGLProgram; null if there is none.
  object(name: number): object | null;
  // Deletes all that was made, or forgets what was of a context that was lost.
  release(): void;
};
