// A server with the API that the page uses and machines that are only told about: for work on the page and for its own
// tests. It serves dist/ with the policy of the real server. An armed job is asked for after a moment, held once, and
// ends. Further routes under /mock change what it shows.
//   node test/mock_server.mjs [port] [--empty]      tokens: viewer, operator, admin
import { readFile } from 'node:fs/promises';
import http from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { jobsOf, linesOf, machinesOf, programs, receiptsOf, releases, textOf } from './mock_data.mjs';

const kPolicy =
  "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self' data:; font-src " +
  "'self'; form-action 'self'; base-uri 'none'; frame-ancestors 'none'";
const kTypes = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript; charset=utf-8', '.css': 'text/css; charset=utf-8', '.svg': 'image/svg+xml', '.map': 'application/json' };
const kTokens = { viewer: 'viewer', operator: 'operator', programmer: 'programmer', admin: 'admin' };
const dist = path.join(path.dirname(fileURLToPath(import.meta.url)), '..', 'dist');

export function startMock(port, { empty = false } = {}) {
  const now = Date.now();
  const machines = empty ? [] : machinesOf();
  const jobs = empty ? [] : jobsOf(now);
  const receipts = empty ? [] : receiptsOf(now);
  const ledgers = new Map();
  const sessions = new Map();
  const streams = new Set();
  const timers = new Set();
  let eventId = 0;
  let ring = [];

  const machine = (name) => machines.find((m) => m.name === name);
  const job = (id) => jobs.find((j) => j.id === id);
  const later = (ms, work) => {
    const timer = setTimeout(() => {
      timers.delete(timer);
      work();
    }, ms);
    timers.add(timer);
  };

  // --- events
  const send = (text) => streams.forEach((stream) => stream.write(text));
  const publish = (name, data) => {
    eventId += 1;
    const text = `id: ${eventId}\nevent: ${name}\ndata: ${JSON.stringify(data)}\n\n`;
    ring.push({ id: eventId, text });
    ring = ring.slice(-1024);
    send(text);
  };
  const progressText = (m) => {
    const { program, block_text, needs_confirmation, ...report } = m.status;
    return `event: progress\ndata: ${JSON.stringify({ machine: m.name, ...report })}\n\n`;
  };
  const move = (j, state, reason = '') => {
    j.state = state;
    j.reason = reason;
    if (state === 'armed') j.armed_at_ms = Date.now();
    if (state === 'feeding') j.started_at_ms ??= Date.now();
    if (['done', 'cancelled', 'failed'].includes(state)) j.ended_at_ms = Date.now();
    publish('job', j);
  };
  const line = (m, change) => {
    const before = m.status.line;
    Object.assign(m.status, change);
    send(progressText(m));
    if (m.status.line !== before) publish('machine', { name: m.name });
  };
  const note = (j, text) => {
    const rows = ledgers.get(j.id) ?? [];
    const { handed, clocked, confirmed } = machine(j.machine).status;
    rows.push({ seq: rows.length + 1, at_ms: Date.now(), handed, clocked, confirmed, reserve: handed + 2048, note: text });
    ledgers.set(j.id, rows);
  };

  // --- a transfer
  const kStep = 200;
  const feed = (j, m, held) => {
    if (j.state === 'cancelled') return;
    if (m.stopAsked) {
      m.stopAsked = false;
      line(m, { line: 'held', stall: 'stopped' });
      move(j, 'held', 'stopped');
      return;
    }
    if (m.status.stall) return;
    const handed = Math.min(m.status.handed + Math.ceil(m.status.total / 40), m.status.total);
    const clocked = Math.max(0, handed - 6);
    const lines = linesOf();
    const block = Math.min(lines.length, 1 + Math.floor((handed / m.status.total) * lines.length));
    line(m, { handed, clocked, confirmed: m.status.confirms ? clocked : 0, block_from: Math.max(1, block - 1), block, block_text: lines[block - 1] ?? '' });
    note(j, '');
    if (!held && handed > m.status.total / 2) {
      line(m, { line: 'held', stall: 'held by DC3', holds: m.status.holds + 1 });
      move(j, 'held', 'held by DC3');
      note(j, 'held by DC3');
      if (!m.holdForever) later(1500, () => release(j, m, true));
      return;
    }
    if (handed < m.status.total) return later(kStep, () => feed(j, m, held));
    line(m, { line: 'draining', clocked: handed });
    move(j, 'draining');
    later(600, () => {
      line(m, { line: 'idle', stall: null });
      note(j, 'done');
      move(j, 'done');
    });
  };
  const release = (j, m, held) => {
    if (j.state !== 'held') return;
    line(m, { line: 'feeding', stall: null, hold_s: m.status.hold_s + 1.5 });
    move(j, 'feeding');
    feed(j, m, held);
  };
  const arm = (j, who) => {
    const m = machine(j.machine);
    j.armed_by = who;
    line(m, { line: 'armed', stall: 'waiting for DC1', job: j.id, program: textOf(j.program), handed: 0, clocked: 0, confirmed: 0, total: j.bytes, block: 0, block_from: 0, block_text: '', holds: 0, hold_s: 0 });
    move(j, 'armed', 'armed');
    note(j, 'armed');
    later(m.startAfter ?? 1500, () => {
      if (j.state !== 'armed') return;
      line(m, { line: 'feeding', stall: null });
      move(j, 'feeding');
      feed(j, m, false);
    });
  };

  // --- answers
  const answer = (response, status, body, headers = {}) => {
    response.writeHead(status, { 'Content-Type': status >= 400 ? 'application/problem+json' : 'application/json', ...headers });
    response.end(body === null ? '' : JSON.stringify(body));
  };
  const problem = (response, status, detail) => answer(response, status, { type: 'about:blank', title: 'refused', status, detail });
  const list = (response, all, query) => {
    const limit = Number(query.get('limit') ?? 50);
    const begin = Number(query.get('after') ?? 0);
    const next = begin + limit < all.length ? String(begin + limit) : null;
    answer(response, 200, { items: all.slice(begin, begin + limit), next });
  };
  const caller = (request) => {
    const bearer = /^Bearer (.+)$/.exec(request.headers.authorization ?? '');
    if (bearer) return kTokens[bearer[1]];
    return sessions.get(/dripfeed_session=(\w+)/.exec(request.headers.cookie ?? '')?.[1]);
  };
  const summary = (m) => ({ name: m.name, title: m.title, dialect: m.dialect, kind: m.kind, link: m.link, revision: 1, status: m.status });
  const whole = (m) => ({ name: m.name, revision: 1, profile: { title: m.title, dialect: m.dialect, kind: m.kind, link: { url: m.link } }, status: m.status });

  const orders = {
    arm(response, j, _, who) {
      const m = machine(j.machine);
      if (j.state !== 'queued') return problem(response, 409, `job ${j.id} is ${j.state}, not queued`);
      if (m.status.line !== 'idle') return problem(response, 409, `${m.name} cannot be armed: the line is ${m.status.line}`);
      arm(j, who);
      return answer(response, 200, j);
    },
    stop(response, j) {
      machine(j.machine).stopAsked = true;
      answer(response, 200, j);
    },
    cancel(response, j) {
      const m = machine(j.machine);
      if (j.state !== 'queued') line(m, { line: 'idle', stall: null });
      move(j, 'cancelled', j.state === 'queued' ? 'cancelled' : 'person: the job was cancelled at a block end');
      answer(response, 200, j);
    },
    resume(response, j, body) {
      const m = machine(j.machine);
      if (m.status.stall === 'held by DC3' && !body.reason) return problem(response, 422, 'a reason is needed to go on as if DC1 had come');
      release(j, m, m.status.stall === 'held by DC3');
      return answer(response, 200, j);
    },
  };

  const api = async (request, response, parts, query, body) => {
    const who = caller(request);
    const get = request.method === 'GET';
    if (parts[0] === 'session' && request.method === 'POST') {
      if (!kTokens[body.token]) return problem(response, 401, 'this token is not valid');
      const value = Math.random().toString(36).slice(2);
      sessions.set(value, kTokens[body.token]);
      return answer(response, 204, null, { 'Set-Cookie': `dripfeed_session=${value}; Path=/; HttpOnly; SameSite=Strict` });
    }
    if (!who) return problem(response, 401, 'sign in with a token');
    if (parts[0] === 'session' && get) return answer(response, 200, { name: `${who}-1`, role: who });
    if (parts[0] === 'session') return answer(response, 204, null, { 'Set-Cookie': 'dripfeed_session=; Path=/; Max-Age=0' });
    if (!get && who === 'viewer') return problem(response, 403, 'this needs the role operator');
    if (parts[0] === 'machines' && parts.length === 1) return list(response, machines.map(summary), query);
    if (parts[0] === 'machines') {
      const m = machine(decodeURIComponent(parts[1]));
      if (!m) return problem(response, 404, 'there is no such machine');
      if (get) return answer(response, 200, whole(m));
      if (!m.status.needs_confirmation) return problem(response, 409, 'no torn block waits for a confirmation on this machine');
      const torn = job(m.status.needs_confirmation.job);
      Object.assign(torn, { needs_confirmation: false, confirmed_by: `${who}-1`, confirm_reason: body.reason });
      line(m, { line: 'idle', needs_confirmation: null });
      publish('job', torn);
      return answer(response, 200, m.status);
    }
    if (parts[0] === 'programs' && parts.length === 1) return list(response, programs, query);
    if (parts[0] === 'releases') return list(response, empty ? [] : releases(now), query);
    if (parts[0] === 'receipts' && get) return list(response, receipts, query);
    if (parts[0] === 'receipts') {
      const receipt = receipts.find((r) => r.id === Number(parts[1]));
      if (!['stored', 'quarantined'].includes(receipt.state)) return problem(response, 409, 'it was decided before');
      if (parts[2] === 'discard') Object.assign(receipt, { state: 'discarded', decided_by: `${who}-1`, decided_reason: body.reason });
      if (parts[2] === 'accept') Object.assign(receipt, { state: 'accepted', decided_by: `${who}-1`, program: body.program ?? 99, revision: (body.revision ?? 0) + 1 });
      return answer(response, 200, receipt);
    }
    if (parts[0] === 'events') return events(request, response);
    if (parts[0] !== 'jobs') return problem(response, 404, `there is nothing at ${request.url}`);
    if (parts.length === 1 && get) {
      const wanted = query.get('state');
      return list(response, jobs.filter((j) => !wanted || j.state === wanted).sort((a, b) => b.id - a.id), query);
    }
    if (parts.length === 1) {
      const release = releases(now).find((r) => r.id === body.release);
      if (release?.transfers_allowed && release.transfers_done >= release.transfers_allowed)
        return problem(response, 409, 'the transfers of this proving are used up');
      const added = { ...jobsOf(now)[0], id: Math.max(0, ...jobs.map((j) => j.id)) + 1, state: 'queued', reason: '', machine: release.machine, program: release.program, release: release.id, armed_by: null, armed_at_ms: null, started_at_ms: null, ended_at_ms: null, created_at_ms: Date.now(), created_by: `${who}-1` };
      jobs.push(added);
      publish('job', added);
      return answer(response, 201, added);
    }
    const j = job(Number(parts[1]));
    if (!j) return problem(response, 404, `there is no job ${parts[1]}`);
    if (parts[2] === 'ledger') {
      const rows = ledgers.get(j.id) ?? [];
      const last = rows.at(-1) ?? { clocked: j.started_at_ms ? Math.floor(j.bytes * 0.4) : 0, reserve: j.started_at_ms ? Math.floor(j.bytes * 0.4) + 10 : 0 };
      const over = j.state === 'done';
      const limit = Number(query.get('limit') ?? 50);
      const begin = Number(query.get('after') ?? 0);
      const next = begin + limit < rows.length ? String(begin + limit) : null;
      return answer(response, 200, { items: rows.slice(begin, begin + limit), next, interval: { low: over ? j.bytes : last.clocked, high: over ? j.bytes : last.reserve, known: 'clocked' } });
    }
    if (get) return answer(response, 200, j);
    return orders[parts[2]](response, j, body, `${who}-1`);
  };

  const events = (request, response) => {
    response.writeHead(200, { 'Content-Type': 'text/event-stream', 'Cache-Control': 'no-store' });
    const after = Number(request.headers['last-event-id'] ?? eventId);
    response.write(': hello\n\n');
    if (after > eventId) response.write(`id: ${eventId}\nevent: reset\ndata: {}\n\n`);
    ring.filter((e) => e.id > after && after <= eventId).forEach((e) => response.write(e.text));
    machines.forEach((m) => response.write(progressText(m)));
    streams.add(response);
    response.on('close', () => streams.delete(response));
  };

  // For tests: cut the streams, raise an alarm, tear a line, keep a hold, let an arming wait.
  const mock = (response, [what, name], query) => {
    const m = machine(name);
    if (what === 'cut') streams.forEach((stream) => stream.destroy());
    if (what === 'alarm') publish('alarm', { machine: name, text: 'the control asked for a program (DC1); nothing is armed, nothing was sent' });
    if (what === 'set') m[query.get('key')] = JSON.parse(query.get('value'));
    if (what === 'reset') send('event: reset\ndata: {}\n\n');
    answer(response, 200, { done: what });
  };

  const file = async (response, name) => {
    try {
      const body = await readFile(path.join(dist, name));
      response.writeHead(200, { 'Content-Type': kTypes[path.extname(name)], 'Content-Security-Policy': kPolicy, 'Cache-Control': 'no-cache', 'X-Content-Type-Options': 'nosniff' });
      response.end(body);
    } catch {
      problem(response, 404, 'there is no such file of the page');
    }
  };

  const server = http.createServer(async (request, response) => {
    const url = new URL(request.url, 'http://mock');
    const parts = url.pathname.split('/').slice(1);
    let text = '';
    for await (const piece of request) text += piece;
    if (parts[0] === '') return file(response, 'index.html');
    if (parts[0] === 'assets' && parts.length === 2) return file(response, path.join('assets', parts[1]));
    if (parts[0] === 'mock') return mock(response, parts.slice(1), url.searchParams);
    if (parts[0] === 'api' && parts[1] === 'v1') return api(request, response, parts.slice(2), url.searchParams, text ? JSON.parse(text) : {});
    return problem(response, 404, `there is nothing at ${request.url}`);
  });
  const heartbeat = setInterval(() => send(': alive\n\n'), 15_000);
  return new Promise((resolve) => {
    server.listen(port, '127.0.0.1', () => {
      const close = () => {
        clearInterval(heartbeat);
        timers.forEach(clearTimeout);
        streams.forEach((stream) => stream.destroy());
        server.closeAllConnections?.();
        return new Promise((closed) => server.close(closed));
      };
      resolve({ url: `http://127.0.0.1:${server.address().port}`, close });
    });
  });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { url } = await startMock(Number(process.argv[2] ?? 8099), { empty: process.argv.includes('--empty') });
  console.log(url);
}
