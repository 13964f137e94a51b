// A sentence of the server in the language of the page, by its id and values. One that no catalogue has is shown as the
// server wrote it.
import type { Said } from '../api/types';
import { hasWord, t, wordOf, type Values } from '../i18n/i18n';

export function localText(sentence: Said | null | undefined, otherwise: string): string {
  if (!sentence || !hasWord(`said.${sentence.id}`)) return otherwise;
  const values: Values = {};
  for (const [name, value] of Object.entries(sentence.values)) values[name] = name === 'cause' ? wordOf('cause', value.text, value.text) : localText(value.said, value.text);
  const text = t(`said.${sentence.id}`, values);
  return values.detail === undefined ? text : `${text} (${values.detail})`;
}
