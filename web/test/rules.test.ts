// Which orders are offered to whom, in each state.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { JobState, LineState, Stall } from '../src/api/types';
import { offerFor } from '../src/rules/job_actions';
import { asksForPerson, byUrgency, stateOf } from '../src/rules/alarms';
import { hasJob, isTorn } from '../src/rules/lines';
import { isReleased, mayBeQueued } from '../src/rules/releases';
import { atLeast } from '../src/rules/roles';
import { lineOfEnd, mayRestart, shownLines, stepOf } from '../src/rules/restarts';
import { kNeedsPerson, standingOf } from '../src/rules/standing';
import { routeOf } from '../src/router';
import { alarmOf, jobOf, releaseOf, statusOf } from './samples';

const offered = (state: JobState, stall: Stall | null = null, live = true) =>
  offerFor(jobOf({ state }), statusOf({ job: 1, stall, line: 'held' }), 'operator', live).actions;

test('each state of a job has its orders', () => {
  assert.deepEqual(offered('armed'), ['disarm']);
  assert.deepEqual(offered('feeding'), ['stop', 'cancel']);
  assert.deepEqual(offered('held', 'held by DC3'), ['resume_as_dc1', 'stop', 'cancel']);
  assert.deepEqual(offered('held', 'stopped'), ['resume', 'cancel']);
  assert.deepEqual(offered('held', 'stopped, and the control asked again: it may have been reset'), ['cancel']);
  assert.deepEqual(offered('held', 'waiting for credit'), ['stop', 'cancel']);
  assert.deepEqual(offered('held', 'peer gone'), ['stop', 'cancel']);
  assert.deepEqual(offered('draining'), []);
  assert.deepEqual(offered('draining', 'waiting for end'), ['cancel']);
  for (const state of ['done', 'failed', 'cancelled', 'interrupted'] as const) assert.deepEqual(offered(state), []);
});

test("another job's stall is not this job's", () => {
  const offer = offerFor(jobOf({ state: 'held' }), statusOf({ job: 2, stall: 'held by DC3', line: 'held' }), 'operator', true);
  assert.deepEqual(offer.actions, ['stop', 'cancel']);
});

test('without a live connection nothing can be set in motion', () => {
  assert.deepEqual(offered('held', 'held by DC3', false), ['stop', 'cancel']);
  assert.deepEqual(offered('held', 'stopped', false), ['cancel']);
  assert.deepEqual(offered('armed', null, false), ['disarm']);
  assert.deepEqual(offerFor(jobOf(), statusOf(), 'operator', false).actions, []);
});

