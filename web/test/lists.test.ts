// Lists: sorted, filtered, summed up, written for a spreadsheet.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Job, Order, Release, VerdictSummary } from '../src/api/types';
import { csvOf, isoTime } from '../src/rules/csv';
import { againstForecast, durationOf, rangeBegin, sumsOf } from '../src/rules/history';
import { byUrgency, filtered, fromLocalField, isLate, localField } from '../src/rules/orders';
import { fitting, hindranceOf, needsFourEyes, needsSignOff, openPoints, presentOf, stepsOf, verdictOf } from '../src/rules/releases';
import { sorted } from '../src/rules/sorting';
import { offsetName } from '../src/rules/work_offsets';

test('rows are sorted by numbers and by names with numbers, and what has no value comes last', () => {
  const rows = [{ name: 'O10' }, { name: null }, { name: 'O9' }];
  const names = (down: boolean) => sorted(rows, ({ name }) => name, down).map(({ name }) => name);
  assert.deepEqual(names(false), ['O9', 'O10', null]);
  assert.deepEqual(names(true), ['O10', 'O9', null]);
  assert.deepEqual(sorted([3, 1, 2], (one) => one, true), [3, 2, 1]);
});

test('a file for a spreadsheet', () => {
  const columns = [
    { head: 'name', of: (row: { name: string; count: number | null }) => row.name },
    { head: 'count', of: (row: { name: string; count: number | null }) => row.count },
  ];
  const rows = [
    { name: 'a "b", c', count: -1.5 },
    { name: '=SUM(A1)', count: null },
    { name: 'two\nlines', count: 0 },
  ];
  assert.equal(csvOf(columns, rows), '\uFEFFname,count\r\n"a ""b"", c",-1.5\r\n\'=SUM(A1),\r\n"two\nlines",0\r\n');
  assert.equal(isoTime(0), '1970-01-01T00:00:00Z');
  assert.equal(isoTime(null), null);
});

const order = (change: Partial<Order>): Order => ({ id: 1, number: 'A-1', operation: null, part: 'P-1', quantity: 10, open: 10, priority: 0, machine: null, due_at_ms: null, state: 'open', ...change }) as Order;

test('orders: the soonest first, late ones, filters, dates', () => {
  const all = [order({ id: 1 }), order({ id: 2, due_at_ms: 2000 }), order({ id: 3, due_at_ms: 1000, machine: 'mill' }), order({ id: 4, priority: 5, operation: 'OP20' })];
  assert.deepEqual([...all].sort(byUrgency).map(({ id }) => id), [3, 2, 4, 1]);
  assert.ok(isLate(order({ due_at_ms: 1000 }), 2000));
  assert.ok(!isLate(order({ due_at_ms: 1000, open: 0 }), 2000), 'all parts are made');
  assert.ok(!isLate(order({ due_at_ms: 1000, state: 'cancelled' }), 2000));
  const find = (change: Partial<Parameters<typeof filtered>[1]>) => filtered(all, { state: '', machine: '', words: '', ...change }).map(({ id }) => id);
  assert.deepEqual(find({ words: ' op2' }), [4]);
  assert.deepEqual(find({ machine: 'mill' }), [3]);
  assert.deepEqual(find({ state: 'held' }), []);
  const minute = 1_800_000_000_000 - (1_800_000_000_000 % 60_000);
  assert.equal(fromLocalField(localField(minute)), minute);
  assert.equal(fromLocalField(localField(null)), null);
});

const job = (change: Partial<Job>): Job => ({ state: 'done', bytes: 100, started_at_ms: 1000, ended_at_ms: 3500, ...change }) as Job;

test('sums count bytes of what is done, and the time of all that fed', () => {
  assert.equal(durationOf(job({})), 2.5);
  assert.equal(durationOf(job({ started_at_ms: null })), null);
  const sums = sumsOf([job({}), job({ state: 'failed' }), job({ state: 'cancelled', started_at_ms: null })]);
  assert.deepEqual(sums, { states: { done: 1, failed: 1, cancelled: 1, interrupted: 0 }, bytes: 100, seconds: 5 });
});

test('each point of a verdict is waived by itself, or all of them at once', () => {
  const of = (waivers: VerdictSummary['waivers']) => verdict({ verdict: 'warn', points: ['p', 'q'], waivers });
  const p = { ...waiver, point: 'p' };
  assert.deepEqual(openPoints(of([p]), kNow), ['q']);
  assert.equal(hindranceOf(of([p]), kNow), 'not_waived');
  assert.equal(hindranceOf(of([p, { ...waiver, point: 'q' }]), kNow), null);
  assert.equal(hindranceOf(of([p, { ...waiver, point: 'q', expires_at_ms: 1 }]), kNow), 'waiver_ended');
  assert.deepEqual(openPoints(of([waiver]), kNow), []);
  assert.equal(hindranceOf(verdict({ verdict: 'warn', waivers: [p] }), kNow), 'not_waived', 'a point that the verdict does not have');
});

