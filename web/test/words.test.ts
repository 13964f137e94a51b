// The texts in two parts: what the page loads first has all that it may show.
import assert from 'node:assert/strict';
import path from 'node:path';
import { test } from 'node:test';
import en from '../src/i18n/en.json';
import { partsOf } from '../words.mjs';

const groupsOf = (words: Record<string, string>) => new Set(Object.keys(words).map((id) => id.split('.')[0]));

test('each text is in one part, and no group but that of sentences is in both', async () => {
  const { first, rest } = await partsOf(path.resolve('src/main.tsx'), en);
  assert.deepEqual({ ...rest, ...first }, { ...en });
  assert.equal(Object.keys(first).length + Object.keys(rest).length, Object.keys(en).length);
  assert.deepEqual([...groupsOf(first)].filter((group) => groupsOf(rest).has(group)), ['said']);
});

test('what a file names that is loaded first is in the first part, by whole ids or by parts of them', async () => {
  const { first, rest } = await partsOf(path.resolve('src/main.tsx'), en);
  for (const id of ['dialog.back', 'nav.floor', 'job_state.queued', 'stall.hold']) if (id in en) assert.ok(id in first, id);
  assert.ok('editor.find' in rest, 'the editor is loaded on demand');
  assert.ok('said.store_disk_full' in rest, 'until it is there the sentence is shown as the server wrote it');
  assert.ok('said.disarmed' in first, 'its cause is a name that the server does not spell out');
});
