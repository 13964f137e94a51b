// Time along a path, and by what it is coloured.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { clockOf, spotOf, type Clock } from '../src/path/clock';
import { coloringsOf, rangesOf, valuesOf } from '../src/path/color';
import { noseCenter, sideOf, type ToolShape } from '../src/path/tool_shape';
import { paceFor } from '../src/views/path/time_bar';
import { kTimed, pathOf } from './paths';

const clock = clockOf(kTimed) as Clock;
const near = (a: number, b: number): boolean => Math.abs(a - b) < 1e-3;

test('the tool is where it is at a time', () => {
  const at = (time_s: number) => spotOf(kTimed, clock.placeAt(time_s));
  assert.ok(near(clock.end_s, 4.1));
  assert.ok(at(1).every((value, axis) => near(value, [5, 0, 0][axis] ?? 0)), 'half of the first cut');
  assert.ok(at(2.5).every((value, axis) => near(value, [10, 0, 0][axis] ?? 0)), 'it stands still while it dwells');
  assert.ok(at(3.75).every((value, axis) => near(value, [10, 5, 0][axis] ?? 0)), 'half of the second cut');
  assert.ok(at(99).every((value, axis) => near(value, [10, 10, 5][axis] ?? 0)), 'the end stays');
  assert.ok(at(0).every((value) => value === 0), 'before the first point it stands there');
});

test('and the other direction', () => {
  for (const time_s of [0.7, 1.2, 3.6, 4.05]) assert.ok(near(clock.timeAt(clock.placeAt(time_s)), time_s), `${time_s} s`);
});

test('without times there is no clock, and an unknown time goes back never', () => {
  assert.equal(clockOf(pathOf([[0, 0, 0, 0, 1]])), null);
  assert.equal(clockOf({ ...kTimed, times: new Float32Array([NaN, NaN, NaN, NaN]) }), null);
  const gap = clockOf({ ...kTimed, times: new Float32Array([0.5, 1.5, NaN, 4.1]) }) as Clock;
  assert.equal(gap.timeAt({ point: 2, share: 1 }), 1.5);
  assert.ok(gap.placeAt(1.6).point === 3);
});

test('it is coloured by what is known', () => {
  assert.deepEqual(coloringsOf(kTimed), ['kind', 'feed', 'speed', 'deviation', 'time']);
  assert.deepEqual(coloringsOf(pathOf([[0, 0, 0, 0, 1]])), ['kind', 'feed']);
  assert.deepEqual(rangesOf(kTimed, 'speed').get(2), [600, 1200], 'of cuts');
  assert.equal(rangesOf(kTimed, 'speed').get(1), undefined, 'a rapid keeps its colour');
  assert.ok(near(rangesOf(kTimed, 'time').get(1)?.[1] ?? 0, 4.1), 'but not where time is shown');
  const [low = 0, high = 0] = rangesOf(kTimed, 'deviation').get(2) ?? [];
  assert.ok(near(low, -0.004) && near(high, 0.004), 'the same to both sides, so that none is in the middle');
  assert.ok((valuesOf(kTimed, 'deviation')[0] ?? 0) < -1e29, 'what is not known has no value');
});

test('a tool as its profile has it', () => {
  const mill: ToolShape = { diameter_mm: 10, corner_radius_mm: 2, nose_radius_mm: 0, tip: 0, length_mm: 80, isLathe: false };
  const side = sideOf(mill);
  assert.deepEqual(side[0], [0, 0]);
  assert.deepEqual(side.at(-2), [5, 80]);
  assert.ok(side.some(([radius, height]) => near(radius, 5) && near(height, 2)), 'its corner is round');
  assert.deepEqual(sideOf({ ...mill, corner_radius_mm: 0 })[1], [5, 0], 'or flat');
  // Tip 3 looks towards the axis and the chuck: the nose lies beyond it on both axes.
  assert.deepEqual(noseCenter({ ...mill, nose_radius_mm: 0.8, tip: 3, isLathe: true }), [0.8, 0.8]);
});

test('a pace that shows all of it soon', () => {
  assert.deepEqual([5, 90, 1500, 90_000].map(paceFor), [1, 10, 100, 1000]);
});
