// The documents of /api/v1 as this page reads them. Members that the page does not use are left out. Times are
// milliseconds since 1970; null where something has not happened.

export type Role = 'viewer' | 'operator' | 'programmer' | 'approver' | 'admin';

export interface Session {
  name: string;
  role: Role;
}

export type LineState = 'idle' | 'armed' | 'feeding' | 'held' | 'draining' | 'torn' | 'disconnected' | 'receiving' | 'answering';

// What the live progress of a machine carries: everything that changes while a program goes out. Counts are wire
// bytes; block_from and block are lines of the text, 0 where unknown.
export interface LineReport {
  line: LineState;
  stall: string | null;
  link_error: string | null;
  link_note: string | null;
  line_errors: { parity: number; framing: number; overrun: number; breaks: number };
  job: number | null;
  handed: number;
  clocked: number;
  confirmed: number;
  confirms: boolean;
  estimated: boolean;
  total: number;
  block_from: number;
  block: number;
  holds: number;
  hold_s: number;
  line_use: number;
  plc: PlcReport | null;
}

// What the machine's PLC says of it: 0 is none, or not known.
export interface PlcReport {
  state: string;
  program: number;
  line: number;
  alarm: number;
}

export interface TornBlock {
  job: number | null; // null: an answer to the operator, or another program on the line
  text: string;
}

export interface MachineStatus extends LineReport {
  program: string;
  block_text: string;
  needs_confirmation: TornBlock | null;
}

export interface MachineItem {
  name: string;
  title: string;
  dialect: string;
  kind: string;
  link: string;
  revision: number;
  status: MachineStatus;
}

// GET /machines/{name}: the whole profile in the place of its summary.
export interface MachineWhole {
  name: string;
  revision: number;
  profile: { title?: string; dialect?: string; kind?: string; link?: { url?: string } };
  status: MachineStatus;
}

export type Progress = LineReport & { machine: string };

export type Delivery = 'drip' | 'memory';

export type JobState =
  | 'queued'
  | 'armed'
  | 'feeding'
  | 'held'
  | 'draining'
  | 'done'
  | 'failed'
  | 'cancelled'
  | 'interrupted';

export interface Job {
  id: number;
  state: JobState;
  machine: string;
  release: number;
  program: number;
  revision: number;
  sha256: string;
  delivery: Delivery;
  link: string;
  bytes: number;
  reason: string;
  created_by: string;
  created_at_ms: number;
  armed_by: string | null;
  armed_at_ms: number | null;
  started_at_ms: number | null;
  ended_at_ms: number | null;
  torn: boolean;
  needs_confirmation: boolean;
  confirmed_by: string | null;
  confirm_reason: string | null;
  read_back?: string | null;
}

export interface Program {
  id: number;
  name: string;
  dialect: string;
  revision: number;
}

export type ReleaseState = 'draft' | 'in_review' | 'proving' | 'approved' | 'obsolete';

export interface Release {
  id: number;
  state: ReleaseState;
  program: number;
  revision: number;
  machine: string;
  delivery: Delivery;
  sha256: string;
  transfers_allowed: number;
  transfers_done: number;
  approved_by: string | null;
  sign_off: string | null;
  changed_at_ms: number;
}

export type ReceiptState = 'stored' | 'quarantined' | 'accepted' | 'discarded';

export interface StoredLikeness {
  program: number;
  revision: number;
  same: boolean;
  difference: string | null;
}

export interface Receipt {
  id: number;
  machine: string;
  at_ms: number;
  name: string;
  state: ReceiptState;
  reason: string | null;
  sha256: string;
  bytes: number;
  stored: StoredLikeness | null;
  program: number | null;
  revision: number | null;
  decided_by: string | null;
  decided_reason: string | null;
}

export interface LedgerRow {
  seq: number;
  at_ms: number;
  handed: number;
  clocked: number;
  confirmed: number;
  reserve: number;
  note: string;
}

export interface LedgerInterval {
  low: number;
  high: number;
  known: 'handed' | 'clocked' | 'confirmed';
}

export interface Page<T> {
  items: T[];
  next: string | null;
}

export interface Ledger extends Page<LedgerRow> {
  interval: LedgerInterval;
}

export interface Alarm {
  machine: string;
  text: string;
}

// application/problem+json.
export interface Problem {
  title: string;
  status: number;
  detail: string;
  errors?: { pointer?: string; line?: number; column?: number; text: string }[];
}
