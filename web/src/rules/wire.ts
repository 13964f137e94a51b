// What a wire terminal shows: rows of what passed on a line, bounded, the newest last. A run that goes on in the next
// report goes on in its row.
import type { WireReport, WireRun } from '../api/types';

export interface WireRow extends Omit<WireRun, 'kind'> {
  kind: WireRun['kind'] | 'gap'; // gap: `wrong` characters passed that were not shown
  id: number;
}

export const kMostRows = 300;
const kLongest = 200;
const kPauseMs = 100;
const kLineFeed = '\u240A';

export function addReport(rows: readonly WireRow[], report: WireReport): WireRow[] {
  const next = [...rows];
  let id = (rows.at(-1)?.id ?? 0) + 1;
  if (report.lost > 0) {
    const at_ms = report.runs[0]?.at_ms ?? 0;
    next.push({ id: id++, kind: 'gap', at_ms, to_ms: at_ms, text: '', hex: '', wrong: report.lost });
  }
  for (const run of report.runs) {
    const last = next.at(-1);
    if (last && goesOn(last, run))
      next[next.length - 1] = { ...last, to_ms: run.to_ms, text: last.text + run.text, hex: last.hex + run.hex, wrong: last.wrong + run.wrong };
    else next.push({ id: id++, ...run });
  }
  return next.slice(-kMostRows);
}

const goesOn = (row: WireRow, run: WireRun): boolean =>
  (run.kind === 'in' || run.kind === 'out') &&
  row.kind === run.kind &&
  !row.text.endsWith(kLineFeed) &&
  row.text.length + run.text.length <= kLongest &&
  run.at_ms - row.to_ms < kPauseMs;

// The names of the control characters, by code; 127 is DEL.
const kNames = [
  'NUL', 'SOH', 'STX', 'ETX', 'EOT', 'ENQ', 'ACK', 'BEL', 'BS', 'HT', 'LF', 'VT', 'FF', 'CR', 'SO', 'SI',
  'DLE', 'DC1', 'DC2', 'DC3', 'DC4', 'NAK', 'SYN', 'ETB', 'CAN', 'EM', 'SUB', 'ESC', 'FS', 'GS', 'RS', 'US',
]; // prettier-ignore

// The name of a picture of a control character; null for what is no picture.
export function controlName(picture: string): string | null {
  const code = picture.charCodeAt(0) - 0x2400;
  return code === 0x21 ? 'DEL' : (kNames[code] ?? null);
}

export interface Piece {
  text: string;
  control: string | null; // its name
}

// Text and control characters in turn.
export function pieces(text: string): Piece[] {
  const found: Piece[] = [];
  for (const character of text) {
    const control = controlName(character);
    const last = found.at(-1);
    if (control === null && last && last.control === null) last.text += character;
    else found.push({ text: character, control });
  }
  return found;
}
