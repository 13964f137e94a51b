// A number that is another one for each text: a key for questions about texts that are too long for one.
import { useRef } from 'preact/hooks';

export function useNumberOf(text: string | null): number {
  const known = useRef({ text, number: 0 });
  if (known.current.text !== text) known.current = { text, number: known.current.number + 1 };
  return known.current.number;
}
