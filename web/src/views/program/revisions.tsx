// Every revision, newest first, and two of them to be compared with each other.
import { useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Program, ProgramRevision } from '../../api/types';
import { bytes, count, shortHash } from '../../format/numbers';
import { dateTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { go, hrefs } from '../../router';
import { loader } from '../../state/loader';
import type { PlaceProps } from './program_view';

function useRevisions(program: Program) {
  const [older, setOlder] = useState<{ items: ProgramRevision[]; next: string | null } | null>(null);
  const [failed, setFailed] = useState<unknown>(null);
  const { value: first, error } = useLoaded(`${program.id} ${program.revision}`, () => deskCalls.revisions(program.id, null));
  const rows = [...(first?.items ?? []), ...(older?.items ?? [])];
  const next = older ? older.next : (first?.next ?? null);
  const more = () => {
    setFailed(null);
    loader.order(deskCalls.revisions(program.id, next)).then(
      (page) => setOlder((before) => ({ items: [...(before?.items ?? []), ...page.items], next: page.next })),
      setFailed,
    );
  };
  return { rows, more: next === null ? null : more, error: error ?? failed };
}

export function RevisionsPlace({ program }: PlaceProps) {
  const { rows, more, error } = useRevisions(program);
  const [[from, to], setChosen] = useState<readonly [number, number]>([program.revision - 1, program.revision]);
  const choose = (side: 0 | 1, revision: number) => setChosen(side === 0 ? [revision, to] : [from, revision]);
  const sides = [
    ['compare.first', 0, from],
    ['compare.second', 1, to],
  ] as const;
  return (
    <>
      <Failure error={error} />
      {program.revision > 1 && (
        <p class="writing-bar">
          <button
            type="button"
            class="button button-main"
            aria-disabled={from === to || from < 1}
            onClick={() => from !== to && from >= 1 && go(hrefs.program(program.id, 'compare', { revision: String(from), with_revision: String(to) }))}
          >
            {t('revisions.compare', { first: from, second: to })}
          </button>
        </p>
      )}
      <Table
        label={t('program_place.revisions')}
        rows={rows}
        keyOf={({ revision }) => revision}
        marks={({ revision }) => ({ 'data-revision': String(revision) })}
        columns={[
          {
            id: 'revision',
            head: t('column.revision'),
            cell: ({ revision }) => (
              <a href={hrefs.program(program.id, 'text', revision === program.revision ? {} : { revision: String(revision) })}>
                <strong>{revision}</strong>
              </a>
            ),
          },
          { id: 'by', head: t('column.by'), cell: (one) => t('library.changed', { name: one.created_by, at: dateTime(one.created_at_ms) }) },
          {
            id: 'text',
            head: t('column.text'),
            cell: (one) => (
              <>
                {t('library.blocks', { count: one.blocks, text: count(one.blocks) })}, {bytes(one.bytes)},{' '}
                <code title={one.sha256}>{shortHash(one.sha256)}…</code> <OriginText of={one} />
              </>
            ),
          },
          program.revision > 1 && {
            id: 'compare',
            head: t('column.compare'),
            cell: ({ revision }) => (
              <span class="choice">
                {sides.map(([label, side, now]) => (
                  <label key={side} class="choice">
                    <input
                      type="radio"
                      name={`side ${side}`}
                      checked={now === revision}
                      onChange={() => choose(side, revision)}
                      aria-label={t('revisions.choose', { revision, side: t(label) })}
                    />
                    {t(label)}
                  </label>
                ))}
              </span>
            ),
          },
        ]}
      />
      {more && (
        <button type="button" class="button" onClick={more}>
          {t('list.more')}
        </button>
      )}
    </>
  );
}

const OriginText = ({ of }: { of: ProgramRevision }) => {
  const { origin } = of;
  if (origin.kind !== 'rendered') return null;
  return (
    <span class="quiet-text">
      {t('revisions.rendered', { family: origin.family ?? '?', revision: origin.family_revision ?? 0, machine: origin.machine ?? '?' })}
    </span>
  );
};
