// Which part of each parameter's range passes, as positions on a line, and where a typed value stands on it.
import type { SweepFigures } from '../api/types';

export type Swept = SweepFigures['parameters'][number];

export interface RegionRow {
  name: string;
  unit: string;
  passes: { from: number; to: number } | null; // shares of the range, 0 to 1; null: the standard fails
  standard: number; // share
  now: number | null; // share of the value that is typed; null: it has none, or not in this unit
  isOutside: boolean; // the typed value is not among those that pass
}

const shareOf = ({ low, high }: Swept, value: number): number => (high > low ? Math.min(Math.max((value - low) / (high - low), 0), 1) : 0);

// "120 mm" or a plain number, in the parameter's unit; null where it is another one or an expression.
export function numberIn(unit: string, typed: string): number | null {
  const [, number = '', given = ''] = /^\s*([-+]?[\d.,]+)\s*(\S*)\s*$/.exec(typed) ?? [];
  const value = Number(number.replace(',', '.'));
  return number !== '' && Number.isFinite(value) && (given === '' || given === unit) ? value : null;
}

export function rowOf(swept: Swept, typed: string): RegionRow {
  const [from, to] = swept.passes ?? [];
  const now = numberIn(swept.unit, typed);
  const isKnown = from !== undefined && to !== undefined;
  return {
    name: swept.name,
    unit: swept.unit,
    passes: isKnown ? { from: shareOf(swept, from), to: shareOf(swept, to) } : null,
    standard: shareOf(swept, swept.standard),
    now: now === null ? null : shareOf(swept, now),
    isOutside: now !== null && isKnown && (now < from || now > to),
  };
}
