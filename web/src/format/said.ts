// A sentence of the server in the language of the page, by its id and values. One that no catalogue has is shown as the
// server wrote it.
import type { Said } from '../api/types';
import { hasWord, t, wordOf, type Values } from '../i18n/i18n';

export function saidText(said: Said | null | undefined, otherwise: string): string {
  if (!said || !hasWord(`said.${said.id}`)) return otherwise;
  const values: Values = {};
  for (const [name, value] of Object.entries(said.values)) values[name] = name === 'cause' ? wordOf('cause', value.text, value.text) : saidText(value.said, value.text);
  const text = t(`said.${said.id}`, values);
  return values.detail === undefined ? text : `${text} (${values.detail})`;
}
