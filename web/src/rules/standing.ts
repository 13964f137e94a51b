// Where a machine stands, as one word for people: what the line does, what a person must do, and how urgent that is.
// Every view takes it from here, so that none contradicts another.
import type { Job, MachineStatus } from '../api/types';
import type { Tone } from '../format/tones';
import { hasJob, isTorn, stallKind } from './lines';

export type StandingKey =
  | 'torn'
  | 'reset_suspected'
  | 'machine_alarm'
  | 'stopped'
  | 'lost_with_job'
  | 'failed'
  | 'end_unconfirmed'
  | 'waiting'
  | 'disconnected'
  | 'asks'
  | 'armed'
  | 'feeding'
  | 'draining'
  | 'receiving'
  | 'answering'
  | 'queued'
  | 'idle';

export interface Standing {
  key: StandingKey;
  tone: Tone;
  urgency: number; // higher first; from kNeedsPerson on a person must do something
}

export const kNeedsPerson = 50;

const kStandings = {
  torn: { key: 'torn', tone: 'bad', urgency: 100 },
  reset_suspected: { key: 'reset_suspected', tone: 'bad', urgency: 95 },
  machine_alarm: { key: 'machine_alarm', tone: 'bad', urgency: 90 },
  lost_with_job: { key: 'lost_with_job', tone: 'bad', urgency: 85 },
  stopped: { key: 'stopped', tone: 'waiting', urgency: 80 },
  failed: { key: 'failed', tone: 'bad', urgency: 75 },
  end_unconfirmed: { key: 'end_unconfirmed', tone: 'waiting', urgency: 72 },
  asks: { key: 'asks', tone: 'waiting', urgency: 70 },
  waiting: { key: 'waiting', tone: 'waiting', urgency: 60 },
  armed: { key: 'armed', tone: 'ready', urgency: 55 },
  disconnected: { key: 'disconnected', tone: 'waiting', urgency: 40 },
  answering: { key: 'answering', tone: 'ready', urgency: 32 },
  receiving: { key: 'receiving', tone: 'active', urgency: 30 },
  draining: { key: 'draining', tone: 'active', urgency: 25 },
  feeding: { key: 'feeding', tone: 'active', urgency: 20 },
  queued: { key: 'queued', tone: 'quiet', urgency: 10 },
  idle: { key: 'idle', tone: 'quiet', urgency: 0 },
} satisfies { [Key in StandingKey]: Standing & { key: Key } };

// What it needs of a machine's status.
export type StandingNow = Pick<MachineStatus, 'line' | 'stall' | 'job' | 'needs_confirmation' | 'asks_since_ms'> & {
  plc_alarm: number;
};

// The same object for the same standing. `ended`: the job whose end a person has not confirmed.
export const standingOf = (now: StandingNow, job: Job | null, queued: number, ended: Job | null = null): Standing => kStandings[keyOf(now, job, queued, ended)];

function keyOf(status: StandingNow, job: Job | null, queued: number, ended: Job | null): StandingKey {
  if (isTorn(status)) return 'torn';
  if (stallKind(status.stall) === 'reset') return 'reset_suspected';
  if (status.line === 'disconnected') return isUnfinished(job) ? 'lost_with_job' : 'disconnected';
  if (hasJob(status)) return onLine(status);
  if (status.line === 'receiving' || status.line === 'answering') return status.line;
  if (status.plc_alarm > 0) return 'machine_alarm';
  if (job && (job.state === 'failed' || job.state === 'interrupted')) return 'failed';
  if (ended) return 'end_unconfirmed';
  if (status.asks_since_ms !== null) return 'asks';
  return queued > 0 ? 'queued' : 'idle';
}

const isUnfinished = (job: Job | null): boolean => job !== null && job.ended_at_ms === null && job.state !== 'queued';

function onLine(status: StandingNow): StandingKey {
  const kind = stallKind(status.stall);
  if (kind === 'person') return 'stopped';
  if (status.plc_alarm > 0) return 'machine_alarm';
  if (status.line === 'armed') return 'armed';
  if (status.line === 'draining') return 'draining';
  if (status.line === 'receiving' || status.line === 'answering') return status.line;
  // A full buffer is the normal state of drip feeding. Other waits are shown as such.
  return status.line === 'held' && kind !== 'normal' ? 'waiting' : 'feeding';
}
