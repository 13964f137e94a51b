// The pages of the documentation: links lead to pages, headings have the anchors of GitHub, and nothing of a text becomes code.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { hrefOf, htmlOf, slugOf, titleOf } from '../docs.mjs';
import { packageOf, packagesOf, sectionOf } from '../licences.mjs';

test('links between files lead to pages, others stay or become text', () => {
  assert.equal(hrefOf('docs/safety.md'), '/docs/safety');
  assert.equal(hrefOf('safety.md#rules'), '/docs/safety#rules');
  assert.equal(hrefOf('../README.md'), '/docs');
  assert.equal(hrefOf('https://a.b/c.md'), 'https://a.b/c.md');
  assert.equal(hrefOf('#rules'), '#rules');
  assert.equal(hrefOf('../server/app/jobs/jobs.h'), null);
});

test('anchors are those of GitHub, the second one of a name is counted', () => {
  assert.equal(slugOf('The budget, and `link test`'), 'the-budget-and-link-test');
  const html = htmlOf('## Rules\n\n## Rules\n');
  assert.match(html, /id="rules"/);
  assert.match(html, /id="rules-1"/);
});

test('text stays text', () => {
  const html = htmlOf('# T\n\n<script>alert(1)</script>\n\na <b onclick="x">b</b>\n\n```nc\nG1 X<1>\n```\n\n<!-- generated: routes -->\n');
  assert.doesNotMatch(html, /<script|<b |<!--/);
  assert.match(html, /G1 X&lt;1&gt;/);
  assert.equal(titleOf('# A `b` c\n'), 'A b c');
});

test('a drawing is written into the page, another picture is a file', () => {
  const drawings = new Map([['states.svg', '<svg><title>States</title></svg>']]);
  assert.match(htmlOf('![States](pictures/states.svg)\n', drawings), /<svg><title>States/);
  assert.match(htmlOf('![Floor](web/pictures/machines.png)\n', drawings), /<img src="\/docs\/machines\.png"/);
});

test('the packages of a bundle are found, each once', () => {
  assert.equal(packageOf('node_modules/@codemirror/view/dist/index.js'), '@codemirror/view');
  assert.equal(packageOf('src/main.tsx'), null);
  assert.deepEqual(packagesOf(['node_modules/three/build/a.js', 'src/a.ts', 'node_modules/preact/x.mjs', 'node_modules/three/b.js']), ['preact', 'three']);
});

test("a licence's text is shown as its author wrote it", () => {
  const html = htmlOf(sectionOf({ name: 'a', version: '1.2', license: 'MIT', text: '# MIT\n<b>as is</b>\n```\n' }));
  assert.match(html, /<h3 [^>]*>.*a 1\.2: MIT/);
  assert.match(html, /# MIT\n&lt;b&gt;as is&lt;\/b&gt;/);
});
