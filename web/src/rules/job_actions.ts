// Which orders a job takes now, from its state and from what its machine's line says. As a table of conditions, apart
// from the buttons, so that it can be tested.
import type { Job, MachineStatus, Role } from '../api/types';
import { isTorn } from './lines';
import { atLeast } from './roles';

export type JobAction = 'arm' | 'disarm' | 'stop' | 'cancel' | 'withdraw' | 'resume' | 'resume_as_dc1';

export interface Offer {
  actions: JobAction[];
  because: string | null; // why a queued job cannot be armed now
}

const kNothing: Offer = { actions: [], because: null };

export function offerFor(job: Job, status: MachineStatus | null, role: Role, live: boolean): Offer {
  if (!atLeast(role, 'operator')) return kNothing;
  // Without live data nothing may be set in motion; to stop is allowed, the server knows the present state.
  const careful = (actions: JobAction[]): Offer => ({
    actions: live ? actions : actions.filter((a) => a === 'stop' || a === 'cancel' || a === 'disarm'),
    because: null,
  });
  if (job.state === 'queued') return queued(job, status, live);
  if (job.state === 'armed') return careful(['disarm']);
  if (job.state === 'feeding') return careful(['stop', 'cancel']);
  const stall = status?.job === job.id ? status.stall : null;
  if (job.state === 'held') {
    if (stall === 'stopped') return careful(['resume', 'cancel']);
    if (stall === 'held by DC3') return careful(['resume_as_dc1', 'stop', 'cancel']);
    return careful(['cancel']);
  }
  if (job.state === 'draining') return careful(stall === 'waiting for end' ? ['cancel'] : []);
  return kNothing;
}

function queued(job: Job, status: MachineStatus | null, live: boolean): Offer {
  if (!live) return { actions: [], because: 'no live connection' };
  if (!status) return { actions: ['withdraw'], because: `machine ${job.machine} is not known` };
  if (isTorn(status)) return { actions: ['withdraw'], because: 'the line is torn: confirm the reset first' };
  if (status.line === 'disconnected') return { actions: ['withdraw'], because: 'the line is disconnected' };
  if (status.line !== 'idle') return { actions: ['withdraw'], because: `the line is busy with job ${status.job}` };
  return { actions: ['arm', 'withdraw'], because: null };
}
