// Values along time, thinned out to what a plot can show. No browser and no words here, so that plain tests run it.
import { kBegin, kRapid, type PathData } from '../path/data';

// Steps: a value holds from the time before up to its own; null: not known there.
export interface Steps {
  times: number[];
  values: (number | null)[];
  top: number; // the highest value of a cut
}

export type SeriesName = 'speed' | 'buffer' | 'deviation';

// Those that the path has values for, in this order.
export function seriesNamesOf(data: PathData): SeriesName[] {
  if (data.times.length === 0) return [];
  const names: SeriesName[] = ['speed'];
  if (data.buffer.length > 0) names.push('buffer');
  if (data.deviations.some((one) => !Number.isNaN(one))) names.push('deviation');
  return names;
}

const kMicrometres = 1000;
const kValues: Record<SeriesName, (data: PathData, point: number) => number> = {
  speed: ({ speeds }, point) => speeds[point] ?? NaN,
  buffer: ({ buffer }, point) => buffer[point] ?? NaN,
  deviation: ({ deviations }, point) => kMicrometres * (deviations[point] ?? NaN),
};

// Between two times. Of many points in one of `buckets` equal spans the lowest and the highest stay.
export function stepsOf(data: PathData, name: SeriesName, from_s: number, to_s: number, buckets: number): Steps {
  const all = pointsIn(data, from_s, to_s);
  const valueAt = (point: number): number => (data.kinds[point] === kBegin ? NaN : kValues[name](data, point));
  const steps: Steps = { times: [], values: [], top: 0 };
  const add = (point: number) => {
    const value = valueAt(point);
    steps.times.push(data.times[point] ?? 0);
    steps.values.push(Number.isNaN(value) ? null : value);
    if ((data.kinds[point] ?? kBegin) > kRapid && value > steps.top) steps.top = value;
  };
  if (all.length <= 2 * buckets) {
    all.forEach(add);
    return steps;
  }
  const span = (to_s - from_s) / buckets;
  let low = -1;
  let high = -1;
  let bucket = -1;
  const flush = () => {
    if (low < 0) return;
    [...new Set([Math.min(low, high), Math.max(low, high)])].forEach(add);
    low = -1;
    high = -1;
  };
  for (const point of all) {
    const here = Math.floor(((data.times[point] ?? 0) - from_s) / span);
    if (here !== bucket) flush();
    bucket = here;
    const value = valueAt(point);
    if (low < 0 || value < valueAt(low) || Number.isNaN(valueAt(low))) low = point;
    if (high < 0 || value > valueAt(high) || Number.isNaN(valueAt(high))) high = point;
  }
  flush();
  return steps;
}

// Points whose time lies there, and one more on either side; times never go back.
function pointsIn({ times, count }: PathData, from_s: number, to_s: number): number[] {
  const points: number[] = [];
  let before = -1;
  let last = -Infinity;
  for (let point = 0; point < count; point += 1) {
    const time = times[point] ?? NaN;
    if (Number.isNaN(time) || time < last) continue;
    last = time;
    if (time < from_s) {
      before = point;
      continue;
    }
    if (points.length === 0 && before >= 0) points.push(before);
    points.push(point);
    if (time > to_s) break;
  }
  return points;
}

// A span of time within the whole, zoomed around a place or moved; never shorter than a thousandth of a second.
export interface Span {
  from_s: number;
  to_s: number;
}
const kShortest_s = 1e-3;

export function zoomed({ from_s, to_s }: Span, factor: number, around_s: number, end_s: number): Span {
  const length = Math.min(Math.max((to_s - from_s) / factor, Math.min(kShortest_s, end_s)), end_s);
  const share = to_s > from_s ? Math.min(Math.max((around_s - from_s) / (to_s - from_s), 0), 1) : 0.5;
  return within({ from_s: around_s - share * length, to_s: around_s + (1 - share) * length }, end_s);
}

export function moved({ from_s, to_s }: Span, share: number, end_s: number): Span {
  const by = share * (to_s - from_s);
  return within({ from_s: from_s + by, to_s: to_s + by }, end_s);
}

function within({ from_s, to_s }: Span, end_s: number): Span {
  const length = Math.min(to_s - from_s, end_s);
  const from = Math.min(Math.max(from_s, 0), end_s - length);
  return { from_s: from, to_s: from + length };
}
