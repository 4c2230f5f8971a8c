// Files as they come: dropped, also in folders, or chosen.
import type { Source } from './app';
import { Failure } from './failure';

const kModels = ['.glb', '.gltf', '.vrm', '.bvh', '.mrw'];
const extension = (name: string): string => name.slice(name.lastIndexOf('.')).toLowerCase();
const depth = (path: string): number => path.split('/').length;

type Found = { path: string; file: File }[];

async function walk(entry: FileSystemEntry, into: Found): Promise<void> {
  if (entry.isFile) {
    const file = await new Promise<File>((done, fail) => (entry as FileSystemFileEntry).file(done, fail));
    into.push({ path: entry.fullPath.replace(/^\//, ''), file });
    return;
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((done, fail) => reader.readEntries(done, fail));
    if (some.length === 0) return;
    for (const one of some) await walk(one, into);
  }
}

export async function dropped(transfer: DataTransfer): Promise<Found> {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.()).filter((entry) => !!entry);
  const found: Found = [];
  if (entries.length === 0) for (const file of transfer.files) found.push({ path: file.name, file });
  for (const entry of entries) await walk(entry!, found);
  return found;
}

export const chosen = (list: FileList): Found =>
  [...list].map((file) => ({ path: file.webkitRelativePath || file.name, file }));

// Which of them is the model: the one that stands highest, glTF before others of the same height.
export async function sourceOf(found: Found, mayRead: (bytes: number) => Promise<boolean>): Promise<Source | null> {
  const models = found.filter(({ path }) => kModels.includes(extension(path)));
  models.sort((a, b) => depth(a.path) - depth(b.path) || kModels.indexOf(extension(a.path)) - kModels.indexOf(extension(b.path)));
  const model = models[0];
  if (!model) throw new Failure('There is no model among these files: drop a .glb, .gltf, .vrm, .bvh or .mrw.', 1);
  const folder = model.path.slice(0, model.path.lastIndexOf('/') + 1);
  const bytes = found.reduce((sum, { file }) => sum + file.size, 0);
  if (!(await mayRead(bytes))) return null;
  const files = new Map<string, Uint8Array>();
  // By paths from the model's folder on, as the model names them.
  for (const { path, file } of found)
    files.set(path.startsWith(folder) ? path.slice(folder.length) : path, new Uint8Array(await file.arrayBuffer()));
  const document = model.path.slice(folder.length);
  const isText = extension(document) === '.gltf';
  return { document, files, bytes: isText ? bytes : model.file.size };
}

export const isCooked = (source: Source): boolean => extension(source.document) === '.mrw';
