// Draws pairs of glTF files with three.js in a headless Chromium and compares the pictures.
// usage: node compare.mjs MODULES PICTURES SOURCE.glb EXPORT.glb [SOURCE.glb EXPORT.glb ...]
// Prints one line a pair; exit 1 if a pair differs, 3 if Chromium cannot be started. Pictures go to the folder PICTURES.
import fs from "node:fs";
import http from "node:http";
import path from "node:path";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

// A pixel differs by more than rounding can; a picture by more pixels than edges that fall the other way.
const kMostStep = 12, kMostShare = 0.004, kLeastDrawn = 0.005;

const [modules, pictures, ...files] = process.argv.slice(2);
const here = import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname);
const resolve = createRequire(path.resolve(modules, "package.json")).resolve;
const load = async (name) => import(pathToFileURL(resolve(name)));

function serve() {
  const types = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };
  const server = http.createServer((request, response) => {
    const url = decodeURIComponent(request.url);
    const file = url.startsWith("/modules/") ? path.join(modules, "node_modules", url.slice(9))
               : url.startsWith("/file") ? path.join(path.dirname(files[parseInt(url.slice(5))]), path.basename(url))
               : path.join(here, "page.html");
    fs.readFile(file, (error, data) => {
      response.writeHead(error ? 404 : 200, { "content-type": types[path.extname(file)] || "application/octet-stream" });
      response.end(data);
    });
  });
  return new Promise((done) => server.listen(0, "127.0.0.1", () => done(server)));
}

async function start() {
  process.env.AWS_LAMBDA_JS_RUNTIME ??= "nodejs20.x";  // the package then unpacks the libraries that Chromium wants
  const chromium = (await load("@sparticuz/chromium")).default;
  const puppeteer = (await load("puppeteer-core")).default;
  return puppeteer.launch({
    executablePath: await chromium.executablePath(), headless: "shell", protocolTimeout: 600_000, timeout: 300_000,
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
           // slow machines are no hangs
           "--disable-gpu-watchdog", "--disable-hang-monitor", "--disable-dev-shm-usage"] });
}

function compare(a, b) {
  let differing = 0, drawn = 0;
  for (let i = 0; i < a.length; i += 4) {
    const background = a[i] === 0x20 && a[i + 1] === 0x20 && a[i + 2] === 0x20;
    drawn += !background;
    differing += [0, 1, 2].some((c) => Math.abs(a[i + c] - b[i + c]) > kMostStep);
  }
  return { differing: differing / (a.length / 4), drawn: drawn / (a.length / 4) };
}

async function main() {
  let browser;
  try {
    browser = await start();
  } catch (error) {
    console.error(`compare: Chromium cannot be started: ${error.message}`);
    process.exit(3);
  }
  const server = await serve(), page = await browser.newPage();
  page.setDefaultTimeout(300_000);
  page.on("pageerror", (error) => console.error(`page: ${error.message}`));
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  await page.waitForFunction("window.ready");
  const draw = (i, clip, share, frame) => page.evaluate((...a) => window.draw(...a),
    `/file${i}/${encodeURIComponent(path.basename(files[i]))}`, clip, share, frame);
  let failed = 0, compared = 0;
  fs.mkdirSync(pictures, { recursive: true });
  for (let i = 0; i < files.length; i += 2) {
    const name = path.basename(files[i]).replace(/\.\w+$/, ""), rest = await draw(i, -1, 0);
    let worst = 0, least = 1;
    for (const [clip, share] of [[-1, 0], ...(rest.clips.length ? [[0, 0.3], [0, 0.7], [rest.clips.length - 1, 0.5]] : [])]) {
      const a = await draw(i, clip, share, rest.frame), b = await draw(i + 1, clip, share, rest.frame);
      const { differing, drawn } = compare(a.pixels, b.pixels);
      worst = Math.max(worst, differing);
      least = Math.min(least, drawn);
      ++compared;
      [[a, "source"], [b, "export"]].forEach(([p, which]) => fs.writeFileSync(
        path.join(pictures, `${name}_${clip}_${share}_${which}.png`), Buffer.from(p.picture.split(",")[1], "base64")));
    }
    const good = worst <= kMostShare && least >= kLeastDrawn;
    failed += !good;
    console.log(`${good ? "ok    " : "DIFFER"} ${name}: ${(100 * worst).toFixed(3)} % of pixels differ, ${(100 * least).toFixed(1)} % drawn`);
  }
  console.log(`three.js: ${files.length / 2} models, ${compared} pairs of pictures, ${failed} models differ`);
  await browser.close();
  server.close();
  process.exit(failed || !compared ? 1 : 0);
}
main().catch((error) => { console.error(`compare: ${error.stack}`); process.exit(1); });
