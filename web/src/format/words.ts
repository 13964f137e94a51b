// The server's names of states and stalls as words for people, with the tone that goes with them. A name that is not
// in a table is shown as it came: it is never hidden.
import type { Delivery, JobState, LineState, ReceiptState, ReleaseState, Stall } from '../api/types';

// What a state asks of the reader; the look of it is in the style sheet, and an icon goes with each.
export type Tone = 'quiet' | 'ready' | 'active' | 'waiting' | 'good' | 'bad';

export interface Wording {
  text: string;
  tone: Tone;
}

const kLines: Record<LineState, Wording> = {
  idle: { text: 'idle', tone: 'quiet' },
  armed: { text: 'armed', tone: 'ready' },
  feeding: { text: 'feeding', tone: 'active' },
  held: { text: 'held', tone: 'waiting' },
  draining: { text: 'draining', tone: 'active' },
  torn: { text: 'torn', tone: 'bad' },
  disconnected: { text: 'disconnected', tone: 'waiting' },
  receiving: { text: 'receiving', tone: 'active' },
  answering: { text: 'answering', tone: 'ready' },
};

const kJobs: Record<JobState, Wording> = {
  queued: { text: 'queued', tone: 'quiet' },
  armed: { text: 'armed', tone: 'ready' },
  feeding: { text: 'feeding', tone: 'active' },
  held: { text: 'held', tone: 'waiting' },
  draining: { text: 'draining', tone: 'active' },
  done: { text: 'done', tone: 'good' },
  failed: { text: 'failed', tone: 'bad' },
  cancelled: { text: 'cancelled', tone: 'quiet' },
  interrupted: { text: 'interrupted', tone: 'bad' },
};

const kStalls: Record<Stall, string> = {
  'waiting for DC1': 'waiting for DC1',
  'held by DC3': 'held by DC3',
  'CTS off': 'CTS off',
  'DSR off': 'DSR off',
  'peer gone': 'peer gone',
  'waiting for ledger': 'waiting for the ledger',
  'waiting for text': 'waiting for the text',
  'waiting for end': 'waiting for the control’s end sign',
  stopped: 'stopped by a person at a block end',
  'stopped, and the control asked anew: it may have been reset':
    'stopped, and the control asked anew: it may have been reset',
  'held below': 'held by the system’s driver or the device server',
  'waiting for trigger': 'waiting for the control’s trigger',
  "waiting for the receiver's start": 'waiting for the receiver’s start',
  'waiting for the receiver': 'waiting for the receiver',
  'waiting for ACK': 'waiting for ACK',
  "waiting for the end's ACK": 'waiting for the end’s ACK',
  'the partner sends': 'the partner sends',
  'waiting for receiver': 'waiting for the receiver',
  'waiting for credit': 'waiting for room in the control’s buffer',
  'stopped by a fault': 'stopped: something does not fit, a person must look',
  'machine held': 'the machine is held (feed hold)',
  'machine alarm': 'the machine has an alarm',
  'machine in emergency stop': 'the machine is in emergency stop',
  'folder does not answer': 'the folder does not answer',
  'holding the control: what it sent before is not taken yet':
    'holding the control: what it sent before is not taken yet',
  'waiting for the sender': 'waiting for the sender',
};
const isStall = (name: string): name is Stall => Object.hasOwn(kStalls, name);

// Why a job ended: a protocol's cause.
const kCauses: Record<string, string> = {
  dc1: 'DC1 came',
  dc3: 'DC3 came',
  eot: 'EOT came',
  quiet: 'the line was quiet',
  syn: 'SYN came: the control was reset',
  nak: 'NAK came: the control has an alarm',
  unexpected_input: 'unexpected input came from the control',
  link_lost: 'the link was lost',
  dsr_off: 'DSR went off',
  cts_off: 'CTS went off',
  expired: 'the arming expired',
  person: 'by order of a person',
  text_lost: 'the stored text could not be read',
  bad_character: 'a character that the line’s code cannot carry',
  foreign_registers: 'the registers are not a mailbox',
  session_over: 'the receiver ended the session',
  session_running: 'another session runs in the receiver',
  other_session: 'another session took the mailbox',
  receiver_restarted: 'the receiver was restarted',
  out_of_step: 'the receiver is out of step',
  text_differs: 'the receiver has another text',
  refused: 'the receiver refused',
  receiver_error: 'the receiver reports an error',
  peer_gone: 'the receiver does not answer',
};

const kReleases: Record<ReleaseState, string> = {
  draft: 'draft',
  in_review: 'in review',
  proving: 'proving',
  approved: 'approved',
  obsolete: 'obsolete',
};

const kDeliveries: Record<Delivery, string> = { drip: 'drip-feed', memory: 'memory load' };

const kDialects: Record<string, string> = {
  fanuc: 'FANUC',
  mazak: 'Mazak',
  'mitsubishi-m80': 'Mitsubishi M80',
  'sinumerik-840d': 'SINUMERIK 840D',
  'sinumerik-810d': 'SINUMERIK 810D',
};

const unknown = (name: string): Wording => ({ text: name, tone: 'waiting' });

const kReceipts: Record<ReceiptState, Wording> = {
  stored: { text: 'waits for a decision', tone: 'ready' },
  quarantined: { text: 'in quarantine', tone: 'bad' },
  accepted: { text: 'accepted', tone: 'good' },
  discarded: { text: 'discarded', tone: 'quiet' },
};
export const receiptWording = (state: ReceiptState): Wording => kReceipts[state] ?? unknown(state);

export const lineWording = (state: LineState): Wording => kLines[state] ?? unknown(state);
export const jobWording = (state: JobState): Wording => kJobs[state] ?? unknown(state);
export const releaseText = (state: ReleaseState): string => kReleases[state] ?? state;
export const deliveryText = (delivery: Delivery): string => kDeliveries[delivery] ?? delivery;
export const dialectText = (dialect: string): string => kDialects[dialect] ?? dialect;

export const stallText = (stall: Stall): string => kStalls[stall] ?? stall;

// The reason of a job's move: the name of a stall, the name of a cause with or without a sentence behind it, or a
// sentence of the server, which stays as it is.
export function reasonText(reason: string): string {
  if (isStall(reason)) return kStalls[reason];
  const [, name, rest] = /^([a-z0-9_]+)(?:: ([^]*))?$/.exec(reason) ?? [];
  if (name === undefined) return reason;
  if (rest !== undefined) return kCauses[name] ? `${kCauses[name]}: ${rest}` : reason;
  return kCauses[name] ?? reason.replace(/_/g, ' ');
}
