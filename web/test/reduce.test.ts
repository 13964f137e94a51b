// The state: what each action does, and that an old answer never hides a newer report.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { meaningOf } from '../src/state/event_actions';
import { reduce, type Action } from '../src/state/reduce';
import { newestFirst, queuedFor } from '../src/state/select';
import { kStart, type State } from '../src/state/state';
import { jobOf, machineOf, progressOf } from './samples';

const run = (state: State, ...actions: Action[]): State => actions.reduce(reduce, state);
const loaded = (machines = [machineOf('a')], jobs = [jobOf()]): State =>
  run(
    kStart,
    { type: 'signed_in', session: { name: 'x', role: 'operator' } },
    { type: 'loaded', machines, jobs, olderJobs: null, programs: [], releases: [] },
    { type: 'live' },
  );
const statusIn = (state: State, name = 'a') => state.machines.get(name)?.item.status;

test('a report changes the figures and keeps what it does not carry', () => {
  const torn = { job: 3, text: 'torn' };
  const before = loaded([machineOf('a', { job: 3, program: 'O1', block: 5, block_text: 'G1', needs_confirmation: torn })]);
  const after = reduce(before, { type: 'progress', progress: progressOf('a', { job: 3, handed: 20, clocked: 14, block: 9 }) });
  assert.equal(statusIn(after)?.handed, 20);
  assert.equal(statusIn(after)?.program, 'O1');
  assert.deepEqual(statusIn(after)?.needs_confirmation, torn);
  assert.deepEqual(after.machines.get('a')?.block, { line: 5, text: 'G1' }, 'the text stays with its own line');
  assert.equal(statusIn(before)?.handed, 0, 'the state before is not changed');
});

test("another job's report drops the program and the block of the one before", () => {
  const before = loaded([machineOf('a', { job: 3, program: 'O1', block: 5, block_text: 'G1' })]);
  const after = reduce(before, { type: 'progress', progress: progressOf('a', { job: 4 }) });
  assert.equal(statusIn(after)?.program, '');
  assert.equal(after.machines.get('a')?.block, null);
});

test('an answer older than a report gives only what reports do not carry', () => {
  const asked = loaded([machineOf('a', { job: 3 })]);
  const state = run(
    asked,
    { type: 'progress', progress: progressOf('a', { job: 3, line: 'idle', handed: 50 }) },
    { type: 'machine', item: machineOf('a', { job: 3, line: 'feeding', handed: 40, program: 'O1', block: 8, block_text: 'G2' }), reportsBefore: 0 },
  );
  assert.equal(statusIn(state)?.line, 'idle');
  assert.equal(statusIn(state)?.handed, 50);
  assert.equal(statusIn(state)?.program, 'O1');
  assert.deepEqual(state.machines.get('a')?.block, { line: 8, text: 'G2' });
});

test('an older answer about another job gives nothing of that job', () => {
  const state = run(
    loaded([machineOf('a', { job: 3 })]),
    { type: 'progress', progress: progressOf('a', { job: 4, line: 'armed' }) },
    { type: 'machine', item: machineOf('a', { job: 3, program: 'O1', block: 8, block_text: 'G2' }), reportsBefore: 0 },
  );
  assert.equal(statusIn(state)?.job, 4);
  assert.equal(statusIn(state)?.program, '');
  assert.equal(state.machines.get('a')?.block, null);
});

test('an answer without a report since is taken whole', () => {
  const state = run(
    loaded(),
    { type: 'progress', progress: progressOf('a', { handed: 50 }) },
    { type: 'machine', item: machineOf('a', { handed: 60, line: 'held' }), reportsBefore: 1 },
  );
  assert.equal(statusIn(state)?.handed, 60);
  assert.equal(statusIn(state)?.line, 'held');
});

