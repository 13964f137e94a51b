// One job with all that is known of it, and its ledger.
import { useEffect, useState } from 'preact/hooks';
import { ApiError } from '../api/client';
import type { Job } from '../api/types';
import { bytes, shortHash } from '../format/numbers';
import { deliveryText } from '../format/words';
import { t } from '../i18n/i18n';
import { programText } from '../orders/dialogs';
import { OrderBar } from '../orders/order_bar';
import { Facts } from '../parts/facts';
import { Failure } from '../parts/failure';
import { lazyView } from '../parts/lazy';
import { WireBar, WireFigures } from '../parts/wire_progress';
import { hasJob } from '../rules/lines';
import { hasEnded, hasPlan } from '../rules/plans';
import { mayRestart } from '../rules/restarts';
import { atLeast } from '../rules/roles';
import { hrefs } from '../router';
import { jobs, machines, roleOn } from '../state/shop';
import { loader } from '../state/loader';
import { StateCell, Times } from './jobs_view';
import { LedgerView } from './ledger_view';
import { NotFound } from './not_found';

// Few look for it, so its code is loaded with it.
const Plan = lazyView(() => import('./orders/plans').then((file) => file.Plan));
const StopReasons = lazyView(() => import('./orders/stop_reasons').then((file) => file.StopReasons));
const RestartPlace = lazyView(() => import('./restart_place').then((code) => code.RestartPlace));

const Stopped = ({ job }: { job: Job }) => (job.started_at_ms !== null && job.state !== 'feeding' ? <StopReasons job={job} /> : null);

const Planned = ({ job }: { job: Job }) => (job.state === 'queued' || hasEnded(job) || hasPlan(job) ? <Plan job={job} /> : null);

export function JobView({ id }: { id: number }) {
  const [error, setError] = useState<unknown>(null);
  const job = jobs.value.get(id);
  const known = job !== undefined;
  useEffect(() => {
    setError(null);
    if (!known) loader.order(loader.loadJob(id)).catch(setError);
  }, [id, known]);
  if (error instanceof ApiError && error.status === 404) return <NotFound what={t('not_found.job', { job: id })} />;
  const machine = job ? machines.value.get(job.machine) : undefined;
  const status = machine?.status.value;
  const onLine = status?.job === id && hasJob(status);
  return (
    <>
      <p class="back">
        <a href={hrefs.jobs}>{t('job.all')}</a>
      </p>
      <h1 tabIndex={-1}>{t('job.title', { job: id })}</h1>
      <Failure error={error} />
      {job && (
        <>
          <section class="card" aria-label={t('column.job')} data-state={job.state}>
            <StateCell job={job} />
            {onLine && machine && <OrderBar machine={machine} />}
            {onLine && machine && <WireBar status={machine.status} />}
            {onLine && status && <WireFigures status={status} />}
            <div class="job-facts">
              <JobFacts job={job} />
              <Times job={job} />
            </div>
            <Planned job={job} />
          </section>
          {mayRestart(job) && atLeast(roleOn(job.machine), 'operator') && <RestartPlace key={job.id} job={job} />}
          <Stopped key={`stops ${job.id}`} job={job} />
          <LedgerView job={job} />
        </>
      )}
    </>
  );
}

// Whole on paper, where nothing shows it on a touch.
const Hash = ({ sha256 }: { sha256: string }) => (
  <>
    <code data-print="no" title={sha256}>
      {shortHash(sha256)}…
    </code>
    <code class="print-only">{sha256}</code>
  </>
);

const JobFacts = ({ job }: { job: Job }) => (
  <Facts
    facts={[
      [t('fact.program'), t('fact.program_revision', { program: programText(job), revision: job.revision })],
      [t('fact.sha256'), <Hash sha256={job.sha256} />],
      [t('fact.machine'), <a href={hrefs.machine(job.machine)}>{job.machine}</a>],
      [t('fact.read_back'), job.read_back ?? null],
      [t('fact.link'), <code>{job.link}</code>],
      [t('fact.delivery'), t('fact.delivery_bytes', { delivery: deliveryText(job.delivery), bytes: bytes(job.bytes) })],
      [t('fact.release'), <a href={hrefs.reviewed(job.release)}>{job.release}</a>],
      [t('fact.restart'), job.restart && t('fact.restart_of', { release: job.restart.release, line: job.restart.line })],
      [t('column.order'), job.order === null ? null : <a href={hrefs.order(job.order)}>{job.order}</a>],
      [t('fact.queued_by'), job.created_by],
      [t('fact.armed_by'), job.armed_by],
      [t('fact.torn'), job.torn ? tornText(job.confirmed_by, job.confirm_reason) : null],
    ]}
  />
);

const tornText = (by: string | null, reason: string | null): string =>
  by === null ? t('torn.waits') : t('torn.confirmed', { name: by, reason: reason ?? '' });
