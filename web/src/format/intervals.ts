// What is known of a transfer, in words. Nothing here says that a control executed something: the server cannot know.
import type { LedgerInterval } from '../api/types';
import { bytes, count } from './numbers';

// The lines between which the last character that may have reached the control lies.
export function positionText(fromLine: number, toLine: number): string {
  if (toLine <= 0) return 'position not known';
  if (fromLine <= 0) return `at most up to line ${toLine}`;
  if (fromLine === toLine) return `in line ${toLine}`;
  return `between lines ${fromLine} and ${toLine}`;
}

const kCertain: Record<LedgerInterval['known'], (low: number) => string> = {
  clocked: (low) => `${bytes(low)} passed the line for certain`,
  confirmed: (low) => `${bytes(low)} were acknowledged by the other side`,
};

export function intervalText(interval: LedgerInterval, total: number, ended: boolean): string {
  const { low, high } = interval;
  if (high === 0) return ended ? 'Nothing was sent.' : 'Nothing has been sent yet.';
  const certain = (kCertain[interval.known] ?? kCertain.clocked)(low);
  if (low === high && low === total) return `All ${certain}.`;
  if (low === high) return `${certain}, and no more of ${bytes(total)} left the server.`;
  return `${certain}; no more than ${count(high)} of ${bytes(total)} can have left the server. The true count lies between the two.`;
}
