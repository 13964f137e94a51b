// The parts of a view as a person has arranged them: nothing is lost, whatever a browser kept.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { arranged, moved, toggled, type PartOfView } from '../src/rules/arrangement';

const parts: PartOfView[] = [
  { id: 'line', column: 0, isFixed: true },
  { id: 'queue', column: 0 },
  { id: 'alarms', column: 1, isFixed: true },
  { id: 'use', column: 1 },
];
const own = arranged(parts, null);

test('without a wish the parts stand where the page has them', () => {
  assert.deepEqual(own, { columns: [['line', 'queue'], ['alarms', 'use']], hidden: [] });
  for (const wish of [undefined, 7, 'x', {}, { columns: 3, hidden: {} }, { columns: [7, { 0: 'line' }] }, []]) assert.deepEqual(arranged(parts, wish), own);
});

test('a wish of another version keeps what is known, and loses no part', () => {
  const wish = { columns: [['use', 'gone', 'use', 4], ['line']], hidden: ['queue', 'alarms', 'gone'] };
  assert.deepEqual(arranged(parts, wish), { columns: [['use', 'queue'], ['line', 'alarms']], hidden: ['queue'] });
});

test('a part moves within its column and across, and never out of the view', () => {
  assert.deepEqual(moved(own, 'queue', 'up').columns, [['queue', 'line'], ['alarms', 'use']]);
  assert.deepEqual(moved(own, 'queue', 'down').columns, own.columns);
  assert.deepEqual(moved(own, 'line', 'up').columns, own.columns);
  assert.deepEqual(moved(own, 'line', 'across').columns, [['queue'], ['line', 'alarms', 'use']]);
  assert.deepEqual(moved(own, 'use', 'across').columns, [['line', 'use', 'queue'], ['alarms']]);
  assert.deepEqual(moved(own, 'nothing', 'across').columns, own.columns);
});

test('hiding and showing is its own inverse', () => {
  assert.deepEqual(toggled(own, 'use').hidden, ['use']);
  assert.deepEqual(toggled(toggled(own, 'use'), 'use'), own);
});
