// The server's names of states, stalls and causes as words for people, with the tone that goes with them. A name that
// no catalogue has is shown as it came.
import type { Delivery, Job, JobState, OrderState, Outcome, ReceiptState, ReleaseState } from '../api/types';
import { t, wordOf } from '../i18n/i18n';
import { stallRow } from '../rules/lines';
import { kOrderTones } from '../rules/orders';
import { localText } from './local_text';
import { kOutcomeTones } from '../rules/verdicts';
import type { Tone } from './tones';

export interface Wording {
  text: string;
  tone: Tone;
}

const kJobTones: Record<JobState, Tone> = {
  queued: 'quiet',
  armed: 'ready',
  feeding: 'active',
  held: 'active',
  draining: 'active',
  done: 'good',
  failed: 'bad',
  cancelled: 'quiet',
  interrupted: 'bad',
};

const kReceiptTones: Record<ReceiptState, Tone> = {
  stored: 'ready',
  quarantined: 'bad',
  accepted: 'good',
  discarded: 'quiet',
};

export const kJobStates = Object.keys(kJobTones) as JobState[];
export const jobWording = (state: JobState): Wording => ({ text: wordOf('job_state', state), tone: kJobTones[state] ?? 'waiting' });
export const receiptWording = (state: ReceiptState): Wording => ({ text: wordOf('receipt_state', state), tone: kReceiptTones[state] ?? 'waiting' });
export const wordingOfOutcome = (outcome: Outcome): Wording => ({ text: wordOf('outcome', outcome), tone: kOutcomeTones[outcome] ?? 'waiting' });
export const orderWording = (state: OrderState): Wording => ({ text: wordOf('order_state', state), tone: kOrderTones[state] ?? 'waiting' });
export const releaseText = (state: ReleaseState): string => wordOf('release_state', state);
export const deliveryText = (delivery: Delivery): string => wordOf('delivery', delivery);
export const kDeliveries: Delivery[] = ['drip', 'memory'];
export const dialectText = (dialect: string): string => wordOf('dialect', dialect, dialect);

// A stall that this page does not know is shown as it came.
export function stallText(stall: string): string {
  const row = stallRow(stall);
  return row ? wordOf('stall', row.id) : stall;
}

// The reason of a job's move: a stall, the name of a cause with or without a sentence after it, or a sentence of the
// server, which stays as it is.
export function reasonText(reason: string): string {
  if (stallRow(reason)) return stallText(reason);
  const [, name, rest] = /^([a-z0-9_]+)(?:: ([^]*))?$/.exec(reason) ?? [];
  if (name === undefined) return reason;
  const cause = wordOf('cause', name, '');
  if (rest === undefined) return cause || name.replace(/_/g, ' ');
  return cause ? `${cause}: ${rest}` : reason;
}

// Why a job moved last. A sentence that no catalogue has is kept after the cause: it says what may have reached the
// control.
export function jobReason(job: Job): string {
  if (job.reason_said !== null) return localText(job.reason_said, reasonText(job.reason));
  const cause = job.reason_id === null ? '' : wordOf('cause', job.reason_id, '');
  if (cause === '') return reasonText(job.reason);
  if (job.reason === job.reason_id || job.reason === '') return cause;
  const [, rest] = /^[a-z0-9_]+: ([^]*)$/.exec(job.reason) ?? [];
  return `${cause}: ${rest ?? job.reason}`;
}

export const placeText = (from: number, to: number): string => {
  if (to <= 0) return t('position.unknown');
  if (from <= 0) return t('position.at_most', { line: to });
  return from === to ? t('position.line', { line: to }) : t('position.between', { from, to });
};
