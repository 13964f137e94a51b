// What follows from a line's status, for several views.
import type { MachineStatus } from '../api/types';

// A torn block survives a restart of the server in the store, when the line itself no longer shows it.
export const isTorn = (status: MachineStatus): boolean => status.line === 'torn' || status.needs_confirmation !== null;

// The line has its job now; afterwards `job` still names the last one.
export const hasJob = (status: MachineStatus): boolean =>
  status.job !== null && status.line !== 'idle' && status.line !== 'disconnected';

export const kArmMinutes = 10;

export const expiresAt = (armedAtMs: number): number => armedAtMs + kArmMinutes * 60_000;
