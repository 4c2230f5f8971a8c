// Which of the files that were dropped together is meant by a path in one of them.

const lastPart = (path: string): string => path.slice(path.lastIndexOf('/') + 1).toLowerCase();
const plain = (path: string): string => path.split('/').filter((part) => part !== '' && part !== '.').join('/');

// The file of exactly this path. Without one, the only file of its last part, whatever folder it is in; of several, the
// only one whose path ends with the whole of this. Null: none, or several.
export function findFile(files: Map<string, Uint8Array>, name: string): Uint8Array | null {
  const exact = files.get(name) ?? files.get(plain(name));
  if (exact) return exact;
  const alike = [...files].filter(([path]) => lastPart(path) === lastPart(name));
  if (alike.length === 1) return alike[0]![1];
  const end = `/${plain(name).toLowerCase()}`;
  const whole = alike.filter(([path]) => `/${path.toLowerCase()}`.endsWith(end));
  return whole.length === 1 ? whole[0]![1] : null;
}
