// What the mock server tells of: machines in each state of a line, jobs, programs and releases.

const status = (change) => ({
  line: 'idle', stall: null, link_error: null, link_note: null, plc: null, line_errors: { parity: 0, framing: 0, overrun: 0, breaks: 0 }, job: null, handed: 0, clocked: 0, confirmed: 0, confirms: false,
  estimated: false, total: 0, block_from: 0, block: 0, holds: 0, hold_s: 0, line_use: 0, program: '', block_text: '',
  needs_confirmation: null, ...change,
});

export const linesOf = () => {
  const lines = ['%', 'O0100 (ROLL R-100)', 'G21 G40 G80 G99', 'T0606', 'G97 S500 M3'];
  for (let i = 0; i < 1980; ++i) lines.push(`N${(i + 6) * 10} G1 X${(206.4 + i * 0.013).toFixed(3)} Z${(98 - i * 0.099).toFixed(3)} F0.15`);
  return [...lines, 'G0 X260.', 'M30', '%'];
};

export const machinesOf = () => [
  { name: 'lathe-1', title: 'Roll lathe, hall 2', dialect: 'fanuc', kind: 'lathe', link: 'serial:/dev/ttyS0?baud=9600&framing=7E2&flow=xonxoff', status: status({}) },
  { name: 'mill-2', title: 'Machining center', dialect: 'sinumerik-840d', kind: 'mill', link: 'tcp://192.0.2.17:4001',
    status: status({ line: 'feeding', job: 41, handed: 81_240, clocked: 81_198, total: 212_480, estimated: true, block_from: 2401, block: 2403, holds: 3, hold_s: 12.4, line_use: 0.97, program: 'POCKET_12', block_text: 'N24030 G1 X118.402 Y-33.871 Z-4.5' }) },
  { name: 'mill-3', title: '', dialect: 'mitsubishi-m80', kind: 'mill', link: 'modbus-tcp://192.0.2.30/1',
    status: status({ line: 'held', stall: 'held by DC3', job: 39, handed: 9_800, clocked: 9_800, confirmed: 9_216, confirms: true, total: 18_300, block: 0, holds: 17, hold_s: 331.2, program: 'O8001', block_text: 'N1400 G2 X40. Y12.5 I-8. J0.' }) },
  { name: 'lathe-4', title: 'Shaft lathe', dialect: 'sinumerik-810d', kind: 'lathe', link: 'serial:/dev/ttyS3?baud=19200&framing=8N1&flow=rtscts',
    status: status({ line: 'torn', job: 38, handed: 40_130, clocked: 40_122, total: 96_012, block_from: 1187, block: 1188, program: 'SHAFT_7', block_text: 'N11880 G1 X48.25 Z-211.4',
      needs_confirmation: { job: 38, text: 'link_lost: between wire byte 40122 and 40130 of 96012 may have reached the control (line 1187 to 1188); a block is torn: reset the control and confirm it' } }) },
  { name: 'lathe-5', title: 'Old lathe behind the gate', dialect: 'mazak', kind: 'lathe', link: 'rfc2217://192.0.2.44:2217?baud=4800',
    status: status({ line: 'disconnected', stall: 'peer gone', link_error: 'connect to 192.0.2.44:2217: connection refused' }) },
];

export const programs = [
  { id: 1, name: 'O0100', dialect: 'fanuc', revision: 3 },
  { id: 2, name: 'POCKET_12', dialect: 'sinumerik-840d', revision: 1 },
  { id: 3, name: 'O8001', dialect: 'mitsubishi-m80', revision: 5 },
  { id: 4, name: 'SHAFT_7', dialect: 'sinumerik-810d', revision: 2 },
];
export const textOf = (id) => programs.find((p) => p.id === id)?.name ?? '';

const kHash = '9f2c41d07be5a86c3310ee94b7ac0f5d6c1182e93ab47f60d5521c08e7ba94f1';
const job = (now, change) => ({
  id: 42, state: 'queued', machine: 'lathe-1', release: 7, program: 1, revision: 3, sha256: kHash, delivery: 'drip',
  link: 'serial:/dev/ttyS0?baud=9600&framing=7E2&flow=xonxoff', bytes: 61_404, reason: '', created_by: 'mes',
  created_at_ms: now - 25 * 60_000, armed_by: null, armed_at_ms: null, started_at_ms: null, ended_at_ms: null,
  torn: false, needs_confirmation: false, confirmed_by: null, confirm_reason: null, ...change,
});

