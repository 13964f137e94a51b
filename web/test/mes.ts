// What a MES does, written with the types that `npm run schema` makes of the description and openapi-fetch: an order, its program, the
// check, the release, a job. A person arms it; the control draws it. tests/e2e/mes.py runs it against a server and a simulated control.
import createClient from 'openapi-fetch';
import type { components, paths } from '../src/api/schema';

type Schemas = components['schemas'];

const url = process.env.DRIPFEED_URL ?? '';
const text = process.env.PROGRAM ?? '';

// A caller with a token of their own: each step below is done by whoever does it in a shop.
const caller = (name: string) => createClient<paths>({ baseUrl: url, headers: { Authorization: `Bearer ${process.env[`TOKEN_${name}`] ?? ''}` } });
const mes = caller('MES');
const programmer = caller('PROGRAMMER');
const approver = caller('APPROVER');
const operator = caller('OPERATOR');

interface Answer<T> {
  data?: T;
  error?: unknown;
  response: Response;
}

function expect(condition: boolean, sentence: string): asserts condition {
  if (!condition) throw new Error(sentence);
}

// The document of an answer that has to be good.
async function must<T>(what: string, call: Promise<Answer<T>>): Promise<T> {
  const { data, error, response } = await call;
  expect(data !== undefined, `${what}: ${response.status} ${JSON.stringify(error)}`);
  return data;
}

async function refused(what: string, code: Schemas['Problem']['code'], call: Promise<Answer<unknown> & { error?: Schemas['Problem'] }>): Promise<void> {
  const { error } = await call;
  expect(error?.code === code, `${what}: the code is ${error?.code ?? 'none'}, not ${code}`);
}

const job = (id: number) => must('the job', mes.GET('/api/v1/jobs/{id}', { params: { path: { id: String(id) } } }));
const orderOf = (id: number) => must('the order', mes.GET('/api/v1/orders/{id}', { params: { path: { id: String(id) } } }));

const pause = (ms: number) =>
  new Promise<void>((go) => {
    setTimeout(go, ms);
  });

async function waitFor<T>(what: string, ask: () => Promise<T | null>): Promise<T> {
  for (const until = Date.now() + 60_000; Date.now() < until; await pause(100)) {
    const found = await ask();
    if (found !== null) return found;
  }
  throw new Error(`waited a minute for ${what}`);
}

// The same request twice, as after an answer that was lost: it is one order.
async function addOrder(): Promise<Schemas['Order']> {
  const body: Schemas['NewOrder'] = { number: '4711', operation: '20', part: 'HUB-12', quantity: 5, machine: 'lathe' };
  const params = { header: { 'Idempotency-Key': 'order 4711/20' } };
  const first = await must('the order', mes.POST('/api/v1/orders', { body, params }));
  const again = await must('the order again', mes.POST('/api/v1/orders', { body, params }));
  expect(first.id === again.id && first.state === 'open', `two orders: ${first.id}, ${again.id}`);
  return first;
}

async function releaseProgram(): Promise<Schemas['Release']> {
  const program = await must('the program', programmer.POST('/api/v1/programs', { body: { name: 'O0042', dialect: 'fanuc', text } }));
  const of = { program: program.id, machine: 'lathe' };
  const draft = await must('the release', programmer.POST('/api/v1/releases', { body: of }));
  const move = (who: typeof mes, body: Schemas['ReleaseMove']) =>
    who.POST('/api/v1/releases/{id}/transitions', { params: { path: { id: String(draft.id) } }, body });
  await refused('a hand-in without a check', 'no_verdict', move(programmer, { to: 'in_review' }));
  const verdict = await must('the check', programmer.POST('/api/v1/checks', { body: of }));
  expect(verdict.verdict !== 'fail', `the verdict is ${verdict.verdict}`);
  if (verdict.verdict !== 'pass') {
    const params = { path: { id: String(verdict.id) } };
    await must('the waiver', approver.POST('/api/v1/checks/{id}/waivers', { params, body: { reason: 'seen by the approver' } }));
  }
  await must('the hand-in', move(programmer, { to: 'in_review' }));
  return must('the proving', move(approver, { to: 'proving', transfers: 1 }));
}

async function feed(release: number, order: number): Promise<void> {
  const queued = await must('the job', mes.POST('/api/v1/jobs', { body: { release, order }, params: { header: { 'Idempotency-Key': `job of ${order}` } } }));
  expect((await orderOf(order)).waiting === 1, 'the order does not know its job');
  const params = { path: { id: String(queued.id) } };
  await refused('a MES that arms', 'scope_missing', mes.POST('/api/v1/jobs/{id}/arm', { params, body: {} }));
  await waitFor('an idle line', async () => {
    const machine = await must('the machine', mes.GET('/api/v1/machines/{name}', { params: { path: { name: 'lathe' } } }));
    return machine.status.line === 'idle' ? machine : null;
  });
  expect((await job(queued.id)).state === 'queued', 'a job was armed, and nobody did');
  const armed = await must('the arming', operator.POST('/api/v1/jobs/{id}/arm', { params, body: {} }));
  expect(armed.armed_by === 'the operator', `armed by ${armed.armed_by ?? 'nobody'}`);
  const ended = await waitFor('the end of the job', async () => {
    const now = await job(queued.id);
    return now.ended_at_ms === null ? null : now;
  });
  expect(ended.state === 'done', `the job is ${ended.state}: ${ended.reason}`);
}

async function finish(release: number, order: number): Promise<void> {
  const params = { path: { id: String(release) } };
  await refused('an approval without a note', 'sign_off_missing', approver.POST('/api/v1/releases/{id}/transitions', { params, body: { to: 'approved' } }));
  const body: Schemas['ReleaseMove'] = { to: 'approved', note: 'first part measured' };
  await refused('an approval without an operator', 'not_signed_off', approver.POST('/api/v1/releases/{id}/transitions', { params, body }));
  await refused('a sign-off by the MES', 'scope_missing', mes.POST('/api/v1/releases/{id}/sign-off', { params, body: { note: 'it will do' } }));
  const proved = await must('the sign-off', operator.POST('/api/v1/releases/{id}/sign-off', { params, body: { note: 'all sizes good' } }));
  expect(proved.state === 'proving' && proved.proved_by === 'the operator' && proved.proof === 'all sizes good', JSON.stringify(proved));
  const approved = await must('the approval', approver.POST('/api/v1/releases/{id}/transitions', { params, body }));
  expect(approved.state === 'approved' && approved.approved_by === 'the approver' && approved.transfers_done === 1, JSON.stringify(approved));
  const path = { id: String(order) };
  await must('the parts', mes.POST('/api/v1/orders/{id}/parts', { params: { path }, body: { good: 5 } }));
  const done = await must('the end of the order', mes.POST('/api/v1/orders/{id}/move', { params: { path }, body: { to: 'done' } }));
  expect(done.state === 'done' && done.good === 5 && done.open === 0 && done.transfers === 1 && done.waiting === 0, JSON.stringify(done));
}

const order = await addOrder();
const release = await releaseProgram();
await feed(release.id, order.id);
await finish(release.id, order.id);
process.stdout.write(`order ${order.number}: done\n`);
