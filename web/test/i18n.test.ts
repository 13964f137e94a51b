// The catalogues: every id that the page uses is there, in each language, with the same places for values.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { IntlMessageFormat } from 'intl-messageformat';
import de from '../src/i18n/de.json';
import en from '../src/i18n/en.json';
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

test('what nobody knows is shown as it came', () => {
  assert.equal(t('no.such_message'), 'no.such_message');
  assert.equal(wordOf('stall', 'brand_new'), 'brand new');
  assert.equal(wordOf('dialect', 'okuma', 'okuma'), 'okuma');
});
