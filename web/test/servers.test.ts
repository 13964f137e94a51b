// Servers that share a store, and what may be done with their lines.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { ServerNode } from '../src/api/types';
import { linesOf, orderOf } from '../src/rules/servers';

const server = (name: string, change: Partial<ServerNode>, ...machines: string[]): ServerNode => ({
  name,
  this: false,
  url: `http://${name}`,
  version: '1.0.0',
  answers: true,
  started_at_ms: 0,
  seen_at_ms: 0,
  machines: machines.map((machine) => ({ name: machine, lease: 1, since_ms: 0, given_by: 'start', reason: null })),
  ...change,
});

test('the lines of all servers by machine, each with its server', () => {
  const lines = linesOf([server('a', {}, 'saw', 'lathe'), server('b', {}, 'mill'), server('c', {})]);
  assert.deepEqual(lines.map(({ name, server: { name: at } }) => [name, at]), [['lathe', 'a'], ['mill', 'b'], ['saw', 'a']]);
});

test('a line is handed over by who has it, and taken from who is not heard of', () => {
  const servers = [server('a', { this: true }, 'lathe'), server('b', {}, 'mill'), server('c', { answers: false }, 'saw')];
  assert.deepEqual(linesOf(servers).map((line) => orderOf(line, servers)), ['hand_over', null, 'take_over']);
  const alone = [server('a', { this: true }, 'lathe')];
  assert.deepEqual(linesOf(alone).map((line) => orderOf(line, alone)), [null]);
});
