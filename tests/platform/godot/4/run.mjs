// Runs a pack in a Godot that is built for browsers, in a headless Chromium.
// usage: node run.mjs GODOT GAME.pck PICTURE.png      (the folder with index.js and index.wasm; what it draws)
// Prints what Godot prints, and exits as the game does; 1 if it does not end.
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';

const kMost_s = 60;
const [godot, pack, picture] = process.argv.slice(2);
const files = {
  '/page.html': [path.join(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), 'page.html'), 'text/html'],
  '/index.js': [path.join(godot, 'index.js'), 'text/javascript'],
  '/index.wasm': [path.join(godot, 'index.wasm'), 'application/wasm'],
  '/game.pck': [pack, 'application/octet-stream'],
};
let chromium;
const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'marrow-godot-'));
const result = await new Promise((done) => {
  const server = http.createServer((request, answer) => {
    const file = files[new URL(request.url, 'http://localhost').pathname];
    const said = [];
    request.on('data', (data) => said.push(data));
    request.on('end', () => {
      answer.writeHead(file || request.method === 'POST' ? 200 : 404, { 'content-type': file?.[1] ?? 'text/plain' });
      answer.end(file && fs.readFileSync(file[0]));
      if (request.method === 'POST') done(JSON.parse(Buffer.concat(said)));
    });
  });
  server.listen(0, '127.0.0.1', () => {
    chromium = spawn('chromium', ['--headless=new', '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader', `--user-data-dir=${profile}`,
      `http://127.0.0.1:${server.address().port}/page.html`], { detached: true, stdio: 'ignore' });
    chromium.on('error', (error) => done({ code: 1, lines: [error.message] }));
    chromium.on('exit', () => done({ code: 1, lines: ['Chromium ended before the game did'] }));
  });
  setTimeout(() => done({ code: 1, lines: [`Godot has not ended after ${kMost_s} s`] }), 1000 * kMost_s);
});
chromium.removeAllListeners('exit');
const ended = new Promise((done) => chromium.on('exit', done));
if (chromium.pid && chromium.exitCode === null && process.kill(-chromium.pid, 'SIGKILL')) await ended;
fs.rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
for (const line of result.lines) {
  if (line.startsWith('PNG:')) fs.writeFileSync(picture, Buffer.from(line.slice(4), 'base64'));
  else console.log(line);
}
process.exit(result.code);
