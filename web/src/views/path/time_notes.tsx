// Why there are no times, and what those that there are leave out; the same of deviations.
import type { ToolPath } from '../../api/types';
import { t } from '../../i18n/i18n';

type Times = Pick<ToolPath, 'time' | 'why_no_time' | 'deviation'>;

// `isOfMachine`: one was chosen.
export function TimeNotes({ path, isOfMachine }: { path: Times; isOfMachine: boolean }) {
  return (
    <>
      {!isOfMachine && <p class="hint">{t('path_time.none')}</p>}
      {isOfMachine && path.why_no_time !== null && <p class="hint">{t('path_time.why_none', { why: path.why_no_time })}</p>}
      <Notes title={t('path_time.notes')} notes={path.time?.notes} />
      <Notes title={t('path_time.deviation_notes')} notes={path.deviation?.notes} />
    </>
  );
}

function Notes({ title, notes = [] }: { title: string; notes?: readonly string[] | undefined }) {
  if (notes.length === 0) return null;
  return (
    <details class="path-notes">
      <summary>
        {title} ({notes.length})
      </summary>
      <ul class="listed">
        {notes.map((one) => (
          <li key={one}>{one}</li>
        ))}
      </ul>
    </details>
  );
}
