// Runs before a page that plays the walk on a canvas by requestAnimationFrame(): has it draw 32 frames of 1/64 s,
// compares with the pictures of `marrow render`, and posts what came of it. example.html?plain: a browser without SIMD.
const kPlain = location.search === '?plain', kFrames = 32, kFrame_ms = 1000 / 64;
if (kPlain) WebAssembly.validate = () => false;
const contexts = [], waiting = [];
const getContext = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (...words) {
  const context = getContext.apply(this, words);
  if (words[0] === 'webgl2') contexts.push(context);
  return context;
};
window.requestAnimationFrame = (callback) => waiting.push(callback);

async function watch() {
  const { compare, pixels_of, post, post_png, read_png } = await import('./compare.mjs');
  const fail = (what) => post('failed', String(what?.stack ?? what));
  addEventListener('error', (event) => fail(event.error ?? event.message));
  addEventListener('unhandledrejection', (event) => fail(event.reason));
  while (waiting.length === 0) await new Promise((done) => setTimeout(done, 10));
  const [gl] = contexts, { width, height } = gl.canvas, errors = [], name = kPlain ? 'example_plain' : 'example_simd';
  for (let i = 0; i <= kFrames; ++i) {
    waiting.shift()(i * kFrame_ms);
    const error = gl.getError();
    if (error !== gl.NO_ERROR) errors.push(error);
  }
  const drawn = pixels_of(gl, width, height);
  const [plain, red, green] = await Promise.all(
    ['plain', 'red', 'green'].map((what) => read_png(`${what}_ssd.png`, width, height)));
  const { map, ...found } = compare(drawn, plain, red, green, width, height);
  const other = await read_png('plain_as.png', width, height);
  await post_png(`${name}.png`, drawn, width, height);
  await post_png(`${name}_map.png`, map, width, height);
  const wrong_by_other = compare(drawn, other, red, green, width, height).wrong;
  await post('result', JSON.stringify({ name, errors, wrong_by_other, ...found }));
  location.href = kPlain ? 'self_test.html' : '?plain';
}
watch().catch((error) => fetch('failed', { method: 'POST', body: String(error.stack) }));
