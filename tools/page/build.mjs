// Builds the page: node build.mjs PACKAGES OUT      (a folder where npm has installed package.json; the folder of the site)
import { copyFileSync, mkdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

const [packages, out] = process.argv.slice(2).map((path) => resolve(path));
const here = import.meta.dirname;
const { build } = createRequire(join(packages, '/'))('esbuild');
mkdirSync(out, { recursive: true });
await build({
  entryPoints: ['main', 'cook_worker'].map((name) => join(here, 'src', `${name}.ts`)),
  outdir: out, bundle: true, format: 'esm', target: 'es2022', minify: true, legalComments: 'none', logLevel: 'warning',
});
for (const name of ['index.html', 'style.css']) copyFileSync(join(here, name), join(out, name));
