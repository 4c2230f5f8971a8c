// What the file costs, before and after, and what the cooker said.
import type { App, Source } from './app';
import { by, bytesText, element, section } from './controls';

const kNames: Record<string, string> = { names_and_structure: 'names and structure' };

export function useCost(app: App): void {
  const root = by('cost');
  app.on('file', () => {
    const { shown, viewer } = app;
    if (!shown || !viewer) return;
    const { about } = viewer;
    const body: (Node | string)[] = [];
    const vertices = about.meshes.reduce((sum, mesh) => sum + mesh.vertices, 0);
    const triangles = about.meshes.reduce((sum, mesh) => sum + mesh.triangles, 0);
    if (shown.source) {
      const before = shown.source.bytes;
      const inside = spentBySource(shown.source);
      body.push(bar('before', before, before, inside), bar('after', about.bytes, before, about.parts));
      // Images that stay files of their own are no gain.
      const left = (inside.find((part) => part.name === 'images')?.bytes ?? 0), kept = partOf(about.parts, 'images');
      const outside = left > 0 && kept < 0.1 * left;
      const from = before - (outside ? left : 0), to = about.bytes - (outside ? kept : 0);
      body.push(element('p', {}, element('strong', {}, `${(from / Math.max(to, 1)).toFixed(1)} times smaller`),
        outside ? `: ${bytesText(from)} → ${bytesText(to)}, images apart, which stay as they are.` : ' than what was dropped.'));
    } else {
      body.push(bar('cooked', about.bytes, about.bytes, about.parts));
    }
    body.push(table(about.parts), element('p', { class: 'quiet' },
      `${about.joints.length} joints, ${vertices.toLocaleString('en')} vertices, ${triangles.toLocaleString('en')} triangles, ` +
      `${about.clips.length - 1} clips${shown.seconds > 0 ? `; cooked here in ${shown.seconds.toFixed(1)} s` : ''}.`));
    const packed = element('p', { class: 'quiet' });
    body.push(packed);
    void gzipped(shown.cooked).then((bytes) => {
      if (bytes) packed.textContent = `${bytesText(bytes)} as a server sends it with gzip.`;
    });
    const warnings = shown.report?.warnings ?? [];
    if (warnings.length > 0) {
      const list = element('ul', { class: 'warnings' }, ...warnings.slice(0, 200).map((warning) =>
        element('li', {}, warning.text, element('code', {}, warning.pointer || '/'))));
      body.push(section(`What was mended or left out (${warnings.length})`, false, list));
    }
    root.replaceChildren(section('Bytes', true, ...body));
  });
}

const partOf = (parts: { name: string; bytes: number }[], name: string): number =>
  parts.find((part) => part.name === name)?.bytes ?? 0;

// A bar as long as its share of `all`, of its parts.
function bar(label: string, bytes: number, all: number, parts: { name: string; bytes: number }[]): HTMLElement {
  const stack = element('div', { class: 'stack' });
  stack.style.width = `${Math.max(2, 100 * bytes / Math.max(all, bytes))}%`;
  for (const part of parts) {
    if (part.bytes === 0) continue;
    const piece = element('i', { class: `part ${part.name}`, title: `${kNames[part.name] ?? part.name}: ${bytesText(part.bytes)}` });
    piece.style.flexGrow = String(part.bytes);
    stack.append(piece);
  }
  return element('div', { class: 'bar' }, element('span', {}, label), stack, element('span', { class: 'number' }, bytesText(bytes)));
}

function table(parts: { name: string; bytes: number }[]): HTMLElement {
  return element('ul', { class: 'parts' }, ...parts.filter((part) => part.bytes > 0).map((part) =>
    element('li', {}, element('i', { class: `part ${part.name}` }), kNames[part.name] ?? part.name,
      element('span', { class: 'number' }, bytesText(part.bytes)))));
}

// Of a GLB: each buffer view counts for what uses it first.
function spentBySource(source: Source): { name: string; bytes: number }[] {
  const bytes = source.files.get(source.document)!;
  const kinds = new Map<string, number>([['geometry', 0], ['clips', 0], ['skeletons', 0], ['images', 0]]);
  try {
    const view = new DataView(bytes.buffer, bytes.byteOffset);
    const isBinary = view.getUint32(0, true) === 0x46546C67;
    const text = isBinary ? bytes.subarray(20, 20 + view.getUint32(12, true)) : bytes;
    const json = JSON.parse(new TextDecoder().decode(text));
    const counted = new Set<number>();
    const count = (kind: string, index: number | undefined) => {
      if (index === undefined || counted.has(index)) return;
      counted.add(index);
      kinds.set(kind, kinds.get(kind)! + (json.bufferViews[index]?.byteLength ?? 0));
    };
    const accessor = (kind: string, index: number | undefined) =>
      index !== undefined && count(kind, json.accessors[index]?.bufferView);
    for (const image of json.images ?? []) count('images', image.bufferView);
    for (const animation of json.animations ?? [])
      for (const sampler of animation.samplers) [sampler.input, sampler.output].forEach((i) => accessor('clips', i));
    for (const skin of json.skins ?? []) accessor('skeletons', skin.inverseBindMatrices);
    for (const mesh of json.meshes ?? []) for (const primitive of mesh.primitives) {
      accessor('geometry', primitive.indices);
      for (const set of [primitive.attributes, ...(primitive.targets ?? [])])
        Object.values(set as Record<string, number>).forEach((i) => accessor('geometry', i));
      count('geometry', primitive.extensions?.KHR_draco_mesh_compression?.bufferView);
    }
  } catch {
    kinds.clear();
  }
  const known = [...kinds.values()].reduce((sum, n) => sum + n, 0);
  return [...kinds, ['names_and_structure', Math.max(0, source.bytes - known)] as [string, number]]
    .map(([name, size]) => ({ name, bytes: size }));
}

async function gzipped(bytes: Uint8Array): Promise<number | null> {
  if (typeof CompressionStream === 'undefined') return null;
  const stream = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(new CompressionStream('gzip'));
  return (await new Response(stream).arrayBuffer()).byteLength;
}
