// What a view asks the server for by itself. An answer to an older question is dropped.
import { useEffect, useRef, useState } from 'preact/hooks';
import { loader } from '../state/loader';

export interface Loaded<Value> {
  value: Value | null;
  error: unknown;
  loading: boolean;
  again: () => void;
  set: (value: Value) => void; // what an order answered
}

// Asks whenever `key` is another one; null: there is nothing to ask.
export function useLoaded<Value>(key: string | null, ask: () => Promise<Value>): Loaded<Value> {
  const [state, setState] = useState<{ key: string | null; value: Value | null; error: unknown; loading: boolean }>({
    key: null,
    value: null,
    error: null,
    loading: key !== null,
  });
  const [round, setRound] = useState(0);
  const latest = useRef(0);
  useEffect(() => {
    const mine = ++latest.current;
    if (key === null) {
      setState({ key, value: null, error: null, loading: false });
      return;
    }
    setState((before) => ({ ...before, value: before.key === key ? before.value : null, key, error: null, loading: true }));
    loader.order(ask()).then(
      (value) => mine === latest.current && setState({ key, value, error: null, loading: false }),
      (error: unknown) => mine === latest.current && setState((before) => ({ ...before, error, loading: false })),
    );
  }, [key, round]);
  useEffect(() => () => void ++latest.current, []);
  return {
    value: state.key === key ? state.value : null,
    error: state.error,
    loading: state.loading,
    again: () => setRound((before) => before + 1),
    set: (value) => setState((before) => ({ ...before, value })),
  };
}
