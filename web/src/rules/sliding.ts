// A parameter's value by dragging: places 0 to 1000 of a slider over its range. A range over decades is divided evenly by
// its logarithm, so that small values can be chosen as finely as large ones.
import type { Parameter } from '../api/types';
import { numberIn } from './region';

export const kPlaces = 1000;
const kDecades = 30; // high by low from which it goes by the logarithm

type Ranged = Pick<Parameter, 'low' | 'high' | 'step' | 'unit' | 'default' | 'choices' | 'most' | 'kind'>;

interface Range {
  low: number;
  high: number;
}

// Null: it has no range that could be dragged over.
export function rangeOf({ low, high, choices, most, kind }: Ranged): Range | null {
  if (low === null || high === null || low >= high || choices.length > 0 || most > 0 || kind === 'tool') return null;
  return { low, high };
}

const isWide = ({ low, high }: Range): boolean => low > 0 && high / low >= kDecades;

const shareOf = (range: Range, value: number): number =>
  isWide(range) ? Math.log(value / range.low) / Math.log(range.high / range.low) : (value - range.low) / (range.high - range.low);

const valueAt = (range: Range, share: number): number =>
  isWide(range) ? range.low * (range.high / range.low) ** share : range.low + share * (range.high - range.low);

export function placeOf(parameter: Ranged, typed: string): number {
  const range = rangeOf(parameter);
  const value = numberIn(parameter.unit, typed.trim() === '' ? parameter.default : typed) ?? numberIn(parameter.unit, parameter.default);
  if (!range || value === null) return 0;
  return Math.round(kPlaces * Math.min(Math.max(shareOf(range, Math.min(Math.max(value, range.low), range.high)), 0), 1));
}

// What one would write there: as many digits as two neighbouring places need, or whole steps.
export function typedAt(parameter: Ranged, place: number): string {
  const range = rangeOf(parameter);
  if (!range) return '';
  const share = place / kPlaces;
  const value = valueAt(range, share);
  const beside = valueAt(range, share < 0.5 ? share + 2 / kPlaces : share - 2 / kPlaces);
  const isWhole = parameter.kind === 'count';
  const step = parameter.step > 0 ? parameter.step : isWhole ? 1 : 10 ** Math.floor(Math.log10(Math.abs(value - beside)));
  const base = parameter.step > 0 ? range.low : 0;
  const stepped = base + Math.round((value - base) / step) * step;
  const within = Math.min(Math.max(Number(stepped.toPrecision(10)), range.low), range.high);
  return parameter.unit === '' ? `${within}` : `${within} ${parameter.unit}`;
}
