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

export const kGroupings = ['machine', 'part', 'day', 'shift'] as const;
export type Grouping = (typeof kGroupings)[number];

// Three of eight hours each, the first from six o'clock; the night's is of the day on which it began.
const kShiftHours = 8;
const kFirstShiftAt = 6;

const two = (value: number): string => String(value).padStart(2, '0');

const dayOf = (at: Date): string => `${at.getFullYear()}-${two(at.getMonth() + 1)}-${two(at.getDate())}`;

// "2026-11-26 06:00", its begin in local time.
export function shiftOf(at_ms: number): string {
  const at = new Date(at_ms);
  at.setHours(at.getHours() - kFirstShiftAt);
  const begin = kFirstShiftAt + Math.floor(at.getHours() / kShiftHours) * kShiftHours;
  return `${dayOf(at)} ${two(begin)}:00`;
}

export interface Group {
  name: string; // '': of none
  jobs: number;
  sums: Sums;
}

// `partOf`: by the order that a transfer belongs to. Days and shifts newest first, others by name.
export function groupsOf(jobs: readonly Job[], by: Grouping, partOf: (order: number | null) => string): Group[] {
  const names: Record<Grouping, (job: Job) => string> = {
    machine: ({ machine }) => machine,
    part: ({ order }) => partOf(order),
    day: ({ ended_at_ms }) => dayOf(new Date(ended_at_ms ?? 0)),
    shift: ({ ended_at_ms }) => shiftOf(ended_at_ms ?? 0),
  };
  const found = new Map<string, Job[]>();
  for (const job of jobs) {
    const name = names[by](job);
    found.set(name, [...(found.get(name) ?? []), job]);
  }
  const down = by === 'day' || by === 'shift' ? -1 : 1;
  return [...found]
    .map(([name, all]) => ({ name, jobs: all.length, sums: sumsOf(all) }))
    .sort((a, b) => down * a.name.localeCompare(b.name));
}
