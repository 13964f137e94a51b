// What follows from a line's status, for several views.
import type { MachineStatus, Stall } from '../api/types';

// A torn block survives a restart of the server in the store, when the line itself no longer shows it.
export const isTorn = (status: Pick<MachineStatus, 'line' | 'needs_confirmation'>): boolean => status.line === 'torn' || status.needs_confirmation !== null;

// The line has its job now; afterwards `job` still names the last one.
export const hasJob = (status: Pick<MachineStatus, 'line' | 'job'>): boolean =>
  status.job !== null && status.line !== 'idle' && status.line !== 'disconnected';

// What a stall asks for. 'normal': what happens in every drip feed, for a moment or for minutes, and is no fault: the
// control's buffer is full, or the books follow.
export type StallKind = 'normal' | 'person' | 'reset' | 'wait';

interface StallRow {
  id: string; // of its words in the catalogue
  kind: StallKind;
}

// All that the server can send: one that is missing here does not compile.
const kStalls: Record<Stall, StallRow> = {
  'waiting for DC1': { id: 'waiting_for_dc1', kind: 'wait' },
  'held by DC3': { id: 'held_by_dc3', kind: 'normal' },
  'CTS off': { id: 'cts_off', kind: 'wait' },
  'DSR off': { id: 'dsr_off', kind: 'wait' },
  'peer gone': { id: 'peer_gone', kind: 'wait' },
  'waiting for ledger': { id: 'waiting_for_ledger', kind: 'normal' },
  'waiting for text': { id: 'waiting_for_text', kind: 'normal' },
  'waiting for end': { id: 'waiting_for_end', kind: 'wait' },
  stopped: { id: 'stopped_by_person', kind: 'person' },
  'stopped, and the control asked again: it may have been reset': { id: 'reset_suspected', kind: 'reset' },
  'held below': { id: 'held_below', kind: 'normal' },
  'waiting for trigger': { id: 'waiting_for_trigger', kind: 'wait' },
  "waiting for the receiver's start": { id: 'waiting_for_receivers_start', kind: 'wait' },
  'waiting for the receiver': { id: 'waiting_for_receiver', kind: 'normal' },
  'waiting for ACK': { id: 'waiting_for_ack', kind: 'normal' },
  "waiting for the end's ACK": { id: 'waiting_for_ack', kind: 'normal' },
  'the partner sends': { id: 'partner_sends', kind: 'wait' },
  'waiting for receiver': { id: 'waiting_for_receiver', kind: 'normal' },
  'waiting for credit': { id: 'waiting_for_credit', kind: 'normal' },
  'stopped by a fault': { id: 'stopped_by_a_fault', kind: 'wait' },
  'machine held': { id: 'machine_held', kind: 'wait' },
  'machine alarm': { id: 'machine_alarm', kind: 'wait' },
  'machine in emergency stop': { id: 'machine_in_emergency_stop', kind: 'wait' },
  'folder does not answer': { id: 'folder_does_not_answer', kind: 'wait' },
  'holding the control: what it sent before is not taken yet': { id: 'holding_the_control', kind: 'wait' },
  'waiting for the sender': { id: 'waiting_for_sender', kind: 'wait' },
};

// Null for a name that this page does not know.
export const stallRow = (stall: string): StallRow | null => (Object.hasOwn(kStalls, stall) ? kStalls[stall as Stall] : null);

// An unknown one is a wait that a person should look at.
export const stallKind = (stall: string | null): StallKind | null => (stall === null ? null : (stallRow(stall)?.kind ?? 'wait'));

export const kArmMinutes = 10;
