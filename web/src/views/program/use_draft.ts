// The text that is being written: it begins from a revision, is kept in this browser while it differs, and is never
// dropped but by its person or by a save.
import { useEffect, useRef, useState } from 'preact/hooks';
import { draftOf, dropDraft, keepDraft, type Draft } from '../../state/drafts';

const kKeepMs = 400;

export interface Drafting {
  ready: boolean; // it is known whether there is a kept text
  found: Draft | null; // as it was kept when the program was opened
  keep: (base: number, text: string) => void; // soon
  drop: (base: number) => Promise<void>;
  move: (from: number, to: number, text: string) => Promise<void>; // it goes on from another revision
}

export function useDraft(person: string, program: number): Drafting {
  const [state, setState] = useState<{ ready: boolean; found: Draft | null }>({ ready: false, found: null });
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const due = useRef<Draft | null>(null);
  const flush = () => {
    clearTimeout(timer.current);
    if (due.current) void keepDraft(due.current).catch(() => undefined);
    due.current = null;
  };
  useEffect(() => {
    let over = false;
    // Without a store for it the text is only in the page.
    void draftOf(person, program)
      .catch(() => null)
      .then((found) => over || setState({ ready: true, found }));
    addEventListener('pagehide', flush);
    return () => {
      over = true;
      removeEventListener('pagehide', flush);
      flush();
    };
  }, [person, program]);
  return {
    ...state,
    keep: (base, text) => {
      due.current = { person, program, base, text, atMs: Date.now() };
      clearTimeout(timer.current);
      timer.current = setTimeout(flush, kKeepMs);
    },
    drop: async (base) => {
      clearTimeout(timer.current);
      due.current = null;
      setState({ ready: true, found: null });
      await dropDraft({ person, program, base }).catch(() => undefined);
    },
    move: async (from, to, text) => {
      clearTimeout(timer.current);
      due.current = null;
      const found = { person, program, base: to, text, atMs: Date.now() };
      await keepDraft(found).catch(() => undefined);
      await dropDraft({ person, program, base: from }).catch(() => undefined);
      setState({ ready: true, found });
    },
  };
}
