// What the page knows: what news does to it, and that an old answer never hides a newer report.
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { effect } from '@preact/signals';
import { setAlarms, setMachines, takeAlarms, takeJobs, takeMachine, takeProgress } from '../src/state/changes';
import { alarms, clearShop, jobs, jobsNewestFirst, machines, queueOf } from '../src/state/shop';
import { alarmOf, jobOf, machineOf, progressOf } from './samples';

const status = (name = 'a') => machines.value.get(name)?.status.value;
beforeEach(clearShop);

test('a report changes the figures and keeps what it does not carry', () => {
  const torn = { job: 3, text: 'torn', said: null, reason_id: null };
  setMachines([machineOf('a', { job: 3, needs_confirmation: torn })]);
  takeProgress(progressOf('a', { job: 3, handed: 20, block: 9, block_text: 'G1 X2' }));
  assert.equal(status()?.handed, 20);
  assert.equal(status()?.block_text, 'G1 X2');
  assert.deepEqual(status()?.needs_confirmation, torn);
});

test('a report of one machine draws no other', () => {
  setMachines([machineOf('a'), machineOf('b')]);
  const drawn = { a: 0, b: 0 };
  const ends = (['a', 'b'] as const).map((name) =>
    effect(() => {
      void status(name);
      drawn[name] += 1;
    }),
  );
  takeProgress(progressOf('a', { handed: 1 }));
  takeProgress(progressOf('a', { handed: 2 }));
  takeProgress(progressOf('nobody', { handed: 2 }));
  assert.deepEqual(drawn, { a: 3, b: 1 });
  for (const end of ends) end();
});

test('an answer that was asked for before a report does not take it back', () => {
  setMachines([machineOf('a', { job: 3 })]);
  takeProgress(progressOf('a', { job: 3, handed: 50 }));
  const torn = { job: 3, text: 'torn', said: null, reason_id: null };
  takeMachine(machineOf('a', { job: 3, handed: 10, needs_confirmation: torn }), 0);
  assert.equal(status()?.handed, 50);
  assert.deepEqual(status()?.needs_confirmation, torn);
  takeMachine(machineOf('a', { job: 3, handed: 60 }), 1);
  assert.equal(status()?.handed, 60);
  assert.equal(status()?.needs_confirmation, null);
});

test('a new machine keeps the others', () => {
  setMachines([machineOf('a', { handed: 4 })]);
  takeMachine(machineOf('b'), 0);
  assert.deepEqual([...machines.value.keys()], ['a', 'b']);
  assert.equal(status()?.handed, 4);
  setMachines([machineOf('b')]);
  assert.deepEqual([...machines.value.keys()], ['b']);
});

test('queues are by machine, rank and number', () => {
  takeJobs([jobOf({ id: 1, rank: 3 }), jobOf({ id: 2, rank: 1 }), jobOf({ id: 3, rank: 1 }), jobOf({ id: 4, state: 'done' }), jobOf({ id: 5, machine: 'b' })]);
  assert.deepEqual(queueOf('a').map((job) => job.id), [2, 3, 1]);
  assert.deepEqual(queueOf('b').map((job) => job.id), [5]);
  assert.deepEqual(jobsNewestFirst.value.map((job) => job.id), [5, 4, 3, 2, 1]);
  takeJobs([jobOf({ id: 2, state: 'armed' })]);
  assert.deepEqual(queueOf('a').map((job) => job.id), [3, 1]);
  assert.equal(jobs.value.size, 5);
});

test('an alarm stays until it is over and acknowledged', () => {
  setAlarms([alarmOf({ id: 1 }), alarmOf({ id: 2, cleared_at_ms: 5, acknowledged_at_ms: 6 })]);
  assert.deepEqual([...alarms.value.keys()], [1]);
  takeAlarms([alarmOf({ id: 1, cleared_at_ms: 5 })]);
  assert.equal(alarms.value.size, 1);
  takeAlarms([alarmOf({ id: 1, cleared_at_ms: 5, acknowledged_at_ms: 6 }), alarmOf({ id: 3 })]);
  assert.deepEqual([...alarms.value.keys()], [3]);
});