test('a queued job can be armed on an idle line only', () => {
  assert.deepEqual(offerFor(jobOf(), statusOf(), 'operator', true), { actions: ['arm', 'withdraw'], because: null });
  const ended = jobOf({ id: 4, state: 'done', end_check: 'part out', needs_end_confirmation: true });
  assert.deepEqual(offerFor(jobOf(), statusOf(), 'operator', true, 0, ended), { actions: ['withdraw'], because: { id: 'because.end_unconfirmed', values: { job: 4, check: 'part out' } } });
  const onHold = offerFor(jobOf({ on_hold: { by: 'anna', reason: 'no material' } }), statusOf(), 'admin', true);
  assert.deepEqual(onHold, { actions: ['withdraw'], because: { id: 'because.on_hold', values: { name: 'anna', reason: 'no material' } } });
  const timed = jobOf({ not_before_ms: 5000 });
  assert.equal(offerFor(timed, statusOf(), 'approver', true, 4999).because?.id, 'because.too_early');
  assert.deepEqual(offerFor(timed, statusOf(), 'operator', true, 4999).actions, ['withdraw']);
  assert.deepEqual(offerFor(timed, statusOf(), 'operator', true, 5000).actions, ['arm', 'withdraw']);
  const lines: LineState[] = ['armed', 'feeding', 'held', 'draining', 'torn', 'disconnected'];
  for (const line of lines) {
    const offer = offerFor(jobOf(), statusOf({ line, job: 5 }), 'operator', true);
    assert.deepEqual(offer.actions, ['withdraw'], line);
    assert.ok(offer.because, line);
  }
  const torn = statusOf({ line: 'idle', needs_confirmation: { job: 5, text: 't', said: null, reason_id: null } });
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
  assert.ok(isTorn(statusOf({ line: 'disconnected', needs_confirmation: { job: 1, text: 't', said: null, reason_id: null } })));
  assert.ok(!isTorn(statusOf({ line: 'held' })));
  assert.ok(!hasJob(statusOf({ line: 'idle', job: 4 })));
  assert.ok(hasJob(statusOf({ line: 'draining', job: 4 })));
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

test('the address names the view, and an unknown one no other', () => {
  const seen = (hash: string) => {
    const { view, parameters } = routeOf(hash);
    return [view, ...parameters].join(' ');
  };
  assert.equal(seen(''), 'floor');
  assert.equal(seen('#/'), 'floor');
  assert.equal(seen('#/machines'), 'floor');
  assert.equal(seen('#/machines/mill%201%2F2'), 'machine mill 1/2');
  assert.equal(seen('#/jobs'), 'jobs');
  assert.equal(seen('#/jobs/12'), 'job 12');
  assert.equal(seen('#/releases'), 'releases');
  for (const wrong of ['#/jobs/0', '#/jobs/x', '#/nowhere', '#/jobs/1/2', '#/machines/%E0%A4%A', '#/machines/'])
    assert.equal(seen(wrong), 'not_found', wrong);
  assert.equal(routeOf('#/floor?look=andon').query.get('look'), 'andon');
});

const now = (change: Parameters<typeof statusOf>[0]) => {
  const status = statusOf(change);
  return { ...status, plc_alarm: status.plc?.alarm ?? 0 };
};

test('where a machine stands is one word, by what is most urgent', () => {
  const key = (change: Parameters<typeof statusOf>[0], job = jobOf({ state: 'feeding' }), queued = 0) => standingOf(now(change), job, queued).key;
  const torn = { job: 1, text: 't', said: null, reason_id: null };
  assert.equal(key({ line: 'disconnected', needs_confirmation: torn }), 'torn');
  assert.equal(key({ line: 'held', job: 1, stall: 'stopped' }), 'stopped');
  assert.equal(key({ line: 'held', job: 1, stall: 'stopped, and the control asked again: it may have been reset' }), 'reset_suspected');
  assert.equal(key({ line: 'held', job: 1, stall: 'held by DC3' }), 'feeding', 'a full buffer is normal');
  assert.equal(key({ line: 'held', job: 1, stall: 'CTS off' }), 'waiting');
  assert.equal(key({ line: 'disconnected', job: 1 }), 'lost_with_job');
  assert.equal(key({ line: 'disconnected', job: 1 }, jobOf({ state: 'done', ended_at_ms: 5 })), 'disconnected');
  assert.equal(key({ line: 'idle', job: 1 }, jobOf({ state: 'failed', ended_at_ms: 5 })), 'failed');
  assert.equal(key({ line: 'idle', asks_since_ms: 5 }, jobOf({ state: 'done', ended_at_ms: 5 })), 'asks');
  assert.equal(key({ line: 'idle' }, jobOf({ state: 'done', ended_at_ms: 5 }), 3), 'queued');
  assert.equal(key({ line: 'idle', job: 1, plc: { state: 'alarm', program: 0, line: 0, alarm: 7 } }), 'machine_alarm');
  const ended = jobOf({ id: 4, state: 'done', ended_at_ms: 5, end_check: 'part out', needs_end_confirmation: true });
  assert.equal(standingOf(now({ line: 'idle', asks_since_ms: 5 }), ended, 3, ended).key, 'end_unconfirmed');
  assert.equal(standingOf(now({ line: 'disconnected' }), ended, 3, ended).key, 'disconnected');
  assert.equal(standingOf(now({ line: 'feeding', job: 5 }), jobOf({ state: 'feeding' }), 3, ended).key, 'feeding');
  assert.ok(standingOf(now({ line: 'idle' }), ended, 0, ended).urgency > kNeedsPerson);
  assert.ok(standingOf(now({ line: 'feeding', job: 1 }), null, 0).urgency < kNeedsPerson);
  assert.ok(standingOf(now({ line: 'held', job: 1, stall: 'stopped' }), null, 0).urgency > kNeedsPerson);
});

test('alarms ask for a person until they are acknowledged or shelved', () => {
  assert.ok(asksForPerson(alarmOf(), 10));
  assert.ok(asksForPerson(alarmOf({ cleared_at_ms: 5 }), 10), 'over, and nobody saw it');
  assert.ok(!asksForPerson(alarmOf({ acknowledged_by: 'anna', acknowledged_at_ms: 5 }), 10));
  assert.ok(!asksForPerson(alarmOf({ shelved_until_ms: 11 }), 10));
  assert.ok(asksForPerson(alarmOf({ shelved_until_ms: 10 }), 10));
  assert.equal(stateOf(alarmOf({ acknowledged_at_ms: 5, cleared_at_ms: 6 }), 10), 'closed');
  const list = [alarmOf({ id: 1, last_at_ms: 9 }), alarmOf({ id: 2, severity: 'critical', acknowledged_at_ms: 3 }), alarmOf({ id: 3, severity: 'critical' })];
  assert.deepEqual(list.sort(byUrgency).map((one) => one.id), [3, 1, 2]);
});

test('a job that is over can be restarted, from the line that its end states', () => {
  for (const state of ['done', 'failed', 'cancelled', 'interrupted'] as const) assert.ok(mayRestart(jobOf({ state })), state);
  for (const state of ['queued', 'armed', 'feeding', 'held', 'draining'] as const) assert.ok(!mayRestart(jobOf({ state })), state);
  assert.equal(lineOfEnd({ reason: 'cancelled by olga after 812 bytes (line 35 to 37)' }), 35);
  assert.equal(lineOfEnd({ reason: 'cancelled' }), null);
});

test('a restart is shown with its new lines and the first of the rest', () => {
  const preview = {
    possible: true,
    text: '%\nO1\n(RESTART AT LINE 9)\nG90\nG1 X1.\nX2.\nX3.\nM30\n%\n',
    sha256: 'ab',
    preamble_line: 3,
    rest_line: 5,
    assumptions: [],
    compared_moves: 3,
    findings: [],
    not_held: null,
    safe_before: null,
    safe_after: null,
    diagnostics: [],
  };
  const shown = shownLines(preview, 2);
  assert.deepEqual(shown.map(({ number, isNew }) => [number, isNew]), [[3, true], [4, true], [5, false], [6, false]]);
  assert.equal(shown[2]?.text, 'G1 X1.');
  assert.deepEqual(shownLines({ ...preview, text: null }, 2), []);
});

test("a restart's release goes on step by step, once", () => {
  assert.equal(stepOf(releaseOf({ state: 'draft' })), 'clear');
  assert.equal(stepOf(releaseOf({ state: 'in_review' })), 'release');
  assert.equal(stepOf(releaseOf({ state: 'proving', transfers_allowed: 1, transfers_done: 0 })), 'queue');
  assert.equal(stepOf(releaseOf({ state: 'proving', transfers_allowed: 1, transfers_done: 1 })), 'gone');
  assert.equal(stepOf(releaseOf({ state: 'obsolete' })), 'gone');
});
