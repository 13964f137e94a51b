// The event stream's format: whole, in pieces, with each kind of line end.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { EventParser } from '../src/live/event_stream';

const kStream =
  ': alive\n\nid: 7\nevent: job\ndata: {"id":3}\n\nevent: progress\ndata: {"machine":"a"}\n\nid: 8\nevent: reset\ndata: {}\n\n';
const kEvents = [
  { name: 'job', data: '{"id":3}' },
  { name: 'progress', data: '{"machine":"a"}' },
  { name: 'reset', data: '{}' },
];

test('reads events, skips comments, keeps the last id', () => {
  const parser = new EventParser();
  assert.deepEqual(parser.push(kStream), kEvents);
  assert.equal(parser.lastId, '8');
});

test('gives the same at every split and for every line end', () => {
  for (const end of ['\n', '\r\n', '\r']) {
    const text = kStream.replace(/\n/g, end) + (end === '\r' ? ':' : '');
    for (let split = 0; split <= text.length; ++split) {
      const parser = new EventParser();
      assert.deepEqual([...parser.push(text.slice(0, split)), ...parser.push(text.slice(split))], kEvents, `${JSON.stringify(end)} at ${split}`);
      assert.equal(parser.lastId, '8');
    }
    const parser = new EventParser();
    assert.deepEqual([...text].flatMap((one) => parser.push(one)), kEvents);
  }
});

test('an event without an id leaves the last id', () => {
  const parser = new EventParser();
  parser.push('id: 12\nevent: job\ndata: {}\n\nevent: progress\ndata: {}\n\n');
  assert.equal(parser.lastId, '12');
});

test('joins data lines, takes one blank after the colon, ignores what has no data', () => {
  const parser = new EventParser();
  assert.deepEqual(parser.push('data: a\ndata:  b\ndata\n\nevent: empty\n\ndata:c\n\n'), [
    { name: 'message', data: 'a\n b\n' },
    { name: 'message', data: 'c' },
  ]);
});

test('an unfinished event is none', () => {
  assert.deepEqual(new EventParser().push('event: job\ndata: {}\n'), []);
});

test('skips a byte order mark and an id with NUL', () => {
  const parser = new EventParser();
  assert.deepEqual(parser.push('\uFEFFdata: x\n\n'), [{ name: 'message', data: 'x' }]);
  parser.push('id: 3\nid: 4\0\ndata: y\n\n');
  assert.equal(parser.lastId, '3');
});
