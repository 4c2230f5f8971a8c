// Opens a page in a headless Chromium, and serves it files and takes what it posts until it says that it is done.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { spawn } from 'node:child_process';

const kTypes = { '.html': 'text/html', '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.png': 'image/png' };

const body_of = async (request) => {
  const parts = [];
  for await (const part of request) parts.push(part);
  return Buffer.concat(parts);
};

// get(name): bytes, a text, or null if there is none. post(name, body). A page posts "done", or "failed" and why.
function serve(get, post, done) {
  return http.createServer(async (request, response) => {
    const name = new URL(request.url, 'http://localhost').pathname.slice(1);
    if (request.method === 'POST') {
      const body = await body_of(request);
      post(name, body);
      response.end();
      if (name === 'done') done('');
      if (name === 'failed') done(body.toString());
      return;
    }
    const bytes = get(name);
    response.writeHead(bytes === null ? 404 : 200,
      { 'content-type': kTypes[path.extname(name)] ?? 'application/octet-stream' });
    response.end(bytes ?? '');
  });
}

// The first file of this name in these folders, or null.
export function fileIn(folders, name) {
  const file = folders.map((folder) => path.join(folder, name)).find((there) => fs.existsSync(there));
  return file ? fs.readFileSync(file) : null;
}

// page: what is opened first. work: a folder for a while, which is removed. Gives what failed, or ''.
export async function browse(page, work, most_s, get, post) {
  let chromium;
  const failure = await new Promise((done) => {
    const server = serve(get, post, done).listen(0, '127.0.0.1', () => {
      chromium = spawn('chromium', ['--headless=new', '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
        '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--disable-gpu-watchdog', '--disable-hang-monitor',
        '--disable-dev-shm-usage', '--disable-quic', '--no-first-run', '--disable-background-networking',
        '--disable-component-update', '--disable-sync', `--user-data-dir=${path.join(work, 'profile')}`,
        `http://127.0.0.1:${server.address().port}/${page}`], { stdio: ['ignore', 'ignore', 'pipe'], detached: true });
      chromium.stderr.on('data', (text) => process.env.MARROW_VERBOSE && process.stderr.write(text));
      chromium.on('error', (error) => done(error.message));
      chromium.on('exit', () => done('Chromium ended before the page did'));
    });
    setTimeout(() => done(`the page takes more than ${most_s} s`), 1000 * most_s).unref();
  });
  chromium.removeAllListeners('exit');
  const ended = new Promise((done) => chromium.on('exit', done));
  // Its processes are a group, so that none is left that writes to the profile.
  if (chromium.pid && chromium.exitCode === null && process.kill(-chromium.pid, 'SIGKILL')) await ended;
  try {
    fs.rmSync(work, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 });
  } catch (error) {
    console.error(`${work} is left behind: ${error.code}`);
  }
  return failure;
}
