// The texts of the page in two parts: what the page may show at once, and the rest, which comes with the first view that
// is loaded on demand. No list says which text is which: a file that the page loads first and names a group of ids
// ("order" of "order.title") keeps that whole group in the first part. Sentences of the server without values come later in any
// case: until then each is shown as the server wrote it, in the same words.
import { readFile } from 'node:fs/promises';
import { existsSync } from 'node:fs';
import path from 'node:path';

const kImports = /^(?:import|export)\s(?!type\b)(?:[^'"]*?\sfrom\s)?['"](\.[^'"]+)['"]/gm;
const kQuoted = /['"`]([a-z_]+)(?:\.[^'"`]*)?['"`$]/g;

function fileOf(from, name) {
  const base = path.resolve(path.dirname(from), name);
  return [base, `${base}.ts`, `${base}.tsx`].find((file) => /\.tsx?$/.test(file) && existsSync(file)) ?? null;
}

// The texts of all files that `entry` imports by itself, its own first.
async function textsOf(entry) {
  const texts = new Map();
  const open = [entry];
  while (open.length > 0) {
    const file = open.pop();
    if (texts.has(file)) continue;
    const text = await readFile(file, 'utf8');
    texts.set(file, text);
    for (const [, name] of text.matchAll(kImports)) {
      const next = fileOf(file, name);
      if (next) open.push(next);
    }
  }
  return [...texts.values()];
}

export async function partsOf(entry, words) {
  const named = new Set();
  for (const text of await textsOf(entry)) for (const [, group] of text.matchAll(kQuoted)) named.add(group);
  const isPlain = ([id, text]) => id.startsWith('said.') && !text.includes('{');
  const isFirst = (one) => named.has(one[0].split('.', 1)[0]) && !isPlain(one);
  const all = Object.entries(words);
  return { first: Object.fromEntries(all.filter(isFirst)), rest: Object.fromEntries(all.filter((one) => !isFirst(one))) };
}

// import words from 'words:first' and 'words:rest'; `whole`: all of them are the first.
export const splitWords = (root, whole = false) => ({
  name: 'words',
  setup(build) {
    const catalogue = path.join(root, 'src', 'i18n', 'en.json');
    build.onResolve({ filter: /^words:/ }, ({ path: name }) => ({ path: name.slice('words:'.length), namespace: 'words' }));
    build.onLoad({ filter: /.*/, namespace: 'words' }, async ({ path: part }) => {
      const words = JSON.parse(await readFile(catalogue, 'utf8'));
      const parts = whole ? { first: words, rest: {} } : await partsOf(path.join(root, 'src', 'main.tsx'), words);
      return { contents: JSON.stringify(parts[part]), loader: 'json', watchFiles: [catalogue] };
    });
  },
});
