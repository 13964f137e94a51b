// What is planned of a job.
import type { Job } from '../api/types';

export const hasPlan = ({ not_before_ms, choice, end_check }: Job): boolean => (not_before_ms ?? choice ?? end_check) !== null;
