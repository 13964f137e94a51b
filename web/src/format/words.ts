// The server's names of states and stalls as words for people, with the tone that goes with them. A name that is not
// in a table is shown as it came: it is never hidden.
import type { Delivery, JobState, LineState, ReleaseState, Role } from '../api/types';

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

const kStalls: Record<string, string> = {
  waiting_for_dc1: 'waiting for DC1',
  held_by_dc3: 'held by DC3',
  cts_off: 'CTS off',
  peer_gone: 'peer gone',
  waiting_for_ledger: 'waiting for the ledger',
  waiting_for_text: 'waiting for the text',
  waiting_for_end: 'waiting for the control’s end sign',
  stopped_by_person: 'stopped by a person at a block end',
  held_by_person: 'stopped by a person at a block end',
  waiting_for_credit: 'waiting for room in the control’s buffer',
  waiting_for_receiver: 'waiting for the receiver',
  stopped: 'stopped: something does not fit, a person must look',
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

export const lineWording = (state: LineState): Wording => kLines[state] ?? unknown(state);
export const jobWording = (state: JobState): Wording => kJobs[state] ?? unknown(state);
export const releaseText = (state: ReleaseState): string => kReleases[state] ?? state;
export const deliveryText = (delivery: Delivery): string => kDeliveries[delivery] ?? delivery;
export const dialectText = (dialect: string): string => kDialects[dialect] ?? dialect;
export const roleText = (role: Role): string => role;

// Stalls come as "held_by_dc3" or as "held by DC3".
export const stallKey = (stall: string): string => stall.toLowerCase().replace(/[ -]/g, '_');
export const stallText = (stall: string): string => kStalls[stallKey(stall)] ?? stall.replace(/_/g, ' ');
