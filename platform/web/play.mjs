// Plays a character on a canvas by WebGL 2, and goes on when the context is lost. See docs/platforms/web.md.
import load from './newt.mjs';

const kDeformers = { rigid: 1, ssd: 2, as: 3 };    // gles3::Deformer
const kPaths = { ubo: 0, texture: 1, cpu: 4 };     // gles3::SkinningPath; WebGL 2 has no others, see docs/platforms/web.md

// A program, and what goes on in it, for a canvas whose size is what is drawn. Rejects without WebGL 2 or the file.
export async function play(canvas, url, { deformer = 'ssd', path = 'ubo', distance_m = 4.6 } = {}) {
  const [game, response] = await Promise.all([load(), fetch(url)]);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  const file = new Uint8Array(await response.arrayBuffer());
  const context = game.GL.createContext(canvas, { majorVersion: 2, antialias: true, depth: true });
  if (!context) throw new Error('there is no WebGL 2');
  game.GL.makeContextCurrent(context);
  const must = (status) => {
    if (status !== 0) throw new Error(`marrow: status ${status}`);
  };
  const block = game._block(file.length);
  game.HEAPU8.set(file, block);  // HEAPU8 after the call: memory grows, and is then another array
  must(game._start(block, file.length, kDeformers[deformer], kPaths[path]));

  let lost = false;
  canvas.addEventListener('webglcontextlost', (event) => {
    event.preventDefault();  // otherwise the browser never gives it back
    lost = true;
    game._lost();
  });
  canvas.addEventListener('webglcontextrestored', () => {
    must(game._restored());
    lost = false;
  });
  return {
    // Moves time on and draws; false while the context is lost.
    frame(dt_s) {
      if (!lost) must(game._frame(dt_s, canvas.width, canvas.height, distance_m));
      return !lost;
    },
  };
}
