// By what a path is coloured: for each point a value, and for each kind of segment the range that the colours span.
import { feedRanges, kBegin, kRapid, type PathData } from './data';

export const kColorings = ['kind', 'feed', 'speed', 'deviation', 'time'] as const;
export type ColorBy = (typeof kColorings)[number];
export type Range = readonly [low: number, high: number];

// In place of NaN, which a graphics card need not know.
const kNotKnown = -1e30;

// Those that the path has values for.
export function coloringsOf(data: PathData): ColorBy[] {
  const hasValues: Record<ColorBy, boolean> = {
    kind: true,
    feed: true,
    speed: data.times.length > 0,
    deviation: data.deviations.some((one) => !Number.isNaN(one)),
    time: data.times.length > 0,
  };
  return kColorings.filter((one) => hasValues[one]);
}

const columnOf = (data: PathData, by: ColorBy): Float32Array =>
  ({ kind: data.feeds, feed: data.feeds, speed: data.speeds, deviation: data.deviations, time: data.times })[by];

export function valuesOf(data: PathData, by: ColorBy): Float32Array {
  const column = columnOf(data, by);
  if (by === 'kind' || by === 'feed') return column;
  return column.map((one) => (Number.isNaN(one) ? kNotKnown : one));
}

// Of all points that `isMeant` names.
export function rangeOf(data: PathData, column: Float32Array, isMeant: (kind: number) => boolean): Range | null {
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i < data.count; i += 1) {
    const value = column[i] ?? NaN;
    if (!isMeant(data.kinds[i] ?? kBegin) || Number.isNaN(value)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? [low, high] : null;
}

const isCut = (kind: number): boolean => kind > kRapid;
const isSegment = (kind: number): boolean => kind !== kBegin;

// By the number of the kind; a kind without one keeps its own colour. Feeds have their unit by their kind, all else has one.
export function rangesOf(data: PathData, by: ColorBy): Map<number, Range> {
  if (by === 'kind') return new Map();
  if (by === 'feed') return feedRanges(data);
  const range = rangeOf(data, columnOf(data, by), by === 'time' ? isSegment : isCut);
  if (!range) return new Map();
  const most = Math.max(Math.abs(range[0]), Math.abs(range[1]));
  const spanned: Range = by === 'deviation' ? [-most, most] : range;
  const kinds = data.kindNames.map((_, kind) => kind);
  return new Map(kinds.filter(by === 'time' ? isSegment : isCut).map((kind) => [kind, spanned]));
}
