// What waits for a machine, in its order. A row is dragged, or moved by its buttons; the order is the server's.
import { useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import { newOrderKey } from '../../api/client';
import type { Job } from '../../api/types';
import { t } from '../../i18n/i18n';
import { CancelDialog, programText } from '../../orders/dialogs';
import { showDialog } from '../../parts/dialog';
import { Empty } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { Icon } from '../../parts/icon';
import { lazyView } from '../../parts/lazy';
import { hasPlan } from '../../rules/plans';
import { atLeast } from '../../rules/roles';
import { hrefs } from '../../router';
import { takeJobs } from '../../state/changes';
import { loader } from '../../state/loader';
import { isLive, jobs, queueOf, roleOn, type Machine } from '../../state/shop';

const Plan = lazyView(() => import('../orders/plans').then((file) => file.Plan));
const HoldButton = lazyView(() => import('../orders/plans').then((file) => file.HoldButton));

export function Queue({ machine }: { machine: Machine }) {
  const [error, setError] = useState<unknown>(null);
  const [dragged, setDragged] = useState<number | null>(null);
  const queue = queueOf(machine.name);
  const may = atLeast(roleOn(machine.name), 'operator') && isLive.value;
  // `before`: the job that it goes in front of; null: to the end.
  const move = (id: number, before: number | null) => {
    if (id === before) return;
    setError(null);
    loader.order(calls.moveJob(id, before, newOrderKey())).then((job) => takeJobs([job]), setError);
  };
  return (
    <section class="card" aria-label={t('queue.of', { machine: machine.name })}>
      <h2>{t('queue.title')}</h2>
      <Failure error={error} />
      {[...jobs.value.values()].map((job) => job.machine === machine.name && job.needs_end_confirmation && <Plan key={job.id} job={job} />)}
      {queue.length === 0 && (
        <Empty
          action={
            <a class="button" href={hrefs.releases}>
              {t('jobs.new')}
            </a>
          }
        >
          {t('queue.empty')}
        </Empty>
      )}
      <ol class="queue-list">
        {queue.map((job, index) => (
          <li
            key={job.id}
            data-job={job.id}
            draggable={may && queue.length > 1}
            class={dragged === job.id ? 'dragged' : undefined}
            onDragStart={() => setDragged(job.id)}
            onDragEnd={() => setDragged(null)}
            onDragOver={(event) => dragged !== null && event.preventDefault()}
            onDrop={(event) => {
              event.preventDefault();
              if (dragged !== null) move(dragged, job.id);
              setDragged(null);
            }}
          >
            <QueueRow job={job} />
            {hasPlan(job) && <Plan job={job} />}
            {may && (
              <span class="queue-buttons">
                <MoveButton job={job} up disabled={index === 0} press={() => move(job.id, queue[index - 1]?.id ?? null)} />
                <MoveButton job={job} up={false} disabled={index === queue.length - 1} press={() => move(job.id, queue[index + 2]?.id ?? null)} />
                {!hasPlan(job) && <HoldButton job={job} />}
                <button type="button" class="button button-small" onClick={() => showDialog(<CancelDialog id={job.id} />)} aria-label={t('order.cancel_job', { job: job.id })}>
                  {t('order.cancel')}
                </button>
              </span>
            )}
          </li>
        ))}
      </ol>
    </section>
  );
}

const QueueRow = ({ job }: { job: Job }) => (
  <span>
    <a href={hrefs.job(job.id)}>{t('job.number', { job: job.id })}</a> <strong>{programText(job)}</strong>{' '}
    <span class="quiet-text">{t('job.revision', { revision: job.revision })}</span>
  </span>
);

const MoveButton = ({ job, up, disabled, press }: { job: Job; up: boolean; disabled: boolean; press: () => void }) => (
  <button
    type="button"
    class="button button-small"
    aria-disabled={disabled}
    onClick={() => !disabled && press()}
    aria-label={t(up ? 'queue.up' : 'queue.down', { job: job.id })}
  >
    <Icon shape={up ? 'up' : 'down'} />
  </button>
);
