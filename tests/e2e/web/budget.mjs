// What a browser loads before the page can be used, compressed: it stays small, so that the page is there at once.
import { readdirSync, readFileSync, statSync } from 'node:fs';
import path from 'node:path';

const kMost_bytes = 80_000;
const dist = path.resolve(process.argv[2]);
const assets = path.join(dist, 'assets');
const kFirst = /^(?:app|chunk|live|icon)-.*\.(?:js|css|svg)\.gz$/; // languages other than English come later

const files = readdirSync(assets).filter((name) => kFirst.test(name));
const sizes = files.map((name) => statSync(path.join(assets, name)).size);
const sum = sizes.reduce((all, one) => all + one, statSync(path.join(dist, 'index.html')).size);
files.forEach((name, i) => console.log(`${sizes[i]} ${name}`));
console.log(`${sum} bytes compressed, at most ${kMost_bytes}`);

const page = readFileSync(path.join(dist, 'index.html'), 'utf8');
const named = [...page.matchAll(/\/assets\/([^"]+)/g)].map(([, name]) => name);
const missing = named.filter((name) => !readdirSync(assets).includes(name));
if (missing.length > 0 || named.length < 4) throw new Error(`index.html names what is not there: ${missing.join(', ')}`);
if (files.length < 4 || sum > kMost_bytes) process.exit(1);
