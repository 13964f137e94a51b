// Builds the page into dist: index.html, dist/docs with the documentation, and dist/assets with names that carry a hash of
// the content, each text file compressed as .br and .gz as well.
//   node build.mjs           the page, minified
//   node build.mjs --watch   the page, again after each change
//   node build.mjs --tests   the unit tests, each as one file that node runs
import { mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { brotliCompress, constants, gzip } from 'node:zlib';
import * as esbuild from 'esbuild';
import { writeDocs } from './docs.mjs';
import { licencesOf } from './licences.mjs';
import { splitWords } from './words.mjs';

const root = path.dirname(fileURLToPath(import.meta.url));
const at = (...parts) => path.join(root, ...parts);
const common = { bundle: true, target: 'es2022', logLevel: 'info', absWorkingDir: root };

async function buildTests() {
  const out = at('node_modules', '.tests');
  await rm(out, { recursive: true, force: true });
  const tests = (await readdir(at('test'))).filter((name) => name.endsWith('.test.ts'));
  await esbuild.build({
    ...common,
    entryPoints: tests.map((name) => at('test', name)),
    outdir: out,
    outExtension: { '.js': '.mjs' },
    format: 'esm',
    platform: 'node',
    target: 'node18',
    sourcemap: 'inline',
    logLevel: 'warning',
    plugins: [splitWords(root, true)],
  });
}

// The page names what was built: the script, the sheet, the icon, the worker that the script starts, and the manifest by which a browser installs it. There is
// no service worker: it could show a machine's state of before.
async function writePage(outputs) {
  const builtFrom = (source) => {
    const found = Object.entries(outputs).find(([, output]) => output.entryPoint === source);
    if (!found) throw new Error(`${source} was not built`);
    return found;
  };
  const asset = (file) => `/assets/${path.basename(file)}`;
  const [script, { cssBundle }] = builtFrom('src/main.tsx');
  const [worker] = builtFrom('src/live/worker.ts');
  const icon = Object.keys(outputs).find((file) => file.endsWith('.svg'));
  const manifest = 'dripfeed.webmanifest';
  await writeFile(at('dist', 'assets', manifest), (await readFile(at('src', 'manifest.webmanifest'), 'utf8')).replace('{icon}', asset(icon)));
  const places = { script, style: cssBundle, worker, icon, manifest };
  let page = await readFile(at('src', 'index.html'), 'utf8');
  for (const [name, file] of Object.entries(places)) {
    if (!file || !page.includes(`{${name}}`)) throw new Error(`index.html: no place or no file for {${name}}`);
    page = page.replaceAll(`{${name}}`, asset(file));
  }
  await writeFile(at('dist', 'index.html'), page);
}

// The pages of the documentation, with their own sheet and the page's icon.
async function writeDocPages({ inputs, outputs }) {
  const address = (wanted) => `/assets/${path.basename(Object.keys(outputs).find(wanted))}`;
  await writeDocs({
    repository: at('..'),
    into: at('dist', 'docs'),
    assets: at('dist', 'assets'),
    style: address((file) => /\/docs-[^/]*\.css$/.test(file)),
    icon: address((file) => file.endsWith('.svg')),
    licences: await licencesOf(root, Object.keys(inputs)),
    reference: address((file) => /\/reference-[^/]*\.js$/.test(file)),
    search: address((file) => /\/search-[^/]*\.js$/.test(file)),
  });
}

const kTexts = /\.(?:js|css|svg|html|json|webmanifest)$/;

async function compress(folder) {
  const pack = { br: promisify(brotliCompress), gz: promisify(gzip) };
  for (const name of await readdir(folder)) {
    if (!kTexts.test(name)) continue;
    const text = await readFile(path.join(folder, name));
    const hard = { params: { [constants.BROTLI_PARAM_QUALITY]: 11 } };
    await writeFile(path.join(folder, `${name}.br`), await pack.br(text, hard));
    await writeFile(path.join(folder, `${name}.gz`), await pack.gz(text, { level: 9 }));
  }
}

const finish = {
  name: 'finish',
  setup(build) {
    build.onEnd(async (result) => {
      if (!result.metafile) return;
      await writePage(result.metafile.outputs);
      await writeDocPages(result.metafile);
      await compress(at('dist', 'assets'));
      await compress(at('dist', 'docs'));
    });
  },
};

async function buildPage(watch) {
  await rm(at('dist'), { recursive: true, force: true });
  await mkdir(at('dist', 'assets'), { recursive: true });
  const options = {
    ...common,
    entryPoints: { app: 'src/main.tsx', live: 'src/live/worker.ts', icon: 'src/icon.svg', docs: 'src/styles/docs.css', reference: 'src/reference/main.ts', search: 'src/docs/main.ts' },
    outdir: at('dist', 'assets'),
    entryNames: '[name]-[hash]',
    chunkNames: '[name]-[hash]',
    assetNames: '[name]-[hash]',
    loader: { '.svg': 'copy' },
    format: 'esm',
    splitting: true,
    metafile: true,
    minify: !watch,
    sourcemap: 'linked',
    legalComments: 'none',
    plugins: [splitWords(root), finish],
  };
  if (!watch) return esbuild.build(options);
  return (await esbuild.context(options)).watch();
}

if (process.argv.includes('--tests')) {
  await buildTests();
} else {
  await buildPage(process.argv.includes('--watch'));
}