test('an older answer still tells of a torn block, and that it is confirmed', () => {
  const torn = { job: 3, text: 'torn' };
  const told = run(
    loaded(),
    { type: 'progress', progress: progressOf('a', { job: 3, line: 'torn' }) },
    { type: 'machine', item: machineOf('a', { job: 3, needs_confirmation: torn }), reportsBefore: 0 },
  );
  assert.deepEqual(statusIn(told)?.needs_confirmation, torn);
  const confirmed = reduce(told, { type: 'machine', item: machineOf('a', { job: 3 }), reportsBefore: 0 });
  assert.equal(statusIn(confirmed)?.needs_confirmation, null);
});

test('a report of an unknown machine changes nothing', () => {
  const before = loaded();
  assert.equal(reduce(before, { type: 'progress', progress: progressOf('z') }), before);
});

test('loading replaces everything, older pages add', () => {
  const before = loaded([machineOf('a'), machineOf('b')], [jobOf({ id: 1 }), jobOf({ id: 2 })]);
  const again = reduce(before, { type: 'loaded', machines: [machineOf('b')], jobs: [jobOf({ id: 9 })], olderJobs: 'x', programs: [], releases: [] });
  assert.deepEqual([...again.machines.keys()], ['b']);
  assert.deepEqual(newestFirst(again).map((job) => job.id), [9]);
  const more = reduce(again, { type: 'older_jobs', jobs: [jobOf({ id: 4 }), jobOf({ id: 8 })], olderJobs: null });
  assert.deepEqual(newestFirst(more).map((job) => job.id), [9, 8, 4]);
  assert.equal(more.olderJobs, null);
});

test('a loss keeps the instant at which it was first noticed', () => {
  const lost = run(loaded(), { type: 'lost', at: 100 }, { type: 'lost', at: 200 });
  assert.deepEqual(lost.connection, { phase: 'lost', since: 100 });
  assert.deepEqual(reduce(lost, { type: 'live' }).connection, { phase: 'live' });
});

test('signing out forgets everything', () => {
  const out = reduce(loaded(), { type: 'signed_out', because: 'over' });
  assert.equal(out.machines.size, 0);
  assert.equal(out.jobs.size, 0);
  assert.equal(out.session, 'none');
  assert.equal(out.signedOutBecause, 'over');
});

test('alarms are newest first, limited, and go when seen', () => {
  let state = loaded();
  for (let i = 0; i < 30; ++i) state = reduce(state, { type: 'alarm', alarm: { machine: 'a', text: String(i) }, at: i });
  assert.equal(state.alarms.length, 20);
  assert.equal(state.alarms[0]?.text, '29');
  assert.equal(new Set(state.alarms.map((alarm) => alarm.key)).size, 20);
  const key = state.alarms[3]?.key ?? 0;
  assert.equal(reduce(state, { type: 'alarm_seen', key }).alarms.some((alarm) => alarm.key === key), false);
});

test('the queue of a machine is oldest first and holds queued jobs only', () => {
  const state = loaded([machineOf('a')], [jobOf({ id: 5 }), jobOf({ id: 2 }), jobOf({ id: 3, state: 'done' }), jobOf({ id: 4, machine: 'b' })]);
  assert.deepEqual(queuedFor(state, 'a').map((job) => job.id), [2, 5]);
});

test('events mean what they say; what cannot be read means nothing', () => {
  const job = jobOf({ id: 7, machine: 'b' });
  assert.deepEqual(meaningOf({ name: 'job', data: JSON.stringify(job) }, 0), { action: { type: 'job', job }, refreshMachine: 'b', reload: false });
  assert.equal(meaningOf({ name: 'machine', data: '{"name":"b"}' }, 0).refreshMachine, 'b');
  assert.equal(meaningOf({ name: 'reset', data: '{}' }, 0).reload, true);
  assert.deepEqual(meaningOf({ name: 'alarm', data: '{"machine":"b","text":"t"}' }, 5).action, { type: 'alarm', alarm: { machine: 'b', text: 't' }, at: 5 });
  for (const event of [
    { name: 'progress', data: '{"machine":' },
    { name: 'progress', data: 'null' },
    { name: 'job', data: '{}' },
    { name: 'something', data: '{"name":"b"}' },
  ]) {
    assert.deepEqual(meaningOf(event, 0), { action: null, refreshMachine: null, reload: false });
  }
});
