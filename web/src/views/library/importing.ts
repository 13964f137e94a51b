// The files of a folder of a person's disk, one request each: first what would become of them, then the import.
import { deskCalls, type ImportPlan } from '../../api/desk_calls';
import { newOrderKey } from '../../api/client';
import type { ImportReport, ImportRow } from '../../api/types';
import { pathIn, withEnding } from '../../rules/program_files';

export interface Sums {
  added: number;
  revised: number;
  same: number;
  skipped: number;
  failed: number;
}
export const kOutcomes = ['failed', 'revised', 'added', 'skipped', 'same'] as const; // what a person should see first

export interface Imported {
  rows: readonly ImportRow[];
  sums: Sums;
}

// `passed` is called before each file with how many are done; where it is false the rest is left out.
export async function importFiles(files: readonly File[], plan: ImportPlan, passed: (done: number) => boolean): Promise<Imported> {
  const kept = withEnding(files.map(pathIn));
  const rows: ImportRow[] = [];
  const sums: Sums = { added: 0, revised: 0, same: 0, skipped: 0, failed: 0 };
  for (const [i, file] of files.entries()) {
    if (!passed(i)) break;
    const path = pathIn(file);
    const report: ImportReport = await deskCalls.importFile(file, { ...plan, path, keepsEnding: kept.has(path) }, newOrderKey());
    rows.push(...report.items);
    for (const outcome of kOutcomes) sums[outcome] += report[outcome];
  }
  const rank = ({ outcome }: ImportRow): number => kOutcomes.indexOf(outcome);
  return { rows: rows.sort((a, b) => rank(a) - rank(b)), sums };
}
