// What was typed, as fast as answers come: almost at once where none is waited for, otherwise when that one is there.
import { useEffect } from 'preact/hooks';

const kHair_ms = 30; // keys that come together are one

export function usePaced<Value>(value: Value, asked: Value, isWaiting: boolean, ask: (value: Value) => void): void {
  useEffect(() => {
    if (value === asked || isWaiting) return;
    const timer = setTimeout(() => ask(value), kHair_ms);
    return () => clearTimeout(timer);
  }, [value, asked, isWaiting]);
}
