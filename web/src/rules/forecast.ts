// How long a transfer still takes, from what was seen of it: the wire bytes that passed, against the time since the
// start. It is given only after enough was seen, and never for a feed that a person stopped.
import type { Job, MachineStatus } from '../api/types';
import { stallKind } from './lines';

const kEnoughShare = 0.02;
const kEnoughMs = 5_000;

// Milliseconds, or null where nothing can be said.
export function timeLeftMs(status: MachineStatus, job: Job | null, nowMs: number): number | null {
  if (!job || job.started_at_ms === null || status.job !== job.id || status.total <= 0) return null;
  if (status.line !== 'feeding' && status.line !== 'held') return null;
  if (stallKind(status.stall) === 'person') return null;
  const seen = status.clocked / status.total;
  const took = nowMs - job.started_at_ms;
  if (seen < kEnoughShare || took < kEnoughMs) return null;
  return (took * (1 - seen)) / seen;
}
