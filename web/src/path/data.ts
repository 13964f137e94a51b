// A toolpath as typed arrays, and what follows from them. No browser and no words here, so that plain tests run it.
import type { ToolPath } from '../api/types';

export const kBegin = 0; // nothing leads to the point
export const kRapid = 1;

export interface PathData {
  count: number; // points
  points: Float32Array; // x y z of each, x as radius
  kinds: Uint8Array;
  lines: Uint32Array; // 0: in a called program
  feeds: Float32Array;
  kindNames: readonly string[];
  // Of a machine, a row a point; empty: of none. NaN: not known.
  times: Float32Array; // when the point is reached, s
  speeds: Float32Array; // mean on the segment to the point, mm/min
  buffer: Uint32Array; // bytes in the control
  deviations: Float32Array; // of what the block cuts, mm; positive: material is left
}

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i += 1) bytes[i] = text.charCodeAt(i);
  return bytes;
}

export function dataOf({ points, columns, kind_names }: Pick<ToolPath, 'points' | 'columns' | 'kind_names'>): PathData {
  return {
    count: points,
    points: new Float32Array(bytesOf(columns.points_mm).buffer),
    kinds: bytesOf(columns.kinds),
    lines: new Uint32Array(bytesOf(columns.lines).buffer),
    feeds: new Float32Array(bytesOf(columns.feeds).buffer),
    kindNames: kind_names,
    times: new Float32Array(bytesOf(columns.times_s).buffer),
    speeds: new Float32Array(bytesOf(columns.speeds).buffer),
    buffer: new Uint32Array(bytesOf(columns.buffer).buffer),
    deviations: new Float32Array(bytesOf(columns.deviations_mm).buffer),
  };
}

// Points from `first` to `last` to which segments of one line lead, one after the other.
export interface Stretch {
  first: number;
  last: number;
}

const leadsTo = ({ kinds }: PathData, point: number): boolean => kinds[point] !== kBegin;

export function stretchesOf(data: PathData, line: number, most = 1000): Stretch[] {
  const found: Stretch[] = [];
  if (line <= 0) return found;
  for (let i = 0; i < data.count && found.length < most; i += 1) {
    if (data.lines[i] !== line || !leadsTo(data, i)) continue;
    const first = i;
    while (i + 1 < data.count && data.lines[i + 1] === line && leadsTo(data, i + 1)) i += 1;
    found.push({ first, last: i });
  }
  return found;
}

// The range of programmed feeds of each kind of cut that the path has, by the kind's number.
export function feedRanges(data: PathData): Map<number, [low: number, high: number]> {
  const ranges = new Map<number, [number, number]>();
  for (let i = 0; i < data.count; i += 1) {
    const kind = data.kinds[i] ?? kBegin;
    const feed = data.feeds[i] ?? 0;
    if (kind <= kRapid || !(feed > 0)) continue;
    const range = ranges.get(kind);
    if (!range) ranges.set(kind, [feed, feed]);
    else if (feed < range[0]) range[0] = feed;
    else if (feed > range[1]) range[1] = feed;
  }
  return ranges;
}

// Length of rapids up to each point, by which they are dashed.
export function rapidLengths({ count, points, kinds }: PathData): Float32Array {
  const along = new Float32Array(count);
  for (let i = 1; i < count; i += 1) {
    const p = 3 * i;
    const length = kinds[i] === kRapid ? Math.hypot(at(points, p) - at(points, p - 3), at(points, p + 1) - at(points, p - 2), at(points, p + 2) - at(points, p - 1)) : 0;
    along[i] = (along[i - 1] ?? 0) + length;
  }
  return along;
}

export interface Bounds {
  low: [number, number, number];
  high: [number, number, number];
  size: number; // of the diagonal, at least a hair
}

export function boundsOf({ count, points }: PathData): Bounds {
  const low: Bounds['low'] = [Infinity, Infinity, Infinity];
  const high: Bounds['high'] = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < 3 * count; i += 1) {
    const axis = i % 3;
    const value = at(points, i);
    if (value < (low[axis] ?? 0)) low[axis] = value;
    if (value > (high[axis] ?? 0)) high[axis] = value;
  }
  if (count === 0) return { low: [0, 0, 0], high: [0, 0, 0], size: 1 };
  return { low, high, size: Math.max(Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]), 1e-3) };
}

export function unionOf(one: Omit<Bounds, 'size'>, other: Omit<Bounds, 'size'>): Bounds {
  const by = (pick: (...values: number[]) => number, side: 'low' | 'high') => one[side].map((value, axis) => pick(value, other[side][axis] ?? value)) as Bounds['low'];
  const low = by(Math.min, 'low');
  const high = by(Math.max, 'high');
  return { low, high, size: Math.max(Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]), 1e-3) };
}

export const at = (points: Float32Array, index: number): number => points[index] ?? 0;

// 1, 2 or 5 times a power of ten, at most `most`.
export function roundLength(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most));
  for (const step of [5, 2]) if (step * power <= most) return step * power;
  return power;
}
