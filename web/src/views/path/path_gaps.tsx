// What the picture does not have: what the run did not know, in a verdict's words, and moves that have no known place.
import type { ToolPath } from '../../api/types';
import { count } from '../../format/numbers';
import { t } from '../../i18n/i18n';
import { offsetName } from '../../rules/work_offsets';

type Gaps = Pick<ToolPath, 'diagnostics' | 'not_known' | 'is_cut_off'>;
type Notes = Pick<ToolPath, 'not_drawn' | 'compensated' | 'other_axes' | 'work_offsets'>;

// `title`: of what there is, though it is not all.
export function PathGaps({ path, title }: { path: Gaps; title: string }) {
  const alarms = path.diagnostics.filter(({ severity }) => severity === 'error');
  if (path.not_known.length === 0 && alarms.length === 0 && !path.is_cut_off) return null;
  return (
    <div class="notice tone-waiting" role="status">
      <p>
        <strong>{title}</strong>
      </p>
      <ul class="listed">
        {alarms.map((one) => (
          <li key={`${one.id} ${one.line}`}>
            {t('fault.line', { line: one.line })}: {one.text}
          </li>
        ))}
        {path.not_known.map((sentence) => (
          <li key={sentence}>{sentence}</li>
        ))}
      </ul>
    </div>
  );
}

export function PathNotes({ path }: { path: Notes }) {
  const notes = notesOf(path);
  if (notes.length === 0) return null;
  return (
    <details class="path-notes">
      <summary>{t('path.notes', { count: notes.length })}</summary>
      <ul class="listed">
        {notes.map((note) => (
          <li key={note}>{note}</li>
        ))}
      </ul>
    </details>
  );
}

function notesOf(path: Notes): string[] {
  const notes = path.not_drawn.map(({ why, moves, first_line }) => {
    const text = t(`path_not_drawn.${why}`, { count: moves, text: count(moves) });
    return first_line > 0 ? `${text} ${t('path.first_line', { line: first_line })}` : text;
  });
  if (path.compensated) notes.push(t('path.compensated'));
  if (path.other_axes.length > 0) notes.push(t('path.other_axes', { axes: path.other_axes.join(', ') }));
  if (path.work_offsets.length > 1) notes.push(t('path.work_offsets', { offsets: path.work_offsets.map((one) => offsetName(one) || t('path.no_offset')).join(', ') }));
  return notes;
}
