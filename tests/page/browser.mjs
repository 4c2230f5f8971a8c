// A browser on the page's own files: a server that counts requests, and Chromium as the tests drive it.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { createRequire } from 'node:module';

const kTypes = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm' };
const kArguments = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist', '--disable-gpu-watchdog', '--disable-hang-monitor', '--disable-dev-shm-usage',
  '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update',
  '--disable-sync', '--js-flags=--expose-gc'];

// Gives the files of a folder, and remembers what was asked for.
export async function serve(folder) {
  const asked = [];
  const server = http.createServer((request, response) => {
    const name = path.basename(new URL(request.url, 'http://x').pathname) || 'index.html', file = path.join(folder, name);
    asked.push(request.url);
    const is = fs.existsSync(file);
    response.writeHead(is ? 200 : 404, { 'content-type': kTypes[path.extname(name)] ?? 'application/octet-stream' });
    response.end(is ? fs.readFileSync(file) : '');
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  return { address: `http://127.0.0.1:${server.address().port}/`, asked, close: () => server.close() };
}

export async function launch(packages) {
  const { chromium } = createRequire(path.join(packages, '/'))('playwright-core');
  return chromium.launch({ executablePath: process.env.MARROW_CHROMIUM ?? '/usr/bin/chromium', args: kArguments });
}

// Opens the page, and keeps what goes wrong in it. Resolves once the first file is on show.
export async function open(browser, site, options = {}) {
  const { hash = '', query = '', slower = 1, ...how } = options;
  const context = await browser.newContext({ viewport: { width: 820, height: 620 }, acceptDownloads: true, ...how });
  const page = await context.newPage();
  page.setDefaultTimeout(30_000 * slower);
  const troubles = [], outside = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(String(error)));
  page.on('request', (request) => {
    if (!request.url().startsWith(site.address) && !/^(blob|data):/.test(request.url())) outside.push(request.url());
  });
  await page.goto(`${site.address}index.html${query}${hash}`);
  await page.waitForSelector('body.ready');
  return { page, context, troubles, outside };
}
