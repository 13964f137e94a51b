// Which segments are drawn: pairs of points, over one buffer of points. A coarser choice leaves out points that lie
// nearer than a tolerance to the last one that is kept, so that what is left out is smaller than a dot of the screen.
import { at, kBegin, type PathData } from './data';

// Ends of segments in pairs; tolerance 0: every segment.
export function segmentsWithin(data: PathData, tolerance_mm: number, most = Infinity): Uint32Array<ArrayBuffer> | null {
  const { count, points, kinds } = data;
  const square = tolerance_mm * tolerance_mm;
  let pairs = new Uint32Array(Math.max(2 * Math.min(count, Number.isFinite(most) ? most : count), 2));
  let used = 0;
  let kept = 0; // the point that the next segment begins at
  for (let i = 1; i < count; i += 1) {
    if (kinds[i] === kBegin) {
      kept = i;
      continue;
    }
    // Where the kind changes, or the path breaks off, the point stays.
    const mustStay = i + 1 >= count || kinds[i + 1] !== kinds[i];
    if (!mustStay && tolerance_mm > 0) {
      const x = at(points, 3 * i) - at(points, 3 * kept);
      const y = at(points, 3 * i + 1) - at(points, 3 * kept + 1);
      const z = at(points, 3 * i + 2) - at(points, 3 * kept + 2);
      if (x * x + y * y + z * z < square) continue;
    }
    if (used / 2 >= most) return null;
    pairs[used] = kept;
    pairs[used + 1] = i;
    used += 2;
    kept = i;
  }
  pairs = pairs.subarray(0, used);
  return pairs;
}

export interface Detail {
  tolerance_mm: number;
  pairs: Uint32Array<ArrayBuffer>;
}

const kLevels = 3;
const kFewSegments = 60_000; // below that there is nothing to gain
// Segments while the view turns, at most: as many as the computer draws 30 times a second.
export const kMovingLimits = [60_000, 30_000, 15_000, 8_000, 4_000] as const;

// The finest first; each later one is coarser. The last one is for a view that turns.
export function detailsOf(data: PathData, size_mm: number): Detail[] {
  const all = segmentsWithin(data, 0) ?? new Uint32Array();
  const details: Detail[] = [{ tolerance_mm: 0, pairs: all }];
  if (all.length / 2 <= kFewSegments) return details;
  let before = all.length;
  for (let level = 0; level < kLevels; level += 1) {
    const tolerance_mm = (size_mm / 12_800) * 4 ** level;
    const pairs = segmentsWithin(data, tolerance_mm) ?? all;
    if (pairs.length > 0.7 * before) continue; // it would not be drawn noticeably sooner
    details.push({ tolerance_mm, pairs: pairs.slice() });
    before = pairs.length;
  }
  return details;
}

// For a view that turns: as coarse as needed to have few segments.
export function movingDetail(data: PathData, details: readonly Detail[], size_mm: number, most: number = kMovingLimits[0]): Detail {
  const coarsest = details.at(-1) ?? { tolerance_mm: 0, pairs: new Uint32Array() };
  if (coarsest.pairs.length / 2 <= most) return coarsest;
  for (let tolerance_mm = Math.max(coarsest.tolerance_mm, size_mm / 1600); tolerance_mm < size_mm; tolerance_mm *= 2) {
    const pairs = segmentsWithin(data, tolerance_mm, most);
    if (pairs) return { tolerance_mm, pairs: pairs.slice() };
  }
  return coarsest;
}

// Which of the limits holds, by the frames so far: a coarser one where they come too late, a finer one again where there
// is much time left. It waits after each change, as the first frames of a new one are late by themselves.
export class MovingPace {
  level = 0;
  private mean_ms = kWanted_ms;
  private frames = 0;

  // The time between two frames of a view that turns.
  note(gap_ms: number): void {
    this.frames += 1;
    if (this.frames <= kSettle) return;
    this.mean_ms += kWeight * (Math.min(gap_ms, kLongest_ms) - this.mean_ms);
    if (this.mean_ms > kWanted_ms * kTooLate && this.level + 1 < kMovingLimits.length) this.change(1);
    else if (this.mean_ms < kWanted_ms * kEarly && this.level > 0) this.change(-1);
  }

  // It rests: the gap to the next frame says nothing.
  rest(): void {
    this.frames = 0;
  }

  private change(by: number): void {
    this.level += by;
    this.frames = 0;
    this.mean_ms = kWanted_ms;
  }
}

const kWanted_ms = 1000 / 30;
const kTooLate = 1.15;
const kEarly = 0.55;
const kWeight = 0.25;
const kSettle = 2;
const kLongest_ms = 400;

// The coarsest one whose tolerance is less than `dot_mm` on the screen.
export function detailFor(details: readonly Detail[], dot_mm: number): Detail | undefined {
  let found = details[0];
  for (const one of details) if (one.tolerance_mm <= dot_mm) found = one;
  return found;
}
