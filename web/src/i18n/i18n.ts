// The words of the page: one catalogue a language, by message id, in ICU message format. A language is one file beside
// this one and one row in kLanguages. An id that a language lacks is shown in English, and one that no language has is
// shown as it came: nothing that the server says is ever hidden. The English texts that the page does not show at once
// come with the first view that is loaded on demand (see words.mjs).
import { signal } from '@preact/signals';
import { IntlMessageFormat } from 'intl-messageformat';
import en from 'words:first';

export type Values = Record<string, string | number>;
type Catalogue = Record<string, string>;

interface Language {
  tag: string;
  name: string; // in itself
  load: () => Promise<Catalogue>;
}

export const kLanguages: Language[] = [
  { tag: 'en', name: 'English', load: () => Promise.resolve(en) },
  { tag: 'de', name: 'Deutsch', load: () => import('./de.json').then((file) => file.default) },
];

const kStored = 'dripfeed.language';

interface Spoken {
  tag: string;
  words: Catalogue;
}
export const spoken = signal<Spoken>({ tag: 'en', words: en });

let formats = new Map<string, IntlMessageFormat>();

let whole: Promise<void> | null = null;
export function loadAllWords(): Promise<void> {
  whole ??= import('words:rest').then(
    (rest) => void Object.assign(en, rest.default),
    (error: unknown) => {
      whole = null;
      throw error;
    },
  );
  return whole;
}

// The text of a message in the language that is spoken.
export function t(id: string, values?: Values): string {
  const { tag, words } = spoken.value;
  const text = words[id] ?? en[id];
  if (text === undefined) return id;
  if (!text.includes('{')) return text;
  let format = formats.get(id);
  if (!format) {
    format = new IntlMessageFormat(text, words[id] === undefined ? 'en' : tag, undefined, { ignoreTag: true });
    formats.set(id, format);
  }
  return String(format.format(values));
}

export const hasWord = (id: string): boolean => (spoken.value.words[id] ?? en[id]) !== undefined;

// The text of an id that the server gave; `otherwise` where no catalogue has it.
export function wordOf(prefix: string, name: string, otherwise = name.replace(/_/g, ' ')): string {
  const id = `${prefix}.${name}`;
  const known = spoken.value.words[id] ?? en[id];
  return known === undefined ? otherwise : t(id);
}

// The language that was chosen here before, or the first of the browser's that there is.
export function preferredLanguage(): string {
  const known = (tag: string) => kLanguages.some((language) => language.tag === tag);
  const stored = localStorage.getItem(kStored);
  if (stored && known(stored)) return stored;
  return navigator.languages.map((tag) => tag.slice(0, 2)).find(known) ?? 'en';
}

export async function speak(tag: string): Promise<void> {
  const language = kLanguages.find((one) => one.tag === tag) ?? kLanguages[0];
  if (!language) return;
  const words = await language.load();
  formats = new Map();
  document.documentElement.lang = language.tag;
  spoken.value = { tag: language.tag, words };
}

export async function chooseLanguage(tag: string): Promise<void> {
  localStorage.setItem(kStored, tag);
  await speak(tag);
}
