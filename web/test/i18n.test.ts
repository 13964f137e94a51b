// The catalogues: every id that the page uses is there, in each language, with the same places for values.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { IntlMessageFormat } from 'intl-messageformat';
import de from '../src/i18n/de.json';
import en from '../src/i18n/en.json';
import { localText } from '../src/format/local_text';
import { t, wordOf } from '../src/i18n/i18n';

const catalogues: Record<string, Record<string, string>> = { en, de };
const source = path.resolve('src');

function sources(folder: string): string {
  return readdirSync(folder, { withFileTypes: true })
    .map((entry) => {
      const file = path.join(folder, entry.name);
      if (entry.isDirectory()) return sources(file);
      return /\.tsx?$/.test(entry.name) ? readFileSync(file, 'utf8') : '';
    })
    .join('\n');
}

// Names of the values in a message, in any of its branches.
function places(text: string): string[] {
  const found = new Set<string>();
  const walk = (parts: unknown): void => {
    if (!Array.isArray(parts)) return;
    for (const part of parts as { type: number; value?: string; options?: Record<string, { value: unknown }> }[]) {
      if (part.type !== 0 && part.type !== 7 && part.value) found.add(part.value);
      for (const option of Object.values(part.options ?? {})) walk(option.value);
    }
  };
  walk(new IntlMessageFormat(text, 'en', undefined, { ignoreTag: true }).getAst());
  return [...found].sort();
}

test('every language has the same messages, with the same values', () => {
  for (const [tag, words] of Object.entries(catalogues)) {
    assert.deepEqual(Object.keys(words).sort(), Object.keys(en).sort(), tag);
    for (const [id, text] of Object.entries(words)) assert.deepEqual(places(text), places(catalogues.en?.[id] ?? ''), `${tag} ${id}`);
  }
});

test('every id that the page names is in the catalogue, and none is left over', () => {
  const text = sources(source);
  const named = new Set([...text.matchAll(/['`]([a-z_0-9]+\.[a-z_0-9-]+)['`]/g)].map(([, id]) => id ?? ''));
  const heads = new Set([...text.matchAll(/`([a-z_]+)\.(?:[a-z_]*)\$\{/g), ...text.matchAll(/wordOf\('([a-z_]+)'/g)].map(([, head]) => head ?? ''));
  const known = new Set(Object.keys(en));
  const groups = new Set([...known].map((id) => id.split('.')[0] ?? ''));
  const missing = [...named].filter((id) => groups.has(id.split('.')[0] ?? '') && !known.has(id) && !/\.(?:tsx?|json|js|css)$/.test(id));
  assert.deepEqual(missing, []);
  const left = [...known].filter((id) => !named.has(id) && !heads.has(id.split('.')[0] ?? ''));
  assert.deepEqual(left, []);
});

// The server's table of sentences: id and pattern, adjacent literals as one.
const sentences = [...readFileSync(path.resolve('../server/json/sentences.cpp'), 'utf8').replace(/"\s*\n\s*"/g, '').matchAll(/Row\{\s*"(\w+)",\s*"((?:[^"\\]|\\.)*)"/g)];

test('each language has every sentence that the server sends by its id, with its values', () => {
  assert.ok(sentences.length > 90, `${sentences.length} sentences`);
  const ids = new Set(sentences.map(([, id]) => `said.${id ?? ''}`));
  for (const [tag, words] of Object.entries(catalogues)) {
    for (const [, id, pattern] of sentences) {
      const inPattern = [...(pattern ?? '').matchAll(/\{(\w+)\}/g)].map(([, name]) => name ?? '').sort();
      assert.deepEqual(places(words[`said.${id ?? ''}`] ?? ''), inPattern, `${tag} ${id ?? ''}`);
      assert.ok((words[`said.${id ?? ''}`] ?? '').length > 5, `${tag} ${id ?? ''}`);
    }
    assert.deepEqual(Object.keys(words).filter((id) => id.startsWith('said.') && !ids.has(id)), [], 'none is left over');
  }
});

test('a sentence is shown by its id, with the sentences in its values, else as the server wrote it', () => {
  const why = { text: 'the disk is full (ledger)', said: { id: 'store_disk_full' as const, values: { detail: { text: 'ledger', said: null } } } };
  assert.equal(localText({ id: 'cannot_arm', values: { machine: { text: 'lathe', said: null }, why } }, 'x'), 'lathe cannot be armed: the disk is full (ledger)');
  assert.equal(localText(null, 'as it came'), 'as it came');
  assert.equal(localText({ id: 'of_a_later_version' as never, values: {} }, 'as it came'), 'as it came');
});

test('what nobody knows is shown as it came', () => {
  assert.equal(t('no.such_message'), 'no.such_message');
  assert.equal(wordOf('stall', 'brand_new'), 'brand new');
  assert.equal(wordOf('dialect', 'okuma', 'okuma'), 'okuma');
});
