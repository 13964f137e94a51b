// Which segment lies under a point of the screen.
import { at, kBegin, type PathData } from './data';

// The first two rows of a matrix that leads points to pixels, row by row.
export type ToPixels = readonly [number, number, number, number, number, number, number, number];

// The point that the nearest segment leads to; null: none is as near as `within_px`. Up to `last` only.
export function nearestSegment(data: PathData, toPixels: ToPixels, x_px: number, y_px: number, within_px: number, last: number): number | null {
  const { points, kinds } = data;
  const [a, b, c, d, e, f, g, h] = toPixels;
  let best = within_px * within_px;
  let found: number | null = null;
  let x0 = 0;
  let y0 = 0;
  for (let i = 0; i <= last && i < data.count; i += 1) {
    const x = at(points, 3 * i);
    const y = at(points, 3 * i + 1);
    const z = at(points, 3 * i + 2);
    const x1 = a * x + b * y + c * z + d;
    const y1 = e * x + f * y + g * z + h;
    if (kinds[i] !== kBegin && i > 0) {
      const distance = squareToSegment(x_px, y_px, x0, y0, x1, y1);
      if (distance < best) {
        best = distance;
        found = i;
      }
    }
    x0 = x1;
    y0 = y1;
  }
  return found;
}

function squareToSegment(x: number, y: number, x0: number, y0: number, x1: number, y1: number): number {
  const dx = x1 - x0;
  const dy = y1 - y0;
  const length = dx * dx + dy * dy;
  const t = length > 0 ? Math.min(Math.max(((x - x0) * dx + (y - y0) * dy) / length, 0), 1) : 0;
  return (x - x0 - t * dx) ** 2 + (y - y0 - t * dy) ** 2;
}
