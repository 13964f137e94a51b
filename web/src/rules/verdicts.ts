// What a verdict says, from its report: every finding with its place, worst first.
import type { Outcome, Verdict } from '../api/types';
import type { Tone } from '../format/tones';

export const kOutcomeTones: Record<Outcome, Tone> = { pass: 'good', warn: 'waiting', unknown: 'waiting', fail: 'bad' };

export type Severity = 'error' | 'warning' | 'note';

export interface Finding {
  id: string;
  severity: Severity;
  line: number; // 0: of the whole program
  file: string | null; // a called program; null: the program itself
  text: string;
  alarm: string | null;
}

const kRank: Record<Severity, number> = { error: 0, warning: 1, note: 2 };

export type FoundBy = Pick<Verdict, 'diagnostics' | 'envelope' | 'gouge' | 'accuracy' | 'programs'>;

export function findingsOf(verdict: FoundBy): Finding[] {
  const all: Finding[] = verdict.diagnostics.map(({ id, severity, line, file, text, alarm }) => ({ id, severity, line, file, text, alarm }));
  for (const check of [verdict.envelope, verdict.gouge, verdict.accuracy])
    for (const { id, severity, line, program, text, alarm } of check?.findings ?? [])
      all.push({ id, severity, line, file: program === 0 ? null : (verdict.programs[program] ?? null), text, alarm });
  return all.sort((a, b) => kRank[a.severity] - kRank[b.severity] || a.line - b.line);
}