test('the sums of the past reach back so many days, and are compared with the forecast', () => {
  assert.equal(rangeBegin(null, 1_800_000_012_345), null);
  assert.equal(rangeBegin(1, 1_800_000_012_345), 1_800_000_000_000 - 86_400_000);
  assert.equal(rangeBegin(7, 1_800_000_000_000), rangeBegin(7, 1_800_000_059_999), 'the same within a minute');
  assert.equal(againstForecast({ forecast_s: 80, forecast_took_s: 100 }), 1.25);
  assert.equal(againstForecast({ forecast_s: 0, forecast_took_s: 0 }), null);
});

const release = (change: Partial<Release>): Release =>
  ({ id: 9, program: 1, revision: 1, machine: 'mill', delivery: 'drip', sha256: 'aa', state: 'approved', transfers_done: 0, transfers_allowed: 0, ...change }) as Release;
const verdict = (change: Partial<VerdictSummary>): VerdictSummary =>
  ({ id: 1, sha256: 'aa', machine: 'mill', delivery: 'drip', verdict: 'pass', stale: false, points: [], waivers: [], ...change }) as VerdictSummary;
const kNow = 1000;
const waiver = { name: 'a', reason: 'b', at_ms: 1, point: null, expires_at_ms: null };

test('what hinders a release is its newest verdict on the same text, machine and delivery', () => {
  const all = [verdict({ id: 1, verdict: 'fail' }), verdict({ id: 3 }), verdict({ id: 4, machine: 'lathe', verdict: 'fail' }), verdict({ id: 5, sha256: 'bb' })];
  assert.equal(verdictOf(all, release({}))?.id, 3);
  assert.equal(hindranceOf(null, kNow), 'not_checked');
  assert.equal(hindranceOf(verdict({}), kNow), null);
  assert.equal(hindranceOf(verdict({ verdict: 'fail', waivers: [waiver] }), kNow), 'failed', 'nobody waives that');
  assert.equal(hindranceOf(verdict({ verdict: 'unknown' }), kNow), 'not_waived');
  assert.equal(hindranceOf(verdict({ verdict: 'unknown', waivers: [waiver] }), kNow), null);
  assert.equal(hindranceOf(verdict({ stale: true }), kNow), 'stale');
  assert.equal(hindranceOf(verdict({ verdict: 'warn', waivers: [{ ...waiver, expires_at_ms: kNow }] }), kNow), 'waiver_ended');
  assert.equal(hindranceOf(verdict({ verdict: 'warn', waivers: [{ ...waiver, expires_at_ms: kNow + 1 }] }), kNow), null);
  assert.deepEqual(stepsOf(release({ state: 'in_review' })).filter(({ towardsControl }) => towardsControl).map(({ to }) => to), ['proving']);
  assert.ok(needsFourEyes([{ name: 'g', machines: ['mill'], four_eyes: true, operator_sign_off: true }], 'mill'));
  assert.ok(!needsFourEyes([{ name: 'g', machines: ['mill'], four_eyes: false, operator_sign_off: true }], 'mill'));
  assert.ok(needsSignOff([], 'mill'));
  assert.ok(!needsSignOff([{ name: 'g', machines: ['mill'], four_eyes: true, operator_sign_off: false }], 'mill'));
  assert.ok(needsSignOff([{ name: 'g', machines: ['lathe'], four_eyes: true, operator_sign_off: false }], 'mill'));
});

test('releases for an order: of its machine, of its part first', () => {
  const all = [release({ id: 1, program: 7 }), release({ id: 2, program: 8 }), release({ id: 3, machine: 'lathe' }), release({ id: 4, state: 'draft' })];
  assert.deepEqual(fitting(all, 'mill', new Set([7])).map(({ id }) => id), [1, 2]);
  assert.deepEqual(fitting(all, null, new Set()).map(({ id }) => id), [3, 2, 1]);
});

test('releases of a program as it is now', () => {
  const all = [release({ id: 1, state: 'draft' }), release({ id: 2, state: 'obsolete' }), release({ id: 3 }), release({ id: 4, revision: 9 })];
  assert.deepEqual(presentOf(all, { revision: 1 }).map(({ id }) => id), [3, 1]);
});

test('work offsets by name', () => {
  assert.deepEqual([0, 1, 6, 7].map(offsetName), ['', 'G54', 'G59', 'P1']);
});
