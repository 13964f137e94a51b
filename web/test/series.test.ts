// Values along time, as plots show them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { moved, seriesNamesOf, stepsOf, zoomed } from '../src/plots/series';
import { kTimed, pathOf, type Row } from './paths';

test('series that there are', () => {
  assert.deepEqual(seriesNamesOf(kTimed), ['speed', 'buffer', 'deviation']);
  assert.deepEqual(seriesNamesOf({ ...kTimed, buffer: new Uint32Array(), deviations: new Float32Array([NaN]) }), ['speed']);
  assert.deepEqual(seriesNamesOf(pathOf([[0, 0, 0, 0, 1]])), []);
});

test('few points are all there, and what is not known is not drawn', () => {
  const { times, values, top } = stepsOf(kTimed, 'speed', 0, 5, 100);
  assert.equal(top, 1200, 'the fastest cut, not the rapid');
  assert.deepEqual(times.map((one) => Number(one.toFixed(3))), [0.5, 1.5, 4, 4.1]);
  assert.deepEqual(values, [null, 600, 1200, 3000]);
  assert.deepEqual(stepsOf(kTimed, 'deviation', 0, 5, 100).values.map((one) => one && Number(one.toFixed(3))), [null, 2, -4, null], 'in micrometres');
});

test('of many points the lowest and the highest of each span stay', () => {
  const rows: Row[] = Array.from({ length: 10_000 }, (_, i) => [i, 0, 0, i === 0 ? 0 : 2, i + 1, 100]);
  const speeds = new Float32Array(10_000).fill(500);
  speeds[5000] = 5;
  speeds[7777] = 9000;
  const path = { ...pathOf(rows), times: new Float32Array(rows.map((_, i) => i / 100)), speeds };
  const { times, values } = stepsOf(path, 'speed', 0, 100, 200);
  assert.ok(times.length <= 402 && times.length > 200, `${times.length} of 10000`);
  assert.ok(values.includes(5) && values.includes(9000), 'no peak is lost');
  assert.ok(times.every((time, i) => i === 0 || time >= (times[i - 1] ?? 0)), 'in the order of time');
  const near = stepsOf(path, 'speed', 77.7, 77.8, 200);
  assert.equal(near.values.filter((one) => one === 9000).length, 1);
  assert.ok(near.times.length < 20, 'a short span has its points and one on either side');
});

test('zoom and move stay within the whole', () => {
  assert.deepEqual(zoomed({ from_s: 0, to_s: 100 }, 2, 50, 100), { from_s: 25, to_s: 75 });
  assert.deepEqual(zoomed({ from_s: 25, to_s: 75 }, 0.1, 50, 100), { from_s: 0, to_s: 100 });
  assert.deepEqual(zoomed({ from_s: 0, to_s: 100 }, 4, 0, 100), { from_s: 0, to_s: 25 });
  assert.deepEqual(moved({ from_s: 0, to_s: 20 }, -0.5, 100), { from_s: 0, to_s: 20 });
  assert.deepEqual(moved({ from_s: 70, to_s: 90 }, 1, 100), { from_s: 80, to_s: 100 });
});
