// The newest progress of each machine goes on a few times a second, everything else at once and in order.
import assert from 'node:assert/strict';
import { setTimeout as sleep } from 'node:timers/promises';
import { test } from 'node:test';
import { Distributor, type Heard } from '../src/live/distributor';

const progress = (machine: string, handed: number) => ({ name: 'progress', data: JSON.stringify({ machine, handed }) });

function gathering() {
  const heard: Heard[] = [];
  return { heard, distributor: new Distributor((one) => heard.push(one)) };
}

test('of each machine the newest counts', async () => {
  const { heard, distributor } = gathering();
  for (let i = 1; i <= 5; ++i) distributor.take(progress('a', i));
  distributor.take(progress('b', 1));
  assert.equal(heard.length, 0);
  await sleep(150);
  assert.deepEqual(heard, [{ news: [], progress: [{ machine: 'a', handed: 5 }, { machine: 'b', handed: 1 }] }]);
  await sleep(300);
  assert.equal(heard.length, 1);
});

test('other news goes at once, with the progress before it', () => {
  const { heard, distributor } = gathering();
  distributor.take(progress('a', 1));
  distributor.take({ name: 'job', data: '{"id":3}' });
  assert.deepEqual(heard, [{ news: [{ name: 'job', data: { id: 3 } }], progress: [{ machine: 'a', handed: 1 }] }]);
});

test('a hidden reader hears seldom, and at once when it is looked at', async () => {
  const { heard, distributor } = gathering();
  distributor.setVisible(false);
  distributor.take(progress('a', 1));
  await sleep(300);
  assert.equal(heard.length, 0);
  distributor.setVisible(true);
  assert.equal(heard.length, 1);
  distributor.stop();
});

test('what cannot be read changes nothing', async () => {
  const { heard, distributor } = gathering();
  distributor.take({ name: 'progress', data: 'no json' });
  distributor.take({ name: 'progress', data: '{}' });
  await sleep(150);
  assert.equal(heard.length, 0);
  distributor.take({ name: 'reset', data: '' });
  assert.deepEqual(heard[0]?.news, [{ name: 'reset', data: null }]);
});