export const jobsOf = (now) => {
  const ran = (minutes, change) => ({
    armed_by: 'operator-1', created_at_ms: now - (minutes + 9) * 60_000, armed_at_ms: now - minutes * 60_000,
    started_at_ms: now - (minutes - 1) * 60_000, ...change,
  });
  const old = [];
  for (let id = 1; id < 38; ++id) {
    const minutes = 60 + (38 - id) * 53;
    old.push(job(now, { id, state: id % 9 === 4 ? 'cancelled' : 'done', reason: id % 9 === 4 ? 'expired' : '', ...ran(minutes), ended_at_ms: now - (minutes - 30) * 60_000 }));
  }
  return [
    job(now, {}),
    job(now, { id: 43, created_by: 'operator-1', created_at_ms: now - 4 * 60_000 }),
    job(now, { id: 41, state: 'feeding', machine: 'mill-2', program: 2, revision: 1, bytes: 212_480, link: 'tcp://192.0.2.17:4001', ...ran(12) }),
    job(now, { id: 40, state: 'failed', machine: 'lathe-5', program: 1, reason: 'nak: between wire byte 1200 and 1212 of 61404 may have reached the control (line 40 to 41)', ...ran(50), ended_at_ms: now - 44 * 60_000 }),
    job(now, { id: 39, state: 'held', machine: 'mill-3', program: 3, revision: 5, bytes: 18_300, link: 'modbus-tcp://192.0.2.30/1', reason: 'held by DC3', ...ran(31) }),
    job(now, { id: 38, state: 'failed', machine: 'lathe-4', program: 4, revision: 2, bytes: 96_012, torn: true, needs_confirmation: true, reason: 'link_lost: between wire byte 40122 and 40130 of 96012 may have reached the control (line 1187 to 1188); a block is torn: reset the control and confirm it', ...ran(70), ended_at_ms: now - 61 * 60_000 }),
    ...old,
  ];
};

export const releases = (now) => {
  const release = (change) => ({
    id: 7, state: 'approved', program: 1, revision: 3, machine: 'lathe-1', delivery: 'drip', sha256: kHash,
    transfers_allowed: 0, transfers_done: 0, created_by: 'mes', created_at_ms: now - 90 * 3_600_000, approved_by: 'approver-1',
    sign_off: 'first part measured', changed_at_ms: now - 80 * 3_600_000, ...change,
  });
  return [
    release({ id: 9, state: 'draft', approved_by: null, sign_off: null }),
    release({ id: 8, state: 'proving', program: 2, revision: 1, machine: 'mill-2', transfers_allowed: 2, transfers_done: 2, approved_by: null, sign_off: null }),
    release({}),
    release({ id: 6, program: 3, revision: 5, machine: 'mill-3', delivery: 'memory' }),
    release({ id: 5, state: 'obsolete', program: 4, revision: 1, machine: 'lathe-4' }),
  ];
};

// What controls punched: one that differs from the stored program, one that is new, one torn.
export const receiptsOf = (now) => [
  { id: 3, machine: 'lathe-1', at_ms: now - 60_000, name: 'O0008', state: 'quarantined', reason: 'its end is missing', sha256: 'c'.repeat(64), bytes: 118, stored: null, program: null, revision: null, decided_by: null, decided_reason: null },
  { id: 2, machine: 'lathe-1', at_ms: now - 120_000, name: 'O0007', state: 'stored', reason: null, sha256: 'b'.repeat(64), bytes: 402, stored: { program: 7, revision: 2, same: false, difference: 'line 3, column 4: expected "1.", found "2."' }, program: null, revision: null, decided_by: null, decided_reason: null },
  { id: 1, machine: 'mill-2', at_ms: now - 180_000, name: 'O0100', state: 'stored', reason: null, sha256: 'a'.repeat(64), bytes: 90, stored: null, program: null, revision: null, decided_by: null, decided_reason: null },
];
