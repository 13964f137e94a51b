// How a person has arranged the parts of a view: in two columns, some of them hidden. What a browser kept may be of another
// version of the page, so it is read as a wish: unknown parts are dropped, new ones stand where the page has them.
export interface PartOfView {
  id: string;
  column: 0 | 1; // where it stands without a person's wish
  isFixed?: boolean; // it cannot be hidden
}

export interface Arrangement {
  columns: [string[], string[]];
  hidden: string[];
}

export type Move = 'up' | 'down' | 'across';

const texts = (value: unknown): string[] => (Array.isArray(value) ? value.filter((one): one is string => typeof one === 'string') : []);

export function arranged(parts: readonly PartOfView[], wish: unknown): Arrangement {
  const wished = (wish ?? {}) as Partial<Record<'columns' | 'hidden', unknown>>;
  const given = Array.isArray(wished.columns) ? wished.columns : [];
  const ids = new Set(parts.map(({ id }) => id));
  const seen = new Set<string>();
  const known = (column: unknown): string[] => texts(column).filter((id) => ids.has(id) && !seen.has(id) && seen.add(id));
  const columns: [string[], string[]] = [known(given[0]), known(given[1])];
  for (const { id, column } of parts) if (!seen.has(id)) columns[column].push(id);
  const fixed = new Set(parts.filter(({ isFixed }) => isFixed).map(({ id }) => id));
  return { columns, hidden: texts(wished.hidden).filter((id) => ids.has(id) && !fixed.has(id)) };
}

// The same where there is no place to move to.
export function moved({ columns, hidden }: Arrangement, id: string, move: Move): Arrangement {
  const at = columns[0].includes(id) ? 0 : 1;
  const here = [...columns[at]];
  const place = here.indexOf(id);
  const to = move === 'across' ? place : place + (move === 'up' ? -1 : 1);
  if (place < 0 || to < 0 || (move !== 'across' && to >= here.length)) return { columns, hidden };
  here.splice(place, 1);
  const other = [...columns[1 - at]!];
  (move === 'across' ? other : here).splice(to, 0, id);
  return { columns: at === 0 ? [here, other] : [other, here], hidden };
}

export const toggled = ({ columns, hidden }: Arrangement, id: string): Arrangement => ({
  columns,
  hidden: hidden.includes(id) ? hidden.filter((one) => one !== id) : [...hidden, id],
});
