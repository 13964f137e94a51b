// Time along a path: where the tool is at a time, and when it is at a point.
import { at, kBegin, type PathData } from './data';

// A place of the path: `share` of the segment that leads to the point is passed. 1: it is there.
export interface PathPlace {
  point: number;
  share: number;
}

export interface Clock {
  end_s: number;
  timeAt: (place: PathPlace) => number;
  placeAt: (time_s: number) => PathPlace;
}

// null: no time is known of any point.
export function clockOf(data: PathData): Clock | null {
  const { times, count } = data;
  if (times.length < count || count === 0) return null;
  // Where a time is not known the one before holds, so that it never goes back.
  const reached = new Float64Array(count);
  let last = 0;
  let known = 0;
  for (let i = 0; i < count; i += 1) {
    const time = times[i] ?? NaN;
    if (!Number.isNaN(time)) {
      known += 1;
      last = Math.max(last, time);
    }
    reached[i] = last;
  }
  if (known === 0) return null;
  // A segment begins as long before its end as its length takes at its speed: a dwell lies before that.
  const lasts = (point: number): number => {
    const before = reached[point - 1] ?? 0;
    const gap = (reached[point] ?? 0) - before;
    const speed = data.speeds[point] ?? NaN;
    if (point === 0 || data.kinds[point] === kBegin) return 0;
    return speed > 0 ? Math.min((lengthTo(data, point) / speed) * 60, gap) : gap;
  };
  return {
    end_s: last,
    timeAt: ({ point, share }) => (reached[point] ?? 0) - (1 - share) * lasts(point),
    placeAt: (time_s) => {
      const point = firstNotBefore(reached, time_s);
      const duration = lasts(point);
      const left = (reached[point] ?? 0) - time_s;
      return { point, share: duration > 0 ? Math.min(Math.max(1 - left / duration, 0), 1) : left > 0 ? 0 : 1 };
    },
  };
}

function lengthTo({ points }: PathData, point: number): number {
  const p = 3 * point;
  return Math.hypot(at(points, p) - at(points, p - 3), at(points, p + 1) - at(points, p - 2), at(points, p + 2) - at(points, p - 1));
}

// The first point that is reached at the time or later; the last one where none is.
function firstNotBefore(reached: Float64Array, time_s: number): number {
  let low = 0;
  let high = reached.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((reached[middle] ?? 0) < time_s) low = middle + 1;
    else high = middle;
  }
  return low;
}

// x y z of a place.
export function spotOf({ points, kinds }: PathData, { point, share }: PathPlace): [number, number, number] {
  const from = kinds[point] === kBegin || point === 0 ? point : point - 1;
  const between = (axis: number): number => at(points, 3 * from + axis) + share * (at(points, 3 * point + axis) - at(points, 3 * from + axis));
  return [between(0), between(1), between(2)];
}
