// What a translation is for, and which of its lines belong to which of the text's.
import type { Converted, ConvertOrder } from '../api/types';

// "mazak": a dialect; "machine:mill-2": a machine's control; null: nothing is chosen.
export function sideOf(to: string): Pick<ConvertOrder, 'to' | 'to_machine'> | null {
  if (to.startsWith('machine:')) return { to_machine: to.slice('machine:'.length) };
  return /^[a-z]/.test(to) ? { to } : null;
}

// The line of the text that a line of the translation comes from. Without a table the lines are the same ones.
export function originOf(origins: readonly number[], line: number): number | null {
  if (origins.length === 0) return line;
  return origins[line - 1] || null;
}

// The first line of the translation that a line of the text became; of one that became none, the next one's.
export function lineFrom(origins: readonly number[], line: number): number | null {
  if (origins.length === 0) return line;
  let best = 0;
  for (let at = 0; at < origins.length; ++at) {
    const origin = origins[at] ?? 0;
    if (origin === line) return at + 1;
    if (origin > line && (best === 0 || origin < (origins[best - 1] ?? 0))) best = at + 1;
  }
  return best || null;
}

type Standing = { state: 'verified' | 'not_verified' | 'refused'; tone: 'good' | 'waiting' | 'bad' };

export function standingOf(converted: Converted): Standing {
  if (converted.text === null) return { state: 'refused', tone: 'bad' };
  return converted.verified ? { state: 'verified', tone: 'good' } : { state: 'not_verified', tone: 'waiting' };
}
