// Words, numbers and times.
import assert from 'node:assert/strict';
import { webcrypto } from 'node:crypto';
import { test } from 'node:test';
import { summaryOf } from '../src/api/calls';
import { errorOfProblem, newOrderKey } from '../src/api/client';
import { intervalText } from '../src/format/intervals';
import { bytes, count, percent, share, shortHash } from '../src/format/numbers';
import { clockTime, countdown, dateTime, duration, shortTime } from '../src/format/times';
import { jobWording, placeText, reasonText, stallText } from '../src/format/words';
import type { MachineWhole } from '../src/api/types';
import { statusOf } from './samples';

const plain = (text: string) => text.replace(/\u202F/g, ' ');

test('counts are grouped, shares are rounded down', () => {
  assert.equal(plain(count(1234567)), '1 234 567');
  assert.equal(count(0), '0');
  assert.equal(bytes(1), '1 byte');
  assert.equal(plain(bytes(2048)), '2 048 bytes');
  assert.equal(percent(9999, 10000), '99.9 %');
  assert.equal(percent(10000, 10000), '100.0 %');
  assert.equal(percent(0, 10000), '0.0 %');
  assert.equal(percent(5, 0), '–');
  assert.equal(share(20, 10), 1);
  assert.equal(share(1, 0), 0);
  assert.equal(shortHash('0123456789abcdef'), '0123456789ab');
});

test('a countdown reaches 0:00 only when it is over', () => {
  assert.equal(countdown(600_000), '10:00');
  assert.equal(countdown(61_000), '1:01');
  assert.equal(countdown(1), '0:01');
  assert.equal(countdown(0), '0:00');
  assert.equal(countdown(-5_000), '0:00');
});

test('times are local', () => {
  const at = new Date(2026, 1, 3, 4, 5, 6).getTime();
  assert.equal(clockTime(at), '04:05:06');
  assert.equal(dateTime(at), '2026-02-03 04:05:06');
  assert.equal(shortTime(at, at + 1000), '04:05:06');
  assert.equal(shortTime(at, at + 48 * 3_600_000), '2026-02-03 04:05:06');
  assert.equal(duration(12.44), '12.4 s');
  assert.equal(duration(331.2), '5 min 31 s');
  assert.equal(duration(3_725), '1 h 02 min');
});

test('states and stalls have words, and an unknown name is shown as it came', () => {
  assert.equal(stallText('waiting for DC1'), 'waiting for START at the control (DC1)');
  assert.equal(stallText('CTS off'), 'CTS is off');
  assert.equal(stallText('stopped'), 'stopped by a person at a block end');
  assert.equal(stallText('something new'), 'something new');
  assert.equal(jobWording('odd' as never).text, 'odd');
  assert.equal(jobWording('interrupted').tone, 'bad');
});

test('reasons: causes become words, sentences stay', () => {
  assert.equal(reasonText('expired'), 'the arming expired');
  assert.equal(reasonText('held by DC3'), 'the control’s buffer is full (DC3)');
  assert.equal(reasonText('link_lost: between wire byte 1 and 2'), 'the link was lost: between wire byte 1 and 2');
  assert.equal(reasonText('reset confirmed by anna: all clear'), 'reset confirmed by anna: all clear');
  assert.equal(reasonText('other: text'), 'other: text');
  assert.equal(reasonText(''), '');
});

test('positions are intervals, and unknown ones say so', () => {
  assert.equal(placeText(12, 14), 'between lines 12 and 14');
  assert.equal(placeText(14, 14), 'in line 14');
  assert.equal(placeText(0, 14), 'at most up to line 14');
  assert.equal(placeText(0, 0), 'position not known');
});

test('the ledger claims no more than it knows', () => {
  const text = (low: number, high: number, known: 'clocked' | 'confirmed', ended: boolean) =>
    plain(intervalText({ low, high, known }, 1000, ended ? 'failed' : 'feeding'));
  assert.match(plain(intervalText({ low: 950, high: 950, known: 'clocked' }, 1000, 'done')), /^The program was sent to its end: 950 bytes passed/);
  assert.equal(text(0, 0, 'clocked', false), 'Nothing has been sent yet.');
  assert.equal(text(0, 0, 'clocked', true), 'Nothing was sent.');
  assert.equal(text(1000, 1000, 'clocked', true), 'All 1 000 bytes passed the line for certain.');
  assert.equal(
    text(400, 410, 'clocked', true),
    '400 bytes passed the line for certain; no more than 410 of 1 000 bytes can have left the server. The true count lies between the two.',
  );
  assert.match(text(400, 410, 'confirmed', true), /^400 bytes were acknowledged by the other side;/);
  assert.match(text(400, 400, 'clocked', true), /^400 bytes passed the line for certain, and no more/);
  for (const ended of [true, false]) assert.doesNotMatch(text(400, 410, 'clocked', ended), /execut/);
});

test("errors carry the server's sentence and its places", () => {
  const error = errorOfProblem(409, { title: 'refused', detail: 'the line is torn' });
  assert.equal(error.message, 'the line is torn');
  assert.equal(error.status, 409);
  const placed = errorOfProblem(422, { detail: 'bad', errors: [{ line: 3, column: 4, text: 'x' }, { pointer: '/minutes', text: 'y' }, { text: 'z' }] });
  assert.deepEqual(placed.details, ['line 3, column 4: x', '/minutes: y', 'z']);
  assert.equal(errorOfProblem(502, null).message, 'the server answered 502');
});

test('order keys differ', () => {
  globalThis.crypto ??= webcrypto as Crypto; // node 18 has it in the module only
  const keys = new Set(Array.from({ length: 100 }, newOrderKey));
  assert.equal(keys.size, 100);
  for (const key of keys) assert.match(key, /^[0-9a-f]{32}$/);
});

test('a whole machine gives the summary of the list', () => {
  const profile: MachineWhole['profile'] = { name: 'a', title: 'T', dialect: 'fanuc', kind: 'mill', axes: [], link: { url: 'pty:/x' } };
  const whole = { name: 'a', revision: 2, profile, status: statusOf() };
  assert.deepEqual(summaryOf(whole), { name: 'a', title: 'T', dialect: 'fanuc', kind: 'mill', link: 'pty:/x', revision: 2, status: statusOf() });
  assert.equal(summaryOf({ ...whole, profile: { ...profile, title: null } }).title, '');
});
