// What is known of a transfer, in words. Nothing here says that a control executed something: the server cannot know.
import type { JobState, LedgerInterval } from '../api/types';
import { t } from '../i18n/i18n';
import { bytes, count } from './numbers';

const kRunning: ReadonlySet<JobState> = new Set(['queued', 'armed', 'feeding', 'held', 'draining']);

// A job that is done was sent to its program's end; what may be left is the trailer after it.
export function intervalText(interval: LedgerInterval, total: number, state: JobState): string {
  const { low, high } = interval;
  const ended = !kRunning.has(state);
  if (high === 0) return t(ended ? 'interval.nothing' : 'interval.nothing_yet');
  const certain = t(`interval.${interval.known}`, { bytes: bytes(low) });
  if (state === 'done' && low < total) return t('interval.done', { certain, total: bytes(total) });
  if (low === high && low === total) return t('interval.all', { certain });
  if (low === high) return t('interval.no_more', { certain, total: bytes(total) });
  return t('interval.between', { certain, high: count(high), total: bytes(total) });
}
