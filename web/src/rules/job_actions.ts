// Which orders a job takes now, from its state and from what its machine's line says. As a table of conditions, apart
// from the buttons, so that it can be tested.
import type { Job, MachineStatus, Role } from '../api/types';
import { dateTime } from '../format/times';
import { isTorn, stallKind } from './lines';
import { atLeast } from './roles';

export type JobAction = 'arm' | 'disarm' | 'stop' | 'cancel' | 'withdraw' | 'resume' | 'resume_as_dc1';

// Why a queued job cannot be armed now: the id of a message, and what goes into it.
export interface Because {
  id: string;
  values?: Record<string, string | number>;
}

export interface Offer {
  actions: JobAction[];
  because: Because | null;
}

const kNothing: Offer = { actions: [], because: null };

// What the offer needs of a machine's status.
export type LineNow = Pick<MachineStatus, 'line' | 'stall' | 'job' | 'needs_confirmation'>;

// `ended`: the job of the same machine whose end a person has not confirmed.
export function offerFor(job: Job, status: LineNow | null, role: Role, live: boolean, now_ms = Date.now(), ended: Job | null = null): Offer {
  if (!atLeast(role, 'operator')) return kNothing;
  // Without live data nothing may be set in motion; to stop is allowed, the server knows the present state.
  const careful = (actions: JobAction[]): Offer => ({
    actions: live ? actions : actions.filter((a) => a === 'stop' || a === 'cancel' || a === 'disarm'),
    because: null,
  });
  if (job.state === 'queued') return queued(job, status, live, now_ms, ended);
  if (job.state === 'armed') return careful(['disarm']);
  const stall = status?.job === job.id ? status.stall : null;
  if (job.state === 'feeding') return careful(['stop', 'cancel']);
  if (job.state === 'held') {
    const kind = stallKind(stall);
    if (kind === 'person') return careful(['resume', 'cancel']);
    if (kind === 'reset') return careful(['cancel']);
    if (stall === 'held by DC3') return careful(['resume_as_dc1', 'stop', 'cancel']);
    return careful(['stop', 'cancel']);
  }
  if (job.state === 'draining') return careful(stall === 'waiting for end' ? ['cancel'] : []);
  return kNothing;
}

function queued(job: Job, status: LineNow | null, live: boolean, now_ms: number, ended: Job | null): Offer {
  if (!live) return { actions: [], because: { id: 'because.not_live' } };
  const no = (because: Because): Offer => ({ actions: ['withdraw'], because });
  if (!status) return no({ id: 'because.no_machine', values: { machine: job.machine } });
  if (isTorn(status)) return no({ id: 'because.torn' });
  if (status.line === 'disconnected') return no({ id: 'because.disconnected' });
  if (status.line !== 'idle') return no({ id: 'because.busy', values: { job: status.job ?? 0 } });
  if (ended) return no({ id: 'because.end_unconfirmed', values: { job: ended.id, check: ended.end_check ?? '' } });
  if (job.on_hold) return no({ id: 'because.on_hold', values: { name: job.on_hold.by, reason: job.on_hold.reason } });
  if ((job.not_before_ms ?? 0) > now_ms) return no({ id: 'because.too_early', values: { at: dateTime(job.not_before_ms ?? 0) } });
  return { actions: ['arm', 'withdraw'], because: null };
}
