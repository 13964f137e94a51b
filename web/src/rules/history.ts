// Sums of transfers that are over.
import type { Job, JobState } from '../api/types';

export const kEndedStates = ['done', 'failed', 'cancelled', 'interrupted'] as const satisfies readonly JobState[];
type EndedState = (typeof kEndedStates)[number];

// Seconds from its first byte to its end; null: it never fed.
export const durationOf = ({ started_at_ms, ended_at_ms }: Pick<Job, 'started_at_ms' | 'ended_at_ms'>): number | null =>
  started_at_ms === null || ended_at_ms === null ? null : Math.round((ended_at_ms - started_at_ms) / 100) / 10;

export interface Sums {
  states: Record<EndedState, number>;
  bytes: number; // of transfers that are done
  seconds: number; // of all that fed
}

export function sumsOf(jobs: readonly Job[]): Sums {
  const sums: Sums = { states: { done: 0, failed: 0, cancelled: 0, interrupted: 0 }, bytes: 0, seconds: 0 };
  for (const job of jobs) {
    const state = kEndedStates.find((one) => one === job.state);
    if (state) sums.states[state] += 1;
    if (job.state === 'done') sums.bytes += job.bytes;
    sums.seconds += durationOf(job) ?? 0;
  }
  return sums;
}
