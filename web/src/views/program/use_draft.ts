// The text that is being written: it begins from a revision, is kept in this browser while it differs, and is never
// dropped but by its person or by a save.
import { useEffect, useRef, useState } from 'preact/hooks';
import { draftOf, dropDraft, keepDraft, type Draft } from '../../state/drafts';

const kKeepMs = 400;

export interface Drafting {
  ready: boolean; // it is known whether there is a kept text
  found: Draft | null; // the text that is kept
  keep: (base: number, text: string) => void; // soon
  drop: (base: number) => Promise<void>;
  move: (from: number, to: number, text: string) => Promise<void>; // it goes on from another revision
}

export function useDraft(person: string, program: number): Drafting {
  const [ready, setReady] = useState(false);
  const found = useRef<Draft | null>(null);
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const due = useRef<Draft | null>(null); // is to be kept
  const flush = () => {
    clearTimeout(timer.current);
    if (due.current) void keepDraft(due.current).catch(() => undefined);
    due.current = null;
  };
  const forget = (base: number): Promise<unknown> => dropDraft({ person, program, base }).catch(() => undefined);
  useEffect(() => {
    let over = false;
    // Without a store for it the text is only in the page.
    void draftOf(person, program)
      .catch(() => null)
      .then((kept) => {
        if (over) return;
        found.current = kept;
        setReady(true);
      });
    addEventListener('pagehide', flush);
    return () => {
      over = true;
      removeEventListener('pagehide', flush);
      flush();
    };
  }, [person, program]);
  const take = (draft: Draft | null) => {
    clearTimeout(timer.current);
    due.current = draft;
    found.current = draft;
  };
  return {
    ready,
    found: found.current,
    keep: (base, text) => {
      take({ person, program, base, text, atMs: Date.now() });
      timer.current = setTimeout(flush, kKeepMs);
    },
    drop: async (base) => {
      take(null);
      await forget(base);
    },
    move: async (from, to, text) => {
      take({ person, program, base: to, text, atMs: Date.now() });
      flush();
      await forget(from);
    },
  };
}
