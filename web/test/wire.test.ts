// The rows of a wire terminal: runs that go on, gaps, a bound, and the names of control characters.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { WireReport, WireRun } from '../src/api/types';
import { addReport, controlName, kMostRows, pieces } from '../src/rules/wire';

const run = (change: Partial<WireRun> = {}): WireRun => ({ kind: 'out', at_ms: 1000, to_ms: 1010, text: 'G1', hex: '4731', wrong: 0, ...change });
const report = (runs: WireRun[], lost = 0): WireReport => ({ from: 0, lost, runs });

test('a run goes on in its row until a block ends, it pauses, or the direction changes', () => {
  let rows = addReport([], report([run()]));
  rows = addReport(rows, report([run({ at_ms: 1050, to_ms: 1060, text: 'X2\u240a', hex: '58320A', wrong: 1 })]));
  assert.deepEqual(rows.map((row) => [row.text, row.hex, row.to_ms, row.wrong]), [['G1X2\u240a', '473158320A', 1060, 1]]);
  rows = addReport(rows, report([run({ at_ms: 1061, to_ms: 1062 }), run({ at_ms: 1300, to_ms: 1301 }), run({ kind: 'in', at_ms: 1302, to_ms: 1302 })]));
  assert.deepEqual(rows.map((row) => row.kind), ['out', 'out', 'out', 'in']);
  assert.equal(new Set(rows.map((row) => row.id)).size, 4);
});

test('what a watcher was too slow for is stated', () => {
  const [gap, next] = addReport([], report([run()], 17));
  assert.deepEqual([gap?.kind, gap?.wrong, next?.kind], ['gap', 17, 'out']);
});

test('no more rows are kept than are shown', () => {
  const rows = addReport([], report(Array.from({ length: 1000 }, (_, i) => run({ at_ms: i * 1000, to_ms: i * 1000 }))));
  assert.equal(rows.length, kMostRows);
  assert.equal(rows.at(-1)?.at_ms, 999_000);
});

test('control characters have their names', () => {
  assert.deepEqual(['\u2400', '\u2411', '\u2413', '\u240d', '\u2421', 'A', '\u2422'].map(controlName), ['NUL', 'DC1', 'DC3', 'CR', 'DEL', null, null]);
  assert.deepEqual(pieces('%\u240d\u240aG0'), [
    { text: '%', control: null },
    { text: '\u240d', control: 'CR' },
    { text: '\u240a', control: 'LF' },
    { text: 'G0', control: null },
  ]);
});
