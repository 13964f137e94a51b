// What waits for a decision: releases that were handed in, and those that are being proved. First those that the
// signed-in person may decide on.
import { useEffect, useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Release } from '../../api/types';
import { dateTime } from '../../format/times';
import { deliveryText, releaseText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { CsvButton } from '../../parts/csv_button';
import { Empty, GoTo } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { hrefs } from '../../router';
import { minutes } from '../../parts/clock';
import { isoTime, type CsvColumn } from '../../rules/csv';
import { hindranceOf, isUnderReview, verdictOf } from '../../rules/releases';
import { atLeast } from '../../rules/roles';
import { loader } from '../../state/loader';
import { isLive, programName, releases, roleOn } from '../../state/shop';
import { OutcomeBadge } from '../program/verdict_report';

const mayDecide = (release: Release): boolean => atLeast(roleOn(release.machine), 'approver');

export function ReviewView() {
  const [error, setError] = useState<unknown>(null);
  const [asked, setAsked] = useState(false);
  const live = isLive.value;
  useEffect(() => {
    if (live) loader.order(loader.loadReleases()).then(() => setAsked(true), setError);
  }, [live]);
  const waiting = releases.value.filter(isUnderReview);
  const mine = waiting.filter(mayDecide);
  const others = waiting.filter((one) => !mayDecide(one));
  return (
    <>
      <h1 tabIndex={-1}>{t('nav.review')}</h1>
      <p class="lead">
        {t('review.lead')} <CsvButton name="review" columns={kCsv} rows={waiting} />
      </p>
      <Failure error={error} />
      {asked && mine.length === 0 && <Empty action={<GoTo href={hrefs.library}>{t('nav.library')}</GoTo>}>{t('review.none')}</Empty>}
      {mine.length > 0 && <Waiting label={t('review.mine')} rows={mine} />}
      {others.length > 0 && (
        <section>
          <h2>{t('review.others')}</h2>
          <Waiting label={t('review.others')} rows={others} />
        </section>
      )}
    </>
  );
}

const kCsv: CsvColumn<Release>[] = [
  { head: 'release', of: ({ id }) => id },
  { head: 'program', of: ({ program }) => programName(program) ?? program },
  { head: 'revision', of: ({ revision }) => revision },
  { head: 'machine', of: ({ machine }) => machine },
  { head: 'delivery', of: ({ delivery }) => delivery },
  { head: 'state', of: ({ state }) => state },
  { head: 'transfers', of: ({ transfers_done }) => transfers_done },
  { head: 'by', of: ({ created_by }) => created_by },
  { head: 'changed', of: ({ changed_at_ms }) => isoTime(changed_at_ms) },
];

const Waiting = ({ label, rows }: { label: string; rows: readonly Release[] }) => (
  <Table
    label={label}
    rows={rows}
    keyOf={({ id }) => id}
    marks={({ id, state }) => ({ 'data-release': String(id), 'data-state': state })}
    columns={[
      {
        id: 'release',
        head: t('column.release'),
        cell: (release) => (
          <>
            <a href={hrefs.reviewed(release.id)}>
              <strong>{programName(release.program) ?? t('program.number', { id: release.program })}</strong>
            </a>{' '}
            <span class="quiet-text">
              {t('job.revision', { revision: release.revision })}, {t('review.release', { id: release.id })}
            </span>
          </>
        ),
      },
      { id: 'machine', head: t('column.machine'), cell: ({ machine, delivery }) => `${machine}, ${deliveryText(delivery)}` },
      { id: 'state', head: t('column.state'), cell: (release) => <StateOf release={release} /> },
      { id: 'verdict', head: t('column.verdict'), cell: (release) => <VerdictCell release={release} /> },
      { id: 'by', head: t('column.by'), cell: (one) => t('library.changed', { name: one.created_by, at: dateTime(one.changed_at_ms) }) },
    ]}
  />
);

export const StateOf = ({ release }: { release: Release }) => (
  <>
    {releaseText(release.state)}
    {release.state === 'proving' && (
      <span class="reason">{t('releases.used', { done: release.transfers_done, allowed: release.transfers_allowed })}</span>
    )}
  </>
);

function VerdictCell({ release }: { release: Release }) {
  const { value, error } = useLoaded(String(release.program), () => deskCalls.checks(release.program));
  if (error !== null) return <Failure error={error} />;
  if (!value) return null;
  const verdict = verdictOf(value, release);
  const hindrance = hindranceOf(verdict, minutes.value);
  return (
    <>
      {verdict && <OutcomeBadge outcome={verdict.verdict} />}
      {hindrance && <span class="reason">{t(`hindrance.${hindrance}`)}</span>}
    </>
  );
}
