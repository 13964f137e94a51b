// What follows from a toolpath's points.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { boundsOf, dataOf, feedRanges, rapidLengths, roundLength, stretchesOf, type PathData } from '../src/path/data';
import { pathOf, type Row } from './paths';
import { detailFor, detailsOf, kMovingLimits, movingDetail, MovingPace, segmentsWithin } from '../src/path/detail';
import { nearestSegment } from '../src/path/pick';


const kSquare = pathOf([
  [0, 0, 5, 0, 4],
  [0, 0, 0, 2, 5, 100],
  [10, 0, 0, 2, 6, 200],
  [10, 10, 0, 2, 6, 200],
  [0, 0, 5, 1, 7],
  [50, 0, 5, 0, 9],
  [50, 0, 0, 2, 6, 150],
]);

test('columns come back as they were written', () => {
  const column = (numbers: ArrayBufferView) => Buffer.from(numbers.buffer, numbers.byteOffset, numbers.byteLength).toString('base64');
  const { points, kinds, lines, feeds, count } = kSquare;
  const times = new Float32Array([0, 1, NaN, 3, 4, 5, 6]);
  const columns = { points_mm: column(points), kinds: column(kinds), lines: column(lines), feeds: column(feeds), times_s: column(times), speeds: '', buffer: '', deviations_mm: '' };
  const back = dataOf({ points: count, columns, kind_names: ['begin', 'rapid', 'cut_per_min', 'cut_per_rev', 'cut_inverse_time', 'thread'] });
  assert.deepEqual([...back.points], [...points]);
  assert.deepEqual([...back.lines], [...lines]);
  assert.deepEqual([...back.feeds], [...feeds]);
  assert.deepEqual([...back.kinds], [...kinds]);
  assert.deepEqual([...back.times], [...times]);
  assert.equal(back.speeds.length, 0);
});

test('a line has its stretches, each visit one', () => {
  assert.deepEqual(stretchesOf(kSquare, 6), [
    { first: 2, last: 3 },
    { first: 6, last: 6 },
  ]);
  assert.deepEqual(stretchesOf(kSquare, 4), [], 'a place that nothing leads to is none');
  assert.deepEqual(stretchesOf(kSquare, 0), []);
});

test('figures of a path', () => {
  assert.deepEqual([...feedRanges(kSquare)], [[2, [100, 200]]]);
  const { low, high } = boundsOf(kSquare);
  assert.deepEqual([low, high], [[0, 0, 0], [50, 10, 5]]);
  assert.ok(boundsOf(pathOf([])).size > 0);
  const along = rapidLengths(kSquare);
  assert.equal(along[3], 0);
  assert.ok(Math.abs((along[4] ?? 0) - 15) < 1e-6);
  assert.deepEqual([0.3, 1, 4.9, 50, 999].map(roundLength), [0.2, 1, 2, 50, 500]);
});

// Circles of chords, on and on; step in radians.
function circles(points: number, step = 0.02): PathData {
  const rows: Row[] = [[100, 0, 0, 0, 1]];
  for (let i = 1; i < points; i += 1) rows.push([100 * Math.cos(i * step), 100 * Math.sin(i * step), -i / 1e4, 2, i, 100]);
  return pathOf(rows);
}

test('every segment once, and none across a gap', () => {
  assert.deepEqual([...(segmentsWithin(kSquare, 0) ?? [])], [0, 1, 1, 2, 2, 3, 3, 4, 5, 6]);
});

test('what is left out lies nearer than the tolerance, and ends stay', () => {
  const path = circles(1000);
  const pairs = segmentsWithin(path, 10);
  assert.ok(pairs && pairs.length / 2 < 250 && pairs.length / 2 > 100);
  assert.equal(pairs[0], 0);
  assert.equal(pairs.at(-1), 999);
  for (let i = 2; i < pairs.length; i += 2) assert.equal(pairs[i], pairs[i - 1], 'it does not break');
  for (let i = 0; i < pairs.length; i += 2)
    for (let k = (pairs[i] ?? 0) + 1; k < (pairs[i + 1] ?? 0); k += 1) {
      const [x, y] = [0, 1].map((axis) => (path.points[3 * k + axis] ?? 0) - (path.points[3 * (pairs[i] ?? 0) + axis] ?? 0));
      assert.ok(Math.hypot(x ?? 0, y ?? 0) < 10);
    }
  const small = segmentsWithin(kSquare, 1000);
  assert.deepEqual([...(small ?? [])], [0, 3, 3, 4, 5, 6], 'where the kind changes, or the path breaks off, the point stays');
});

test('a long path is drawn coarser while it turns, and finer where one looks near', () => {
  const path = circles(400_000, 2e-4);
  const size = boundsOf(path).size;
  const details = detailsOf(path, size);
  assert.ok(details.length > 1);
  assert.equal(details[0]?.pairs.length, 2 * 399_999);
  assert.equal(detailFor(details, 1e-6), details[0]);
  assert.equal(detailFor(details, 1e6), details.at(-1));
  assert.ok(movingDetail(path, details, size).pairs.length / 2 <= 60_000);
  assert.equal(detailsOf(kSquare, 50).length, 1);
});

test('a view that turns is drawn as coarse as the computer needs', () => {
  const path = circles(400_000, 2e-4);
  const { size } = boundsOf(path);
  const details = detailsOf(path, size);
  for (const most of kMovingLimits) assert.ok(movingDetail(path, details, size, most).pairs.length / 2 <= most, `at most ${most}`);
  const pace = new MovingPace();
  for (let i = 0; i < 12; i += 1) pace.note(90);
  assert.ok(pace.level > 0, 'slow frames make it coarser');
  const coarse = pace.level;
  for (let i = 0; i < 200; i += 1) pace.note(30);
  assert.equal(pace.level, coarse, 'it stays where it is fast enough');
  for (let i = 0; i < 200; i += 1) pace.note(8);
  assert.equal(pace.level, 0, 'and gets finer where there is time');
  for (let i = 0; i < 500; i += 1) pace.note(5000);
  assert.equal(pace.level, kMovingLimits.length - 1, 'there is an end');
});

test('the segment under a point of the screen', () => {
  const seenFromAbove = [1, 0, 0, 0, 0, 1, 0, 0] as const;
  const pick = (x: number, y: number, last = 6) => nearestSegment(kSquare, seenFromAbove, x, y, 2, last);
  assert.equal(pick(5, 0.5), 2);
  assert.equal(pick(9.5, 8), 3);
  assert.equal(pick(30, 0), null, 'nothing leads across the gap');
  assert.equal(pick(9.5, 8, 2), null, 'what is not shown is not hit');
});
