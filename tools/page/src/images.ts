// Images of a model as the browser decodes them.
import { findFile } from './find_file';
import type { Decode, FileImage } from './viewer';

const kMost = 4096;  // pixels each way; larger ones are made smaller

interface Named {
  name: string;
  uri: string;
  bytes: Uint8Array;
}

// What a GLB or glTF document holds and refers to.
export function imagesOf(document: string, files: Map<string, Uint8Array>): Named[] {
  const bytes = files.get(document);
  if (!bytes) return [];
  try {
    const { json, binary } = parts(bytes);
    const views = json.bufferViews ?? [];
    // Equal names are numbered as the cooker does.
    const seen = new Map<string, number>();
    const nameOf = (image: any, index: number): string => {
      const name = image.name || `images[${index}]`;
      if (image.uri && !String(image.uri).startsWith('data:')) return name;
      const count = (seen.get(name) ?? 0) + 1;
      seen.set(name, count);
      return count === 1 ? name : `${name}.${count}`;
    };
    return (json.images ?? []).flatMap((image: any, index: number): Named[] => {
      const view = views[image.bufferView], uri = String(image.uri ?? ''), name = nameOf(image, index);
      if (view && binary && !view.buffer) {
        const at = view.byteOffset ?? 0;
        return [{ name, uri: '', bytes: binary.subarray(at, at + view.byteLength) }];
      }
      const found = uri.startsWith('data:') ? fromData(uri) : findFile(files, decodeURIComponent(uri));
      return found ? [{ name, uri, bytes: found }] : [];
    });
  } catch {
    return [];  // the cooker says what is wrong with it
  }
}

function parts(bytes: Uint8Array): { json: any; binary: Uint8Array | null } {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const text = new TextDecoder();
  if (bytes.length < 20 || view.getUint32(0, true) !== 0x46546C67) return { json: JSON.parse(text.decode(bytes)), binary: null };
  const size = view.getUint32(12, true);
  const json = JSON.parse(text.decode(bytes.subarray(20, 20 + size)));
  return { json, binary: bytes.subarray(28 + size) };
}

function fromData(uri: string): Uint8Array | null {
  const comma = uri.indexOf(',');
  if (!uri.slice(0, comma).endsWith(';base64')) return null;
  return Uint8Array.from(atob(uri.slice(comma + 1)), (c) => c.charCodeAt(0));
}

async function decodeBytes(bytes: Uint8Array): Promise<ImageData | null> {
  try {
    const how: ImageBitmapOptions = { colorSpaceConversion: 'none', premultiplyAlpha: 'none' };
    const bitmap = await createImageBitmap(new Blob([bytes as Uint8Array<ArrayBuffer>]), how);
    const scale = Math.min(1, kMost / Math.max(bitmap.width, bitmap.height));
    const width = Math.max(1, Math.round(bitmap.width * scale)), height = Math.max(1, Math.round(bitmap.height * scale));
    const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true })!;
    context.drawImage(bitmap, 0, 0, width, height);
    bitmap.close();
    return context.getImageData(0, 0, width, height);
  } catch {
    return null;  // the mesh is drawn without
  }
}

// Finds an image of a cooked file in it, by its address among `files`, or by its name inside the source.
export function decoder(document: string, files: Map<string, Uint8Array>): Decode {
  const inside = imagesOf(document, files);
  return async (image: FileImage) => {
    if (image.bytes) return decodeBytes(image.bytes);
    if (image.uri) {
      const found = findFile(files, decodeURIComponent(image.uri));
      return found ? decodeBytes(found) : null;
    }
    const same = inside.find((one) => one.name === image.name) ?? (inside.length === 1 ? inside[0] : undefined);
    return same ? decodeBytes(same.bytes) : null;
  };
}
