// Two revisions compared by the server: line by line, by what the lines mean, and by the moves that they
// make. Each answer stands alone; "equal" is only where both were understood.
import { deskCalls } from '../../api/desk_calls';
import type { Comparison, LinesAnswer } from '../../api/types';
import { count } from '../../format/numbers';
import { t } from '../../i18n/i18n';
import { Badge } from '../../parts/badge';
import { Facts, type Fact } from '../../parts/facts';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { changeQuery, hrefs } from '../../router';
import { machines } from '../../state/shop';
import type { Wording } from '../../format/words';
import type { PlaceProps } from './program_view';

const numberOf = (query: URLSearchParams, name: string): number | null => {
  const value = Number(query.get(name));
  return Number.isInteger(value) && value > 0 ? value : null;
};

export function ComparePlace({ program, query }: PlaceProps) {
  const revision = numberOf(query, 'revision') ?? Math.max(1, program.revision - 1);
  const other = numberOf(query, 'with');
  const withRevision = numberOf(query, 'with_revision') ?? (other === null ? program.revision : null);
  const machine = query.get('machine') ?? '';
  const key = `${program.id} ${revision} ${other} ${withRevision} ${machine}`;
  const { value, error, loading } = useLoaded(key, () =>
    deskCalls.compare(program.id, {
      revision,
      ...(other === null ? {} : { with: other }),
      ...(withRevision === null ? {} : { with_revision: withRevision }),
      machine,
    }),
  );
  return (
    <>
      <div class="writing-bar">
        <RevisionField name="revision" label={t('compare.first')} value={revision} most={program.revision} />
        <RevisionField name="with_revision" label={t('compare.second')} value={withRevision} most={other === null ? program.revision : null} />
        <label class="choice">
          <span>{t('compare.machine')}</span>
          <select value={machine} onChange={(event) => changeQuery('machine', event.currentTarget.value || null)}>
            <option value="">{t('text.read_as_it_looks')}</option>
            {[...machines.value.values()]
              .filter((one) => one.head.value.dialect === program.dialect)
              .map(({ name }) => (
                <option key={name} value={name}>
                  {name}
                </option>
              ))}
          </select>
        </label>
      </div>
      <Failure error={error} />
      {loading && (
        <p class="waiting" role="status">
          {t('compare.running')}
        </p>
      )}
      {value && <ComparedView of={value} />}
    </>
  );
}

function RevisionField({ name, label, value, most }: { name: string; label: string; value: number | null; most: number | null }) {
  return (
    <label class="choice">
      <span>{label}</span>
      <input
        type="number"
        class="revision-field"
        min={1}
        max={most ?? undefined}
        value={value ?? ''}
        onChange={(event) => changeQuery(name, event.currentTarget.value || null)}
      />
    </label>
  );
}

const kAnswers: Record<LinesAnswer['answer'], Wording['tone']> = { equal: 'good', differs: 'waiting', not_compared: 'quiet' };

const answerWording = (answer: LinesAnswer['answer']): Wording => ({ text: t(`likeness.${answer}`), tone: kAnswers[answer] });

// `chosen`: shows a line of a text that is not a revision.
export function ComparedView({ of, chosen }: { of: Comparison; chosen?: (line: number) => void }) {
  return (
    <div class="compared">
      <Facts
        facts={[
          [t('compare.text'), <Answer answer={of.text.answer} why={of.text.why} />],
          [t('compare.meaning'), <Answer answer={of.meaning.answer} why={of.meaning.why} />],
          [t('compare.motions'), <Answer answer={of.motions.answer} why={of.motions.why} />],
          ...motionFacts(of),
        ]}
      />
      {of.text.answer === 'differs' && <Changes title={t('compare.text_changes')} of={of} lines={of.text} chosen={chosen} />}
      {of.meaning.answer === 'differs' && of.text.change_count !== of.meaning.change_count && (
        <details>
          <summary>{t('compare.meaning_only')}</summary>
          <Changes title={t('compare.meaning_changes')} of={of} lines={of.meaning} chosen={chosen} />
        </details>
      )}
    </div>
  );
}

const Answer = ({ answer, why }: { answer: LinesAnswer['answer']; why: string | null }) => (
  <>
    <Badge wording={answerWording(answer)} /> {why && <span class="quiet-text">{why}</span>}
  </>
);

function motionFacts({ motions }: Comparison): Fact[] {
  if (motions.answer !== 'differs') return [];
  return [
    [
      t('compare.first_difference'),
      t('compare.after_moves', { count: motions.moves, text: count(motions.moves), first: motions.first_line ?? '–', second: motions.second_line ?? '–' }),
    ],
    [t('compare.first_does'), motions.first],
    [t('compare.second_does'), motions.second],
    [t('compare.deviation'), motions.deviation_mm === null ? null : `${motions.deviation_mm} mm`],
  ];
}

// Side by side on a wide screen, one below the other on a narrow one.
function Changes({ title, of, lines, chosen }: { title: string; of: Comparison; lines: LinesAnswer; chosen: Chosen }) {
  return (
    <section class="changes" aria-label={title}>
      <h2>{title}</h2>
      <p class="hint">{t('compare.changes', { count: lines.change_count, shown: lines.changes.length })}</p>
      <div class="changes-head">
        <strong>{sideName(of.first)}</strong>
        <strong>{sideName(of.second)}</strong>
      </div>
      {lines.changes.map((change, index) => (
        <div key={index} class="change">
          <ChangedLines side="first" of={of.first} lines={change.first} chosen={chosen} />
          <ChangedLines side="second" of={of.second} lines={change.second} chosen={chosen} />
        </div>
      ))}
    </section>
  );
}

const sideName = ({ name, revision }: Comparison['first']): string => (revision === null ? t('compare.written') : t('compare.side', { name, revision }));

type Chosen = ((line: number) => void) | undefined;

const LineOf = ({ of, line, chosen }: { of: Comparison['first']; line: number; chosen: Chosen }) =>
  of.revision !== null ? (
    <a href={hrefs.program(of.program, 'text', { revision: String(of.revision), line: String(line) })}>{line}</a>
  ) : (
    <button type="button" class="line-go" onClick={() => chosen?.(line)}>
      {line}
    </button>
  );

interface ChangedLinesProps {
  side: 'first' | 'second';
  of: Comparison['first'];
  lines: { line: number; text: string }[];
  chosen: Chosen;
}

const ChangedLines = ({ side, of, lines, chosen }: ChangedLinesProps) => (
  <ol class={`changed changed-${side}`} aria-label={sideName(of)}>
    {lines.map(({ line, text }) => (
      <li key={line}>
        <LineOf of={of} line={line} chosen={chosen} />
        <code>{text}</code>
      </li>
    ))}
    {lines.length === 0 && <li class="quiet-text">{t('compare.nothing_there')}</li>}
  </ol>
);
