// What a program in TypeScript calls: it need compile only.
import { Gles3SkinningPath, Marrow, Status } from 'marrow-animation';
import type { Character, Clip, File, List } from 'marrow-animation';

export async function play(gl: WebGL2RenderingContext, bytes: Uint8Array): Promise<number> {
  const m = await Marrow.fetch(gl, { all: true, simd: false });
  const file: File = m.make('File');
  const status: Status = m.load(m.bytes(bytes), file, null);
  if (status !== Status.OK) throw new Error(m.status_text(status));
  const body: Character = m.make('Character');
  m.must(m.make_character(file, m.make('CharacterOptions', { level: 0 }), m.list('byte', 64), body));
  const clip: Clip = m.make('Clip');
  m.must(m.file_clip(file, 0, clip));
  const matrices: List<number> = m.list('f32', 12);
  matrices.array.fill(0);
  const programs = m.make('Gles3ProgramSet');
  programs.roles[0]!.vertex = 'void main() {}';
  const skinner = m.make('Gles3Skinner');
  const api = m.make('Gles3Api');
  m.must(m.gles3_load_api(api, m.loadProc, null));
  m.must(m.gles3_update(api, skinner, programs, 1));
  const program = m.gl?.object(m.gles3_program_of(skinner, programs, 0)!.id) ?? null;
  gl.useProgram(program as WebGLProgram | null);
  for (const { mesh } of body.meshes) console.log(mesh.name, mesh.geometry.slot_count);
  m.gl?.release();
  m.free(matrices);
  return Gles3SkinningPath.UBO;
}

// What there is not does not compile.
export function wrong(m: Marrow): void {
  // @ts-expect-error: there is no such struct
  m.make('Nothing');
  // @ts-expect-error: a text is no status
  m.must('ok');
  // @ts-expect-error: an argument is missing
  m.load(m.bytes(new Uint8Array(0)), m.make('File'));
}
