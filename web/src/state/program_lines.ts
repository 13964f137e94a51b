// How many lines a program's text has, asked for once a text, when something shows it.
import { signal } from '@preact/signals';
import { calls } from '../api/calls';

const counts = signal<ReadonlyMap<string, number>>(new Map());
const asked = new Set<string>();

// Null while it is not known.
export function linesOf(program: number, revision: number): number | null {
  const key = `${program}.${revision}`;
  const known = counts.value.get(key);
  if (known !== undefined) return known;
  if (!asked.has(key)) {
    asked.add(key);
    void calls.programLines(program, revision, 1, 1).then(
      ({ count_all }) => {
        counts.value = new Map(counts.peek()).set(key, count_all);
      },
      () => undefined, // then the line stands alone
    );
  }
  return null;
}
