// What every view may ask for: the state, whoever keeps it, and the rights of the person.
import { createContext } from 'preact';
import { useContext, useEffect, useState } from 'preact/hooks';
import type { Session } from '../api/types';
import type { State } from '../state/state';
import type { Sync } from '../state/sync';

export interface Desk {
  state: State;
  sync: Sync;
  session: Session;
}

export const DeskContext = createContext<Desk | null>(null);

export function useDesk(): Desk {
  const desk = useContext(DeskContext);
  if (!desk) throw new Error('a view outside the signed-in page');
  return desk;
}

// The present time, again after each period.
export function useNow(everyMs: number): number {
  const [now, setNow] = useState(Date.now());
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now()), everyMs);
    return () => clearInterval(timer);
  }, [everyMs]);
  return now;
}
