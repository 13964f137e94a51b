// The programs that are shown: those of a filter, or those that a search found. A page more is asked for at its cursor.
import { useEffect, useRef, useState } from 'preact/hooks';
import { deskCalls, type LibraryFilter } from '../../api/desk_calls';
import type { Program, SearchHit } from '../../api/types';
import { loader } from '../../state/loader';

export interface Found {
  program: Program;
  snippet: SearchHit['snippet'];
  isSimilar: boolean;
}

export interface Sought {
  words: string; // '' : by the filter
  filter: LibraryFilter;
}

interface Shown {
  of: string; // which question it answers
  items: Found[];
  next: string | null;
  waiting: number; // changes that a search does not know yet
}

const plain = (program: Program): Found => ({ program, snippet: [], isSimilar: false });

async function pageOf({ words, filter }: Sought, after: string | null): Promise<Omit<Shown, 'of'>> {
  if (words === '') {
    const { items, next } = await deskCalls.programs(filter, after);
    return { items: items.map(plain), next, waiting: 0 };
  }
  const found = await deskCalls.search(words, filter.shelf === 'all', after);
  const items = found.items.map(({ program, snippet, is_similar }) => ({ program, snippet, isSimilar: is_similar }));
  return { items, next: found.next, waiting: found.waiting };
}

export function useFound(sought: Sought) {
  const [shown, setShown] = useState<Shown | null>(null);
  const [error, setError] = useState<unknown>(null);
  const latest = useRef(0);
  const of = JSON.stringify(sought);
  const load = async (after: string | null) => {
    const mine = ++latest.current;
    setError(null);
    try {
      const page = await loader.order(pageOf(sought, after));
      if (mine !== latest.current) return;
      setShown((before) => ({ of, ...page, items: after !== null && before?.of === of ? [...before.items, ...page.items] : page.items }));
    } catch (failure) {
      if (mine === latest.current) setError(failure);
    }
  };
  useEffect(() => void load(null), [of]);
  // One that was there is changed in its place; a new one comes first.
  const take = (program: Program) =>
    setShown((before) => {
      if (!before) return before;
      const isThere = before.items.some((one) => one.program.id === program.id);
      const items = isThere
        ? before.items.map((one) => (one.program.id === program.id ? { ...one, program } : one))
        : [plain(program), ...before.items];
      return { ...before, items };
    });
  const more = shown !== null && shown.next !== null ? () => void load(shown.next) : null;
  return { shown, isOld: shown !== null && shown.of !== of, error, more, take, again: () => void load(null) };
}
