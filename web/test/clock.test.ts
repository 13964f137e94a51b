// Time along a path, and by what it is coloured.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { clockOf, spotOf, type Clock } from '../src/path/clock';
import { coloringsOf, rangesOf, valuesOf } from '../src/path/color';
import { holderSideOf, insertSides, noseCenter, sideOf, type ToolShape } from '../src/path/tool_shape';
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
  const mill: ToolShape = { diameter_mm: 10, corner_radius_mm: 2, nose_radius_mm: 0, tip: 0, length_mm: 80, insert: null, holder: [], isLathe: false };
  const side = sideOf(mill);
  assert.deepEqual(side[0], [0, 0]);
  assert.deepEqual(side.at(-2), [5, 80]);
  assert.ok(side.some(([radius, height]) => near(radius, 5) && near(height, 2)), 'its corner is round');
  assert.deepEqual(sideOf({ ...mill, corner_radius_mm: 0 })[1], [5, 0], 'or flat');
  const held: ToolShape = { ...mill, holder: [{ from_mm: 30, diameter_mm: 12 }, { from_mm: 50, diameter_mm: 40 }] };
  assert.deepEqual(sideOf(held).at(-2), [5, 30], 'below the holder');
  assert.deepEqual(holderSideOf(mill), []);
  assert.deepEqual(holderSideOf(held), [[0, 30], [6, 30], [6, 50], [20, 50], [20, 80], [0, 80]]);
  assert.deepEqual(holderSideOf({ ...held, length_mm: null }).at(-1), [0, 70], 'drawn as high as it is wide there');
  // Tip 3 looks towards the axis and the chuck: the nose lies beyond it on both axes.
  assert.deepEqual(noseCenter({ nose_radius_mm: 0.8, tip: 3 }), [0.8, 0.8]);
});

test('an insert stands as its tip and its entering angle have it', () => {
  const insert = { angle_deg: 80, entering_angle_deg: 95, edge_mm: 12 };
  const tool: ToolShape = { diameter_mm: null, corner_radius_mm: 0, nose_radius_mm: 0.8, tip: 3, length_mm: null, insert, holder: [], isLathe: true };
  const sides = insertSides(tool);
  // The feed goes to -z: the leading edge leans 5 degrees back from it, the other one rises 5 degrees from what is turned.
  const five = (5 * Math.PI) / 180;
  const [x = 0, z = 0] = sides[0] ?? [];
  assert.ok(near(x, 0.8 + 0.8 * Math.sin(five) + 12 * Math.cos(five)) && near(z, 0.8 - 0.8 * Math.cos(five) + 12 * Math.sin(five)), `${x} ${z}`);
  assert.ok(sides.every(([across, along]) => across > -1e-9 && along > -1e-9), 'nothing of it lies below the tip or ahead of it');
  for (const [tip, signX, signZ] of [[1, -1, -1], [2, -1, 1], [4, 1, -1]] as const)
    for (const [index, [across, along]] of insertSides({ ...tool, tip }).entries())
      assert.ok(near(across, signX * (sides[index]?.[0] ?? 0)) && near(along, signZ * (sides[index]?.[1] ?? 0)), `tip ${tip}`);
  const even = insertSides({ ...tool, tip: 8, insert: { angle_deg: 35, entering_angle_deg: 0, edge_mm: 10 } });
  for (const [across, along] of even) assert.ok(even.some(([otherX, otherZ]) => near(across, otherX) && near(along, 0 - otherZ)), 'even to both sides');
  assert.ok(even.every(([across]) => across > -1e-9));
  assert.deepEqual(insertSides({ ...tool, tip: 0 }), []);
  assert.equal(insertSides({ ...tool, insert: { ...insert, angle_deg: 60 } }).length, sides.length - 1, 'a triangle');
});

test('a pace that shows all of it soon', () => {
  assert.deepEqual([5, 90, 1500, 90_000].map(paceFor), [1, 10, 100, 1000]);
});
