// The feasible region as shares of each range.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { numberIn, rowOf, type Swept } from '../src/rules/region';

const kSwept: Swept = { name: 'depth', unit: 'mm', low: 10, high: 110, standard: 60, passes: [35, 85], low_bound: null, high_bound: null };

test('a typed value counts in the unit of its parameter alone', () => {
  assert.equal(numberIn('mm', '12,5 mm'), 12.5);
  assert.equal(numberIn('mm', '12.5'), 12.5);
  assert.equal(numberIn('mm', '1 in'), null);
  assert.equal(numberIn('', 'a + 1'), null);
  assert.equal(numberIn('mm', ''), null);
});

test('ranges are shares of the whole, and a value outside is marked', () => {
  assert.deepEqual(rowOf(kSwept, '90 mm'), { name: 'depth', unit: 'mm', passes: { from: 0.25, to: 0.75 }, standard: 0.5, now: 0.8, isOutside: true });
  assert.equal(rowOf(kSwept, '85').isOutside, false);
  assert.equal(rowOf(kSwept, '').now, null);
  const failed: Swept = { name: 'depth', unit: 'mm', low: 10, high: 110, standard: 60, low_bound: null, high_bound: null };
  assert.equal(rowOf(failed, '90').passes, null);
  assert.equal(rowOf({ ...kSwept, low: 5, high: 5, standard: 5, passes: [5, 5] }, '5').now, 0);
});
