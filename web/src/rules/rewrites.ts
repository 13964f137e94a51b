// What a person may have done to a text, and how the server is asked for it.
import type { Rewriting } from '../api/types';

interface Row {
  id: string;
  how: Rewriting['how'];
  numbering?: 'numbered' | 'all'; // blocks get numbers: from which on, and in which steps
}

export const kRewrites = [
  { id: 'renumber', how: 'renumber', numbering: 'numbered' },
  { id: 'number_all', how: 'renumber', numbering: 'all' },
  { id: 'remove_numbers', how: 'renumber' },
  { id: 'add_blanks', how: 'add_blanks' },
  { id: 'remove_blanks', how: 'remove_blanks' },
  { id: 'upper_case', how: 'upper_case' },
  { id: 'lower_case', how: 'lower_case' },
] as const satisfies readonly Row[];

export type RewriteChoice = (typeof kRewrites)[number]['id'];

export const takesNumbers = (choice: RewriteChoice): boolean => (kRewrites as readonly Row[]).some(({ id, numbering }) => id === choice && numbering !== undefined);

export const kMostStep = 10_000;

export function orderOf(choice: RewriteChoice, first: number, step: number): Omit<Rewriting, 'text'> {
  const row: Row | undefined = kRewrites.find(({ id }) => id === choice);
  if (row?.numbering) return { how: row.how, numbering: row.numbering, first, step };
  return choice === 'remove_numbers' ? { how: 'renumber', numbering: 'none' } : { how: row?.how ?? 'renumber' };
}
