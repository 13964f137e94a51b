// A new job: what is released for a machine, each with a button that queues it. Queueing sends nothing.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../api/calls';
import type { Release } from '../api/types';
import { shortHash } from '../format/numbers';
import { dateTime } from '../format/times';
import { deliveryText, releaseText } from '../format/words';
import { t } from '../i18n/i18n';
import { Empty } from '../parts/empty';
import { Failure } from '../parts/failure';
import { showLazyDialog } from '../parts/lazy';
import { WhatWasQueued, type Queued } from '../parts/queued';
import { Table } from '../parts/table';
import { isReleased, mayBeQueued } from '../rules/releases';
import { atLeast } from '../rules/roles';
import { hrefs } from '../router';
import { bestRole, isLive, programName, releases, roleOn } from '../state/shop';
import { loader } from '../state/loader';

export function ReleasesView() {
  const [error, setError] = useState<unknown>(null);
  const [queued, setQueued] = useState<Queued | null>(null);
  const [busy, setBusy] = useState(false);
  const live = isLive.value;
  useEffect(() => {
    if (live) loader.order(loader.loadReleases()).catch(setError);
  }, [live]);

  const queue = async (release: Release) => {
    if (busy) return;
    setBusy(true);
    setError(null);
    setQueued(null);
    try {
      const job = await loader.order(calls.addJob(release.id));
      setQueued({ jobs: [job], left_out: [] });
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  const plan = (release: Release) =>
    void showLazyDialog(
      () => import('./orders/queue_dialog'),
      ({ QueueDialog }) => <QueueDialog release={release} queued={setQueued} />,
    ).catch(setError);
  const usable = releases.value.filter(isReleased);
  const may = atLeast(bestRole(), 'operator');
  return (
    <>
      <h1 tabIndex={-1}>{t('nav.releases')}</h1>
      <p class="lead">{t('releases.lead')}</p>
      <Failure error={error} />
      {queued && <WhatWasQueued of={queued} />}
      {usable.length === 0 ? (
        <Empty
          action={
            <a class="button" href={hrefs.floor}>
              {t('not_found.floor')}
            </a>
          }
        >
          {t('releases.empty')}
        </Empty>
      ) : (
        <Table
          label={t('nav.releases')}
          rows={usable}
          keyOf={(release) => release.id}
          columns={[
            { id: 'release', head: t('column.release'), cell: (release) => release.id },
            {
              id: 'program',
              head: t('column.program'),
              cell: (release) => <ProgramCell release={release} />,
            },
            { id: 'machine', head: t('column.machine'), cell: (release) => release.machine },
            { id: 'delivery', head: t('column.delivery'), cell: (release) => deliveryText(release.delivery) },
            { id: 'state', head: t('column.state'), cell: (release) => <Standing release={release} /> },
            may && {
              id: 'orders',
              head: t('column.orders'),
              class: 'orders',
              cell: (release) =>
                mayBeQueued(release) && atLeast(roleOn(release.machine), 'operator') && (
                  <span class="queue-buttons">
                    <button
                      type="button"
                      class="button button-main"
                      aria-disabled={busy || !live}
                      onClick={() => live && void queue(release)}
                      aria-label={t('releases.queue_of', { release: release.id })}
                    >
                      {t('releases.queue')}
                    </button>
                    <button type="button" class="button" aria-disabled={!live} onClick={() => live && plan(release)} aria-label={t('releases.plan_of', { release: release.id })}>
                      {t('releases.plan')}
                    </button>
                  </span>
                ),
            },
          ]}
        />
      )}
    </>
  );
}

const ProgramCell = ({ release }: { release: Release }) => (
  <>
    <a href={hrefs.program(release.program)}>
      <strong>{programName(release.program) ?? t('program.number', { id: release.program })}</strong>
    </a>{' '}
    <span class="quiet-text">
      {t('job.revision', { revision: release.revision })}, <code title={release.sha256}>{shortHash(release.sha256)}…</code>
    </span>
  </>
);

const Standing = ({ release }: { release: Release }) => (
  <>
    {releaseText(release.state)}
    <span class="reason">
      {release.state === 'proving'
        ? t('releases.used', { done: release.transfers_done, allowed: release.transfers_allowed })
        : t('releases.by', { name: release.approved_by ?? '?', at: dateTime(release.changed_at_ms) })}
    </span>
  </>
);
