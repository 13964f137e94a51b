// The packages that the page consists of, as the bundler saw them, with their licences. A package without a licence's text
// ends the build: nothing is shipped under terms that no person has read.
import { readdir, readFile } from 'node:fs/promises';
import path from 'node:path';

// "node_modules/@codemirror/view/dist/index.js" is of "@codemirror/view".
export function packageOf(input) {
  const [, name] = /(?:^|\/)node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(input) ?? [];
  return name ?? null;
}

export const packagesOf = (inputs) => [...new Set(inputs.map(packageOf).filter((name) => name !== null))].sort();

async function licenceOf(root, name) {
  const folder = path.join(root, 'node_modules', name);
  const { version, license } = JSON.parse(await readFile(path.join(folder, 'package.json'), 'utf8'));
  const file = (await readdir(folder)).find((one) => /^licen[cs]e(?:\.(?:md|txt))?$/i.test(one));
  if (typeof license !== 'string' || !file) throw new Error(`${name}: its package states no licence, or has no text of it`);
  return { name, version, license, text: (await readFile(path.join(folder, file), 'utf8')).trim() };
}

// As markdown. A text in a fence stays as its author wrote it.
export const sectionOf = ({ name, version, license, text }) => `### ${name} ${version}: ${license}\n\n~~~~text\n${text}\n~~~~\n`;

export async function licencesOf(root, inputs) {
  const all = await Promise.all(packagesOf(inputs).map((name) => licenceOf(root, name)));
  if (all.length === 0) throw new Error('no package was found in what was built');
  return all.map(sectionOf).join('\n');
}
