// The text that the server is asked about, while another one may be written: it follows after a pause of the keys. A long one
// follows only when a person asks for it.
import { useEffect, useState } from 'preact/hooks';
import { useAfterPause } from './use_after_pause';

const kLongest_chars = 400_000;

export interface Asked<Text> {
  text: Text;
  isOlder: boolean; // another one is written by now
  askNow: (() => void) | null; // null: it follows by itself
}

export function useAsked<Text extends string | null>(written: Text, pause_ms: number): Asked<Text> {
  const [asked, setAsked] = useState(written);
  const paused = useAfterPause(written, pause_ms);
  const isLong = (paused?.length ?? 0) > kLongest_chars;
  useEffect(() => {
    if (!isLong) setAsked(paused);
  }, [paused, isLong]);
  const isOlder = written !== asked;
  return { text: asked, isOlder, askNow: isLong && isOlder ? () => setAsked(written) : null };
}
