// Which orders are offered to whom, in each state.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { JobState, LineState, Stall } from '../src/api/types';
import { offerFor } from '../src/rules/job_actions';
import { expiresAt, hasJob, isTorn } from '../src/rules/lines';
import { isReleased, mayBeQueued } from '../src/rules/releases';
import { atLeast } from '../src/rules/roles';
import { routeOf } from '../src/route';
import { jobOf, releaseOf, statusOf } from './samples';

const offered = (state: JobState, stall: Stall | null = null, live = true) =>
  offerFor(jobOf({ state }), statusOf({ job: 1, stall, line: 'held' }), 'operator', live).actions;

test('each state of a job has its orders', () => {
  assert.deepEqual(offered('armed'), ['disarm']);
  assert.deepEqual(offered('feeding'), ['stop', 'cancel']);
  assert.deepEqual(offered('held', 'held by DC3'), ['resume_as_dc1', 'stop', 'cancel']);
  assert.deepEqual(offered('held', 'stopped'), ['resume', 'cancel']);
  assert.deepEqual(offered('held', 'stopped, and the control asked anew: it may have been reset'), ['cancel']);
  assert.deepEqual(offered('held', 'peer gone'), ['cancel']);
  assert.deepEqual(offered('draining'), []);
  assert.deepEqual(offered('draining', 'waiting for end'), ['cancel']);
  for (const state of ['done', 'failed', 'cancelled', 'interrupted'] as const) assert.deepEqual(offered(state), []);
});

test("another job's stall is not this job's", () => {
  const offer = offerFor(jobOf({ state: 'held' }), statusOf({ job: 2, stall: 'held by DC3', line: 'held' }), 'operator', true);
  assert.deepEqual(offer.actions, ['cancel']);
});

test('without a live connection nothing can be set in motion', () => {
  assert.deepEqual(offered('held', 'held by DC3', false), ['stop', 'cancel']);
  assert.deepEqual(offered('held', 'stopped', false), ['cancel']);
  assert.deepEqual(offered('armed', null, false), ['disarm']);
  assert.deepEqual(offerFor(jobOf(), statusOf(), 'operator', false).actions, []);
});

test('a queued job can be armed on an idle line only', () => {
  assert.deepEqual(offerFor(jobOf(), statusOf(), 'operator', true), { actions: ['arm', 'withdraw'], because: null });
  const lines: LineState[] = ['armed', 'feeding', 'held', 'draining', 'torn', 'disconnected'];
  for (const line of lines) {
    const offer = offerFor(jobOf(), statusOf({ line, job: 5 }), 'operator', true);
    assert.deepEqual(offer.actions, ['withdraw'], line);
    assert.ok(offer.because, line);
  }
  const torn = statusOf({ line: 'idle', needs_confirmation: { job: 5, text: 't' } });
  assert.deepEqual(offerFor(jobOf(), torn, 'operator', true).actions, ['withdraw']);
  assert.deepEqual(offerFor(jobOf(), null, 'operator', true).actions, ['withdraw']);
});

test('a viewer gets no order', () => {
  for (const state of ['queued', 'armed', 'feeding', 'held'] as const)
    assert.deepEqual(offerFor(jobOf({ state }), statusOf({ job: 1 }), 'viewer', true), { actions: [], because: null });
});

test('roles are in order', () => {
  assert.ok(atLeast('admin', 'operator'));
  assert.ok(atLeast('operator', 'operator'));
  assert.ok(!atLeast('viewer', 'operator'));
  assert.ok(!atLeast('programmer', 'approver'));
});

test('lines: torn in the store counts, the last job of an idle line is not on it', () => {
  assert.ok(isTorn(statusOf({ line: 'torn' })));
  assert.ok(isTorn(statusOf({ line: 'disconnected', needs_confirmation: { job: 1, text: 't' } })));
  assert.ok(!isTorn(statusOf({ line: 'held' })));
  assert.ok(!hasJob(statusOf({ line: 'idle', job: 4 })));
  assert.ok(hasJob(statusOf({ line: 'draining', job: 4 })));
  assert.equal(expiresAt(1_000), 601_000);
});

test('a release is queued while proving has transfers left, and when approved', () => {
  assert.ok(mayBeQueued(releaseOf()));
  assert.ok(mayBeQueued(releaseOf({ state: 'proving', transfers_allowed: 2, transfers_done: 1 })));
  assert.ok(!mayBeQueued(releaseOf({ state: 'proving', transfers_allowed: 2, transfers_done: 2 })));
  for (const state of ['draft', 'in_review', 'obsolete'] as const) {
    assert.ok(!mayBeQueued(releaseOf({ state })));
    assert.ok(!isReleased(releaseOf({ state })));
  }
});

test('the address names the view', () => {
  assert.deepEqual(routeOf(''), { view: 'machines' });
  assert.deepEqual(routeOf('#/jobs'), { view: 'jobs' });
  assert.deepEqual(routeOf('#/jobs/12'), { view: 'job', id: 12 });
  assert.deepEqual(routeOf('#/jobs/0'), { view: 'jobs' });
  assert.deepEqual(routeOf('#/jobs/x'), { view: 'jobs' });
  assert.deepEqual(routeOf('#/releases'), { view: 'releases' });
  assert.deepEqual(routeOf('#/nowhere'), { view: 'machines' });
});
