// What is planned of a job.
import type { Job } from '../api/types';

export const hasPlan = ({ not_before_ms, choice, end_check, on_hold, retry_of }: Job): boolean =>
  (not_before_ms ?? choice ?? end_check ?? on_hold ?? retry_of) !== null;

// It has ended, and may be queued again.
export const hasEnded = ({ state }: Pick<Job, 'state'>): boolean => state === 'done' || state === 'failed' || state === 'cancelled' || state === 'interrupted';
