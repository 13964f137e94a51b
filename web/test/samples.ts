// Documents for the unit tests, each whole, with what a test changes.
import type { Alarm, Job, MachineItem, MachineStatus, Progress, Release } from '../src/api/types';

export const statusOf = (change: Partial<MachineStatus> = {}): MachineStatus => ({
  line: 'idle',
  stall: null,
  stop_wanted: false,
  link_error: null,
  link_error_id: null,
  link_error_said: null,
  link_note: null,
  link_note_id: null,
  plc: null,
  line_errors: { parity: 0, framing: 0, overrun: 0, breaks: 0 },
  job: null,
  handed: 0,
  clocked: 0,
  confirmed: 0,
  confirms: false,
  estimated: false,
  total: 0,
  block_from: 0,
  block: 0,
  holds: 0,
  hold_s: 0,
  line_use: 0,
  program: '',
  block_text: '',
  asks_since_ms: null,
  asks: 0,
  needs_confirmation: null,
  ...change,
});

export const machineOf = (name: string, change: Partial<MachineStatus> = {}): MachineItem => ({
  name,
  title: '',
  dialect: 'fanuc',
  kind: 'lathe',
  link: 'pty:/tmp/x',
  revision: 1,
  status: statusOf(change),
});

export const progressOf = (machine: string, change: Partial<MachineStatus> = {}): Progress => {
  const { needs_confirmation, ...report } = statusOf(change);
  void needs_confirmation;
  return { machine, ...report };
};

export const jobOf = (change: Partial<Job> = {}): Job => ({
  id: 1,
  state: 'queued',
  machine: 'a',
  order: null,
  release: 1,
  program: 1,
  revision: 1,
  sha256: 'ab'.repeat(32),
  delivery: 'drip',
  link: 'pty:/tmp/x',
  bytes: 1000,
  reason: '',
  reason_id: null,
  reason_said: null,
  rank: 0,
  created_by: 'mes',
  created_at_ms: 1,
  armed_by: null,
  armed_at_ms: null,
  expires_at_ms: null,
  started_at_ms: null,
  ended_at_ms: null,
  torn: false,
  needs_confirmation: false,
  confirmed_by: null,
  confirm_reason: null,
  read_back: null,
  read_back_state: null,
  ...change,
});

export const releaseOf = (change: Partial<Release> = {}): Release => ({
  id: 1,
  state: 'approved',
  program: 1,
  revision: 1,
  machine: 'a',
  delivery: 'drip',
  sha256: 'ab'.repeat(32),
  transfers_allowed: 0,
  transfers_done: 0,
  approved_by: null,
  sign_off: null,
  created_by: 'mes',
  created_at_ms: 1,
  changed_at_ms: 1,
  ...change,
});

export const alarmOf = (change: Partial<Alarm> = {}): Alarm => ({
  id: 1,
  machine: 'a',
  kind: 'link_lost',
  severity: 'warning',
  text: 'the link was lost',
  said: null,
  count: 1,
  raised_at_ms: 1_000,
  last_at_ms: 1_000,
  cleared_at_ms: null,
  acknowledged_by: null,
  acknowledged_at_ms: null,
  shelved_by: null,
  shelved_until_ms: null,
  shelf_reason: null,
  job: null,
  ...change,
});
