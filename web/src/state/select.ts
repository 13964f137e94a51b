// What views ask of the state.
import type { Job, MachineStatus } from '../api/types';
import type { State } from './state';

export const newestFirst = (state: State): Job[] => [...state.jobs.values()].sort((a, b) => b.id - a.id);

export const statusOf = (state: State, machine: string): MachineStatus | null =>
  state.machines.get(machine)?.item.status ?? null;

export const isLive = (state: State): boolean => state.connection.phase === 'live';

export const programName = (state: State, id: number): string => state.programs.get(id) ?? `program ${id}`;

// Oldest first: the order in which they were queued.
export const queuedFor = (state: State, machine: string): Job[] =>
  [...state.jobs.values()].filter((job) => job.machine === machine && job.state === 'queued').sort((a, b) => a.id - b.id);
