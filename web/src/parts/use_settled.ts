// What was typed, once it rests.
import { useEffect, useState } from 'preact/hooks';

export function useSettled<Value>(value: Value, pause_ms: number): Value {
  const [settled, setSettled] = useState(value);
  useEffect(() => {
    if (value === settled) return;
    const timer = setTimeout(() => setSettled(value), pause_ms);
    return () => clearTimeout(timer);
  }, [value, settled]);
  return settled;
}
