// Beside the text: its faults with what helps, and its outline. Both lead to their lines.
import type { RefObject } from 'preact';
import { useMemo } from 'preact/hooks';
import type { Fault, OutlineRow } from '../../api/types';
import type { Editor } from '../../editor/editor';
import { t } from '../../i18n/i18n';
import { Icon, type Shape } from '../../parts/icon';
import { Failure } from '../../parts/failure';
import type { Diagnosis } from './use_diagnosis';

const kTones: Record<Fault['severity'], { tone: string; shape: Shape }> = {
  error: { tone: 'tone-bad', shape: 'bad' },
  warning: { tone: 'tone-waiting', shape: 'waiting' },
  note: { tone: 'tone-active', shape: 'quiet' },
};

interface Props {
  diagnosis: Diagnosis;
  isFixable: boolean;
  editor: RefObject<Editor | null>;
  line: number;
}

export function SidePanel({ diagnosis, isFixable, editor, line }: Props) {
  const { found, phase, error } = diagnosis;
  const here = found ? rowAt(found.outline, line) : -1;
  const faults = useMemo(
    () => found?.faults.map((fault) => <FaultRow key={`${fault.id} ${fault.line} ${fault.column_chars}`} fault={fault} isFixable={isFixable} editor={editor} />),
    [found, isFixable],
  );
  const outline = useMemo(() => found?.outline.map((row, index) => <OutlineEntry key={row.line} row={row} isHere={index === here} editor={editor} />), [found, here]);
  return (
    <aside class="side" aria-label={t('side.label')}>
      <section>
        <h2>{t('side.faults')}</h2>
        <p class="hint" role="status" data-phase={phase}>
          {summary(diagnosis)}
        </p>
        <Failure error={phase === 'failed' ? error : null} />
        {found && (
          <ul class="faults" aria-busy={phase === 'waiting'}>
            {faults}
            {found.folded.map(({ id, more }) => (
              <li key={id} class="hint">
                {t('side.more', { count: more, id })}
              </li>
            ))}
          </ul>
        )}
      </section>
      {found && found.outline.length > 0 && (
        <section>
          <h2>{t('side.outline')}</h2>
          <ul class="outline">
            {outline}
          </ul>
          {found.outline_is_cut && <p class="hint">{t('side.outline_cut')}</p>}
        </section>
      )}
    </aside>
  );
}

function summary({ phase, found }: Diagnosis): string {
  if (phase === 'too_long') return t('side.too_long');
  if (phase === 'failed') return t('side.failed');
  if (!found || phase === 'waiting') return t('side.reading');
  const errors = found.faults.filter(({ severity }) => severity === 'error').length;
  const as = found.control.title ? t(found.control.inferred ? 'side.as_inferred' : 'side.as', { title: found.control.title }) : '';
  return `${t('side.count', { errors, others: found.faults.length - errors })} ${as} ${t('side.not_run')}`;
}

// The last place at or before the cursor; -1: there is none.
const rowAt = (rows: readonly OutlineRow[], line: number): number => rows.reduce((found, row, index) => (row.line <= line ? index : found), -1);

function FaultRow({ fault, isFixable, editor }: { fault: Fault; isFixable: boolean; editor: RefObject<Editor | null> }) {
  const { tone, shape } = kTones[fault.severity];
  const { fix } = fault;
  return (
    <li class={`fault ${tone}`} data-fault={fault.id}>
      <button type="button" class="fault-go" onClick={() => editor.current?.goTo(fault.line)}>
        <Icon shape={shape} /> <span class="unseen">{t(`severity.${fault.severity}`)}</span> {t('fault.line', { line: fault.line })}
      </button>
      <p>{fault.text}</p>
      {fault.alarm && <p class="hint">{t('fault.alarm', { alarm: fault.alarm })}</p>}
      <details>
        <summary>{t('side.help')}</summary>
        <p class="hint">{fault.help}</p>
      </details>
      {fix && (
        <button type="button" class="button button-small" aria-disabled={!isFixable} onClick={() => isFixable && editor.current?.applyFix(fault)}>
          {fix.text === '' ? t('fault.remove') : t('fault.write', { text: fix.text })}
        </button>
      )}
    </li>
  );
}

const OutlineEntry = ({ row, isHere: here, editor }: { row: OutlineRow; isHere: boolean; editor: RefObject<Editor | null> }) => (
  <li>
    <button type="button" class="outline-go" data-sort={row.sort} aria-current={here ? 'location' : undefined} onClick={() => editor.current?.goTo(row.line)}>
      <span class="outline-sort">{t(`outline.${row.sort}`)}</span> <code>{row.text}</code> <span class="quiet-text">{row.line}</span>
    </button>
  </li>
);
