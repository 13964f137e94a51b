// Sums of transfers that are over.
import type { HistorySums, Job, JobState } from '../api/types';

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

export const kGroupings = ['machine', 'part', 'day', 'shift'] as const;
export type Grouping = (typeof kGroupings)[number];

// How far back the sums reach, in days.
export const kRanges = [1, 7, 30, 365] as const;

// The start of a time that ends now; of whole minutes, so that it is the same for a while. Null: all that is known.
export const rangeBegin = (days: number | null, now_ms: number): number | null => (days === null ? null : now_ms - (now_ms % 60_000) - days * 86_400_000);

// How the time compares with what the checks expected: 1.25 for a quarter more. Null: no forecast.
export const againstForecast = ({ forecast_s, forecast_took_s }: Pick<HistorySums['all'], 'forecast_s' | 'forecast_took_s'>): number | null =>
  forecast_s > 0 ? forecast_took_s / forecast_s : null;
