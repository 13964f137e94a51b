// Builds the page: one script and one style sheet with fixed names, flat in dist/assets, and index.html beside them.
//   node build.mjs           the page, minified
//   node build.mjs --watch   the page, again after each change
//   node build.mjs --tests   the unit tests, each as one file that node runs
import { copyFile, mkdir, readdir, rm } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import * as esbuild from 'esbuild';

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
  });
}

async function buildPage(watch) {
  const out = at('dist', 'assets');
  await rm(at('dist'), { recursive: true, force: true });
  await mkdir(out, { recursive: true });
  await copyFile(at('src', 'index.html'), at('dist', 'index.html'));
  await copyFile(at('src', 'icon.svg'), path.join(out, 'icon.svg'));
  const options = {
    ...common,
    entryPoints: { app: at('src', 'main.tsx') },
    outdir: out,
    format: 'esm',
    minify: !watch,
    sourcemap: 'linked',
    legalComments: 'none',
  };
  if (!watch) return esbuild.build(options);
  return (await esbuild.context(options)).watch();
}

if (process.argv.includes('--tests')) {
  await buildTests();
} else {
  await buildPage(process.argv.includes('--watch'));
}
