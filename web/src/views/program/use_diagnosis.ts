// What the server finds in the text as it is typed: asked after a pause, one question at a time, and an answer only
// counts for the text that it was asked about.
import { useEffect, useRef, useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import { ApiError } from '../../api/client';
import type { Diagnosed } from '../../api/types';
import { loader } from '../../state/loader';

// A pause in typing: short, so that a fault is marked soon; of a long text as long as its last answer took.
const kPauseMs = 120;
const kLongestPauseMs = 1500;
const kBusyMs = 2000;
const kLongest_chars = 2_000_000; // a longer one is checked, not read while it is typed

export type DiagnosisPhase = 'off' | 'waiting' | 'known' | 'too_long' | 'failed';

export interface Diagnosis {
  phase: DiagnosisPhase;
  found: Diagnosed | null;
  of: string; // the text that was read
  error: unknown;
}

const kNone: Diagnosis = { phase: 'off', found: null, of: '', error: null };

export function useDiagnosis(text: string | null, dialect: string, machine: string): Diagnosis {
  const [state, setState] = useState<Diagnosis>(kNone);
  const wanted = useRef<{ text: string; dialect: string; machine: string } | null>(null);
  const asking = useRef(false);
  const took = useRef(0); // ms, of the last answer
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);

  const ask = async () => {
    const order = wanted.current;
    if (!order || asking.current) return;
    asking.current = true;
    const began = performance.now();
    try {
      const found = await loader.order(deskCalls.diagnose({ text: order.text, dialect: order.dialect, ...(order.machine ? { machine: order.machine } : {}) }));
      took.current = performance.now() - began;
      if (wanted.current) setState({ phase: wanted.current === order ? 'known' : 'waiting', found, of: order.text, error: null });
    } catch (error) {
      const isBusy = error instanceof ApiError && (error.status === 503 || error.status === 429);
      if (isBusy) timer.current = setTimeout(() => void ask(), kBusyMs);
      else if (wanted.current === order) setState((before) => ({ ...before, phase: 'failed', error }));
    }
    asking.current = false;
    if (wanted.current && wanted.current !== order) void ask();
  };

  useEffect(() => {
    clearTimeout(timer.current);
    if (text === null || text.length > kLongest_chars) {
      wanted.current = null;
      setState({ ...kNone, phase: text === null ? 'off' : 'too_long' });
      return;
    }
    wanted.current = { text, dialect, machine };
    setState((before) => ({ ...before, phase: 'waiting' }));
    timer.current = setTimeout(() => void ask(), Math.min(Math.max(took.current, kPauseMs), kLongestPauseMs));
  }, [text, dialect, machine]);
  useEffect(
    () => () => {
      clearTimeout(timer.current);
      wanted.current = null;
    },
    [],
  );
  return state;
}
