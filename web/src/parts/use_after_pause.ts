// What was typed, once no key came for so long.
import { useEffect, useState } from 'preact/hooks';

export function useAfterPause<Value>(value: Value, pause_ms: number): Value {
  const [taken, setTaken] = useState(value);
  useEffect(() => {
    if (value === taken) return;
    const timer = setTimeout(() => setTaken(value), pause_ms);
    return () => clearTimeout(timer);
  }, [value, taken]);
  return taken;
}
