// Pixels that a page has drawn, compared with pictures of `marrow render`.
const kMostStep = 8;  // of 255
export const post = (where, body) => fetch(where, { method: 'POST', body });

// From the top row down, as bytes R, G, B, A.
export function pixels_of(gl, width, height) {
  const up = new Uint8Array(4 * width * height), out = new Uint8ClampedArray(up.length), row = 4 * width;
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, up);
  for (let y = 0; y < height; ++y) out.set(up.subarray(y * row, (y + 1) * row), (height - 1 - y) * row);
  return out;
}
function flat(width, height) {
  return Object.assign(document.createElement('canvas'), { width, height }).getContext('2d', { colorSpace: 'srgb' });
}
export async function read_png(url, width, height) {
  const bitmap = await createImageBitmap(await (await fetch(url)).blob(), { colorSpaceConversion: 'none' });
  const to = flat(width, height);
  to.drawImage(bitmap, 0, 0);
  return to.getImageData(0, 0, width, height).data;
}
export async function post_png(name, pixels, width, height) {
  const to = flat(width, height);
  to.putImageData(new ImageData(pixels, width, height), 0, 0);
  await post(`picture/${name}`, await new Promise((done) => to.canvas.toBlob(done)));
}

const differ = (a, b, i, most) => [0, 1, 2].some((c) => Math.abs(a[4 * i + c] - b[4 * i + c]) > most);

// Where the red and the green character differ, there it is. Edges are each renderer's own: of pixels that have a
// neighbour of the other kind nothing is asked.
export function compare(web, plain, red, green, width, height) {
  const there = (i) => differ(red, green, i, kMostStep);
  let wrong = 0, inside = 0, edges = 0;
  const map = new Uint8ClampedArray(web.length);
  for (let y = 1; y < height - 1; ++y)
    for (let x = 1; x < width - 1; ++x) {
      const i = y * width + x;
      let near = 0;
      for (const dy of [-width, 0, width]) for (const dx of [-1, 0, 1]) near += there(i + dy + dx);
      edges += near > 0 && near < 9;
      inside += near === 9;
      const bad = near === 9 ? web[4 * i + 3] !== 255 || differ(web, plain, i, kMostStep)
                : near === 0 ? web[4 * i + 3] !== 0 : false;
      wrong += bad;
      map.set(bad ? [255, 0, 0, 255] : near === 9 ? [90, 90, 90, 255] : [near && 160, near && 160, 0, 255], 4 * i);
    }
  return { wrong: wrong / (width * height), inside: inside / (width * height), edges: edges / (width * height), map };
}
