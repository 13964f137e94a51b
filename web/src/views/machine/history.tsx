// The jobs of a machine that are over, newest first, with their sums.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import type { Job } from '../../api/types';
import { bytes } from '../../format/numbers';
import { duration, shortTime } from '../../format/times';
import { jobWording, jobReason } from '../../format/words';
import { t } from '../../i18n/i18n';
import { programText } from '../../orders/dialogs';
import { Badge } from '../../parts/badge';
import { minutes } from '../../parts/clock';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { hrefs } from '../../router';
import { durationOf, sumsOf } from '../../rules/history';
import { jobs } from '../../state/shop';
import { loader } from '../../state/loader';

const kShown = 20;

export function History({ machine }: { machine: string }) {
  const [found, setFound] = useState<Job[]>([]);
  const [error, setError] = useState<unknown>(null);
  // Asked for again when a job of this machine ends.
  const ended = [...jobs.value.values()].filter((job) => job.machine === machine && job.ended_at_ms !== null).length;
  useEffect(() => {
    loader.order(calls.jobs({ machine, limit: kShown * 2 })).then((page) => {
      setFound(page.items.filter((job) => job.ended_at_ms !== null).slice(0, kShown));
    }, setError);
  }, [machine, ended]);
  const sums = sumsOf(found);
  return (
    <section class="card" aria-label={t('history.title')}>
      <h2>{t('history.title')}</h2>
      <Failure error={error} />
      {found.length === 0 ? (
        <p class="quiet-text">{t('history.none')}</p>
      ) : (
        <>
          <p>{t('history.sums', { all: found.length, done: sums.states.done, time: duration(sums.seconds), bytes: bytes(sums.bytes) })}</p>
          <Table
            label={t('history.title')}
            rows={found}
            keyOf={(job) => job.id}
            columns={[
              { id: 'job', head: t('column.job'), cell: (job) => <a href={hrefs.job(job.id)}>{job.id}</a> },
              { id: 'program', head: t('column.program'), cell: (job) => programText(job) },
              {
                id: 'state',
                head: t('column.state'),
                cell: (job) => (
                  <>
                    <Badge wording={jobWording(job.state)} />
                    {job.state !== 'done' && job.reason !== '' && <span class="reason">{jobReason(job)}</span>}
                  </>
                ),
              },
              { id: 'ended', head: t('column.ended'), cell: (job) => shortTime(job.ended_at_ms ?? 0, minutes.value) },
              { id: 'took', head: t('column.took'), cell: (job) => (durationOf(job) === null ? '–' : duration(durationOf(job) ?? 0)) },
            ]}
          />
        </>
      )}
    </section>
  );
}
