// Paths for the tests: a row a point.
import type { PathData } from '../src/path/data';

export type Row = [x: number, y: number, z: number, kind: number, line: number, feed?: number];

export const pathOf = (rows: Row[]): PathData => ({
  count: rows.length,
  points: new Float32Array(rows.flatMap(([x, y, z]) => [x, y, z])),
  kinds: new Uint8Array(rows.map((row) => row[3])),
  lines: new Uint32Array(rows.map((row) => row[4])),
  feeds: new Float32Array(rows.map((row) => row[5] ?? 0)),
  kindNames: ['begin', 'rapid', 'cut_per_min', 'cut_per_rev', 'cut_inverse_time', 'thread'],
  times: new Float32Array(),
  speeds: new Float32Array(),
  buffer: new Uint32Array(),
  deviations: new Float32Array(),
});

// 10 mm along x in 1 s, a dwell of 2 s, 10 mm along y in 0.5 s, a rapid back up of 5 mm in 0.1 s.
export const kTimed: PathData = {
  ...pathOf([
    [0, 0, 0, 0, 1],
    [10, 0, 0, 2, 2, 600],
    [10, 10, 0, 2, 4, 1200],
    [10, 10, 5, 1, 5],
  ]),
  times: new Float32Array([0.5, 1.5, 4, 4.1]),
  speeds: new Float32Array([NaN, 600, 1200, 3000]),
  buffer: new Uint32Array([80, 80, 60, 20]),
  deviations: new Float32Array([NaN, 0.002, -0.004, NaN]),
};
