// What a browser loads before the page can be used, compressed: it stays small, so that the page is there at once. That
// is what index.html names, and what those files import by themselves; what they load on demand comes later.
import { existsSync, readFileSync, statSync } from 'node:fs';
import path from 'node:path';

const kMost_bytes = 83_000;
const dist = path.resolve(process.argv[2]);
const asset = (name) => path.join(dist, 'assets', name);

const page = readFileSync(path.join(dist, 'index.html'), 'utf8');
const named = [...page.matchAll(/\/assets\/([^"]+)/g)].map(([, name]) => name);
const missing = named.filter((name) => !existsSync(asset(name)));
if (missing.length > 0 || named.length < 4) throw new Error(`index.html names what is not there: ${missing.join(', ')}`);

const first = new Set();
function load(name) {
  if (first.has(name)) return;
  first.add(name);
  if (!name.endsWith('.js')) return;
  const text = readFileSync(asset(name), 'utf8');
  for (const [, imported] of text.matchAll(/(?:\bfrom|\bimport)\s*"\.\/([^"]+)"/g)) load(imported);
}
named.forEach(load);

const sizes = new Map([...first].map((name) => [name, statSync(asset(`${name}.gz`)).size]));
const sum = [...sizes.values()].reduce((all, one) => all + one, statSync(path.join(dist, 'index.html')).size);
sizes.forEach((size, name) => console.log(`${size} ${name}`));
console.log(`${sum} bytes compressed, at most ${kMost_bytes}`);
if (![...first].some((name) => name.startsWith('chunk-'))) throw new Error('no file was found that the page imports');
if (sum > kMost_bytes) process.exit(1);
