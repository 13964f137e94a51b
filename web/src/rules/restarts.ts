// Where and by whom a job's program may be restarted, apart from what shows it.
import type { Job, Release, RestartPreview } from '../api/types';

const kOver: readonly Job['state'][] = ['done', 'failed', 'cancelled', 'interrupted'];
export const mayRestart = (job: Job): boolean => kOver.includes(job.state);

// The first line that the control may not have got whole: "… (line 35 to 37)". Null where the job's end does not state it.
export function lineOfEnd(job: Pick<Job, 'reason'>): number | null {
  const found = /\(line (\d+) to \d+\)/.exec(job.reason);
  return found ? Number(found[1]) : null;
}

// The lines that are new, and the first ones of the rest.
export function shownLines(preview: RestartPreview, rest: number): { number: number; text: string; isNew: boolean }[] {
  const from = preview.preamble_line;
  const to = preview.rest_line;
  if (preview.text === null || from === null || to === null) return [];
  return preview.text
    .split(/\r\n|\n|\r/)
    .map((text, index) => ({ number: index + 1, text, isNew: index + 1 >= from && index + 1 < to }))
    .slice(from - 1, to - 1 + rest);
}

// What is to be done next with a restart's release.
export type RestartStep = 'clear' | 'release' | 'queue' | 'gone';
export function stepOf(release: Release): RestartStep {
  if (release.state === 'draft') return 'clear';
  if (release.state === 'in_review') return 'release';
  return release.state === 'proving' && release.transfers_done < release.transfers_allowed ? 'queue' : 'gone';
}
