// The search of the documentation: the index has the addresses that the pages give, and what is looked for comes first.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { htmlOf } from '../docs.mjs';
import { entriesOf, indexOf } from '../docs_index.mjs';
import { searchOf } from '../src/docs/find';

const tableOf = (words: string[]): string => `| word | does | | manual |\n|---|---|---|---|\n${words.map((word) => `| \`${word}\` | effect of ${word} | – | manual |`).join('\n')}\n`;
const kCodes = ['G00', 'G01', 'G02', 'G54', 'G54.1', 'G84', 'M06', '$P_IFRAME', '<name>'];
const kWords = `# Words: a control\n\n## Codes\n\nEvery word of the control.\n\n${tableOf(kCodes)}`;
const kText = '# Lines\n\nA line is *torn* where a block broke off.\n\n## Torn blocks\n\nA person confirms that the control was reset. `G54` & more.\n\n### Torn blocks\n\nAgain.\n';

const index = indexOf([
  { name: 'index', label: 'dripfeed', html: htmlOf('# dripfeed\n\nFeeds torn-proof.\n') },
  { name: 'lines', label: 'Lines', html: htmlOf(kText) },
  { name: 'words-a', label: 'A control', html: htmlOf(kWords) },
]);
const search = searchOf(index);
const addresses = (query: string): string[] => search(query).hits.map(({ href }) => href);

test('an entry has the address that the page gives to its heading or row', () => {
  const html = htmlOf(kText) + htmlOf(kWords);
  for (const { id } of [...entriesOf(htmlOf(kText)), ...entriesOf(htmlOf(kWords))])
    assert.ok(html.includes(`id="${id}"`), id);
  assert.deepEqual(entriesOf(htmlOf(kText)).map(({ id }) => id), ['lines', 'torn-blocks', 'torn-blocks-1']);
  const rows = entriesOf(htmlOf(kWords)).slice(2);
  assert.deepEqual(rows.map(({ heading }) => heading), kCodes);
  assert.equal(new Set(rows.map(({ id }) => id)).size, kCodes.length);
});

test('the text of an entry is that of the page, without tags and without its rows', () => {
  assert.equal(entriesOf(htmlOf(kText))[1]!.text, 'A person confirms that the control was reset. G54 & more.');
  assert.equal(entriesOf(htmlOf(kWords))[1]!.text, 'Every word of the control. word does manual');
  assert.equal(entriesOf(htmlOf(kWords))[4]!.text, 'effect of G02 · manual');
});

test('rows of a short table have no address', () => {
  assert.equal(entriesOf(htmlOf(`# T\n\n${tableOf(kCodes.slice(0, 7))}`)).length, 1);
});

test('a word of a control leads to its row, with and without leading zeros', () => {
  assert.equal(addresses('G54')[0], '/docs/words-a#row-G54');
  assert.equal(addresses('g1')[0], '/docs/words-a#row-G01');
  assert.equal(addresses('m6')[0], '/docs/words-a#row-M06');
  assert.equal(addresses('$p_iframe')[0], '/docs/words-a#row--P_IFRAME');
  assert.ok(!addresses('G54.1').includes('/docs/words-a#row-G54'));
});

test('headings come before texts, beginnings of words are found, middles are not', () => {
  assert.deepEqual(addresses('torn').slice(0, 2), ['/docs/lines#torn-blocks', '/docs/lines#torn-blocks-1']);
  assert.ok(addresses('torn').includes('/docs#dripfeed'));
  assert.deepEqual(addresses('confir'), ['/docs/lines#torn-blocks']);
  assert.deepEqual(addresses('onfirms'), []);
  assert.deepEqual(addresses('  '), []);
});

test('all words must be found, the page counts as well', () => {
  assert.deepEqual(addresses('torn reset'), ['/docs/lines#torn-blocks']);
  assert.deepEqual(addresses('control G84'), ['/docs/words-a#row-G84']);
  assert.deepEqual(addresses('torn G84'), []);
});

test('a question is searched by the words that tell what it is about', () => {
  assert.deepEqual(addresses('How is the control reset?'), addresses('control reset'));
  assert.equal(addresses('control reset')[0], '/docs/lines#torn-blocks');
  assert.ok(addresses('is').includes('/docs/lines#lines'), 'alone, a small word is looked for');
});

test('what is found is marked in the text, and nothing of the text is lost at its places', () => {
  const [hit] = search('control reset').hits;
  assert.equal(hit!.text.map(({ text }) => text).join(''), 'A person confirms that the control was reset. G54 & more.');
  assert.deepEqual(hit!.text.filter(({ isHit }) => isHit).map(({ text }) => text), ['control', 'reset']);
  const long = searchOf({ pages: [['/docs/a', 'A']], entries: [[0, 'x', 'X', `${'filler '.repeat(60)}needle ${'rest '.repeat(90)}`]] })('needle').hits[0]!;
  assert.match(long.text.map(({ text }) => text).join(''), /^… .*needle.* …$/);
  assert.ok(long.text.map(({ text }) => text).join('').length < 280);
});

test('many hits are counted, the best are given', () => {
  const entries = Array.from({ length: 100 }, (_, i): [number, string, string, string] => [0, `h${i}`, `Heading ${i}`, 'the same text']);
  const found = searchOf({ pages: [['/docs/a', 'A']], entries })('same');
  assert.equal(found.count, 100);
  assert.equal(found.hits.length, 30);
});
