// A family's drawing as a picture: dimensions side by side, none over another, and values by dragging.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pictureOf, textOf, type View } from '../src/rules/drawing';
import { isMadeOn, wantedBy } from '../src/rules/part_values';
import { placeOf, rangeOf, typedAt } from '../src/rules/sliding';

const dimension = (parameter: string, from: [number, number], to: [number, number], kind: 'length' | 'diameter' | 'radius' | 'angle' = 'length'): View['dimensions'][number] => ({
  parameter,
  kind,
  value: '10 mm',
  from,
  to,
  at: kind === 'angle' ? [0, 0] : null,
});

const view = (dimensions: View['dimensions'], axes = 'xy'): View => ({
  axes,
  lines: [{ of: 'stock', points: [[0, 0], [100, 0], [100, 50], [0, 50], [0, 0]] }],
  circles: [],
  dimensions,
});

test('lengths stand outside of the part, the shorter one nearer', () => {
  const { dimensions, height } = pictureOf(view([dimension('whole', [0, 0], [100, 0]), dimension('half', [0, 0], [50, 0]), dimension('rest', [50, 0], [100, 0])]), 600);
  const y = (name: string) => dimensions.find(({ parameter }) => parameter === name)?.at[1] ?? 0;
  assert.ok(y('half') < y('whole'), 'the longer one is farther out');
  assert.equal(y('half'), y('rest'), 'two that follow each other share a line');
  assert.ok(y('whole') < height, 'all of it is in the picture');
});

test('a text is never outside of the picture, however narrow it is', () => {
  for (const width of [280, 340, 600]) {
    const all = [dimension('a_rather_long_name', [100, 0], [100, 50]), dimension('radius_of_it', [90, 40], [95, 45], 'radius'), dimension('turned_by', [50, 0], [0, 50], 'angle')];
    for (const { at, text, turned } of pictureOf(view(all), width).dimensions)
      assert.ok(at[0] - (turned ? 8 : text.length * 3.5) >= -1 && at[0] + (turned ? 8 : text.length * 3.5) <= width + 1, `${text} at ${at[0]} of ${width}`);
  }
});

test('a part of no size is drawn, too', () => {
  const { height } = pictureOf({ axes: 'zx', lines: [], circles: [], dimensions: [dimension('nothing', [0, 0], [0, 0])] }, 300);
  assert.ok(Number.isFinite(height));
});

test('a dimension has its sign', () => {
  assert.equal(textOf({ parameter: 'bore', kind: 'diameter', value: '8 mm' }), 'bore ⌀8 mm');
});

const length = { low: 10, high: 110, step: 0, unit: 'mm', default: '60 mm', choices: [], most: 0, kind: 'length' };

test('a slider goes over the range, from the default on', () => {
  assert.equal(placeOf(length, ''), 500);
  assert.equal(placeOf(length, '110'), 1000);
  assert.equal(placeOf(length, 'no number'), 500);
  assert.equal(typedAt(length, 0), '10 mm');
  assert.equal(typedAt(length, 1000), '110 mm');
  assert.equal(typedAt(length, 250), '35 mm');
});

test('whole numbers and steps are kept, and a range over decades is divided by its logarithm', () => {
  assert.equal(typedAt({ ...length, low: 1, high: 8, unit: '', default: '2', kind: 'count' }, 500), '5');
  assert.equal(typedAt({ ...length, low: 1, high: 10, step: 0.5 }, 500), '5.5 mm');
  const wide = { ...length, low: 0.01, high: 100, default: '1 mm' };
  assert.equal(placeOf(wide, ''), 500);
  assert.equal(typedAt(wide, 500), '1 mm');
  for (const place of [0, 1, 333, 750, 1000]) assert.ok(Math.abs(placeOf(wide, typedAt(wide, place)) - place) <= 2, `place ${place}`);
});

test('what has no range has no slider', () => {
  assert.equal(rangeOf({ ...length, choices: ['a', 'b'] }), null);
  assert.equal(rangeOf({ ...length, most: 5 }), null);
  assert.equal(rangeOf({ ...length, kind: 'tool' }), null);
  assert.equal(rangeOf({ ...length, low: 5, high: 5 }), null);
});

test('a family is made on the machines that the server takes it for', () => {
  const roll = wantedBy('# machine mill\nfamily roll "Roll"\nmachine lathe, x is diameter\n');
  assert.deepEqual(roll, { kind: 'lathe', dialect: null });
  assert.ok(isMadeOn(roll, { kind: 'lathe', dialect: 'mazak' }) && isMadeOn(roll, { kind: 'mill-turn', dialect: 'mazak' }));
  assert.ok(!isMadeOn(roll, { kind: 'mill', dialect: 'mazak' }));
  const kept = wantedBy('family slot\nmachine mill\nnative fanuc\n%\n');
  assert.ok(isMadeOn(kept, { kind: 'mill', dialect: 'fanuc' }) && !isMadeOn(kept, { kind: 'mill', dialect: 'haas' }));
});
