// Documents for the unit tests, each whole, with what a test changes.
import type { Job, MachineItem, MachineStatus, Progress, Release } from '../src/api/types';

export const statusOf = (change: Partial<MachineStatus> = {}): MachineStatus => ({
  line: 'idle',
  stall: null,
  link_error: null,
  link_note: null,
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
  return { machine, ...report };
};

export const jobOf = (change: Partial<Job> = {}): Job => ({
  id: 1,
  state: 'queued',
  machine: 'a',
  release: 1,
  program: 1,
  revision: 1,
  sha256: 'ab'.repeat(32),
  delivery: 'drip',
  link: 'pty:/tmp/x',
  bytes: 1000,
  reason: '',
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
  created_by: 'mes',
  created_at_ms: 1,
  approved_by: null,
  sign_off: null,
  changed_at_ms: 1,
  ...change,
});
