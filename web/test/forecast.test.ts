// How long a feed still takes: by bytes, by the prediction, and by the prediction as it is corrected; each claims no more
// than is known.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { JobForecast, MachineStatus } from '../src/api/types';
import { bufferedBlocks, paceOf, predictedS, timeLeft, type Pace } from '../src/rules/forecast';
import { jobOf, statusOf } from './samples';

const job = jobOf({ state: 'feeding', started_at_ms: 0 });
const feeding = (change: Partial<MachineStatus> = {}) => statusOf({ line: 'feeding', job: 1, total: 10_000, clocked: 5_000, block_from: 500, block: 500, ...change });
// A thousand lines of a second each, but for the second half, which takes twice as long.
const forecast: JobForecast = {
  job: 1,
  verdict: 1,
  stale: false,
  cycle_s: 1500,
  course: [
    [1, 0],
    [501, 500],
    [1000, 1498],
  ],
  buffer_bytes: null,
  buffer_blocks: 100,
};
const left = (status: MachineStatus, nowMs: number, pace: Pace | null = null, of: JobForecast | null = forecast) =>
  timeLeft({ status, job, forecast: of, lines: 1000, pace, nowMs });

test('without a prediction the rate of bytes is what is known', () => {
  const at = (clocked: number, nowMs: number, change = {}) => left(feeding({ total: 1000, clocked, ...change }), nowMs, null, null);
  assert.deepEqual(at(250, 60_000), { low_ms: 180_000, high_ms: 180_000, by: 'bytes' });
  assert.equal(at(10, 60_000), null, 'one part in a hundred says nothing');
  assert.equal(at(250, 2_000), null);
  assert.equal(at(250, 60_000, { line: 'held', stall: 'stopped' }), null, 'a person decides when it goes on');
  assert.equal(at(250, 60_000, { job: 2 }), null);
  assert.equal(left(feeding(), 60_000, null, { ...forecast, cycle_s: null, course: [] })?.by, 'bytes', 'a verdict without times');
});

test('a line begins between its neighbours in the course', () => {
  assert.equal(predictedS(forecast, 1, 1000), 0);
  assert.equal(predictedS(forecast, 251, 1000), 250);
  assert.equal(Math.round(predictedS(forecast, 751, 1000) ?? 0), 1000);
  assert.equal(predictedS(forecast, 5000, 1000), 1500);
  assert.equal(predictedS(forecast, 0, 1000), null, 'nothing is known of where it is');
  assert.equal(predictedS({ ...forecast, course: [] }, 10, 1000), null);
});

test('before enough was seen the prediction stands, as a range of what the buffer may hold', () => {
  const found = left(feeding({ block_from: 101, block: 101 }), 10_000);
  assert.equal(found?.by, 'checked');
  assert.equal(found?.low_ms, 1_400_000); // all that was sent may have been executed
  assert.equal(found?.high_ms, 1_500_000); // or nothing of it: it fits into the buffer
});

test('a machine that is slower than predicted corrects the rest', () => {
  // 400 to 500 of the predicted seconds were executed in 1000 s: the rest takes 2 to 2.5 times as long as predicted.
  const found = left(feeding({ block_from: 501, block: 501 }), 1_000_000);
  assert.equal(found?.by, 'pace');
  assert.equal(Math.round((found?.low_ms ?? 0) / 1000), 2000);
  assert.equal(Math.round((found?.high_ms ?? 0) / 1000), 2750);
  assert.ok((found?.low_ms ?? 0) < (found?.high_ms ?? 0));
});

test('a run that stood for long says nothing of the pace', () => {
  assert.equal(left(feeding({ block_from: 501, block: 501 }), 10_000_000)?.by, 'checked');
});

test('a look that was long enough counts before the whole run, and begins anew after a stop', () => {
  const begun = paceOf(null, feeding({ block: 301 }), job, 300, 9_000_000);
  assert.deepEqual(begun, { job: 1, from_ms: 9_000_000, from_s: 300 });
  const found = left(feeding({ block_from: 501, block: 501 }), 9_300_000, begun);
  assert.equal(found?.by, 'pace'); // 200 predicted seconds in 300
  assert.ok((found?.low_ms ?? 0) <= 1_500_000 && (found?.high_ms ?? 0) >= 1_500_000, JSON.stringify(found));
  assert.equal(paceOf(begun, feeding({ line: 'held', stall: 'stopped' }), job, 300, 9_300_000), null);
  assert.equal(paceOf(begun, feeding(), jobOf({ id: 2 }), 300, 9_300_000), null, 'another job');
  assert.deepEqual(paceOf(begun, feeding(), job, 10, 9_300_000)?.from_s, 10, 'the program runs again');
});

test('what lies in the buffer is a range, and exact only where the PLC reports its block', () => {
  assert.deepEqual(bufferedBlocks(feeding(), forecast, 1000), { low: 0, high: 100 });
  assert.deepEqual(bufferedBlocks(feeding({ block_from: 30, block: 30 }), forecast, 1000), { low: 0, high: 30 }, 'no more than was sent');
  assert.deepEqual(bufferedBlocks(feeding(), { ...forecast, buffer_blocks: null, buffer_bytes: 500 }, 1000), { low: 0, high: 50 }, 'blocks of 10 bytes');
  assert.equal(bufferedBlocks(feeding(), { ...forecast, buffer_blocks: null }, 1000), null, 'the profile has no buffer');
  const plc = { state: 'running' as const, program: 1, line: 480, alarm: 0 };
  assert.deepEqual(bufferedBlocks(feeding({ block_from: 490, block: 500, plc }), forecast, 1000), { low: 10, high: 20 });
});
