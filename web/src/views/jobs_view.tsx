// The transfers, newest first, with what each takes now.
import { useState } from 'preact/hooks';
import type { Job, JobState } from '../api/types';
import { countdown, clockTime, shortTime } from '../format/times';
import { jobWording, jobReason, kJobStates } from '../format/words';
import { t } from '../i18n/i18n';
import { CancelDialog, programText } from '../orders/dialogs';
import { Badge } from '../parts/badge';
import { Choice, MachineField } from '../parts/choice';
import { minutes, seconds } from '../parts/clock';
import { CsvButton } from '../parts/csv_button';
import { showDialog } from '../parts/dialog';
import { Empty } from '../parts/empty';
import { Failure } from '../parts/failure';
import { Table } from '../parts/table';
import { isoTime, type CsvColumn } from '../rules/csv';
import { atLeast } from '../rules/roles';
import { changeQuery, hrefs, route } from '../router';
import { bestRole, isLive, isLost, jobsNewestFirst, olderJobs } from '../state/shop';
import { loader } from '../state/loader';

export function JobsView() {
  const may = atLeast(bestRole(), 'operator');
  const [error, setError] = useState<unknown>(null);
  const { state, machine } = filterIn(route.value.query);
  const jobs = jobsNewestFirst.value.filter((job) => (state === '' || job.state === state) && (machine === '' || job.machine === machine));
  const older = () => {
    setError(null);
    loader.order(loader.loadOlderJobs()).catch(setError);
  };
  return (
    <>
      <h1 tabIndex={-1}>{t('nav.jobs')}</h1>
      <p class="lead">
        <a href={hrefs.history}>{t('jobs.history')}</a> <CsvButton name="jobs" columns={kCsv} rows={jobs} />
      </p>
      <div class="search-line" role="search">
        <Choice
          label={t('column.state')}
          value={state}
          options={kJobStates.map((one) => [one, jobWording(one).text] as const)}
          empty={t('list.all')}
          change={(one) => changeQuery('state', one || null)}
        />
        <MachineField label={t('column.machine')} value={machine} empty={t('list.all')} change={(one) => changeQuery('machine', one || null)} />
      </div>
      {jobs.length === 0 ? (
        <Empty
          action={
            <a class="button button-main" href={hrefs.releases}>
              {t('jobs.new')}
            </a>
          }
        >
          {t(jobsNewestFirst.value.length === 0 ? 'jobs.empty' : 'jobs.none_like')}
        </Empty>
      ) : (
        <Table
          label={t('nav.jobs')}
          rows={jobs}
          name="jobs"
          keyOf={(job) => job.id}
          marks={(job) => ({ 'data-job': String(job.id), 'data-state': job.state })}
          columns={[
            {
              id: 'job',
              head: t('column.job'),
              by: ({ id }) => id,
              cell: (job) => (
                <a class="job-id" href={hrefs.job(job.id)} aria-label={t('job.details', { job: job.id })}>
                  {job.id}
                </a>
              ),
            },
            { id: 'state', head: t('column.state'), by: ({ state }) => jobWording(state).text, cell: (job) => <StateCell job={job} /> },
            {
              id: 'program',
              head: t('column.program'),
              by: programText,
              cell: (job) => (
                <>
                  <a href={hrefs.program(job.program)}>
                    <strong>{programText(job)}</strong>
                  </a>{' '}
                  <span class="quiet-text">{t('job.revision', { revision: job.revision })}</span>
                </>
              ),
            },
            { id: 'machine', head: t('column.machine'), by: ({ machine }) => machine, cell: (job) => <a href={hrefs.machine(job.machine)}>{job.machine}</a> },
            { id: 'times', head: t('column.times'), cell: (job) => <Times job={job} /> },
            may && { id: 'orders', head: t('column.orders'), class: 'orders', cell: (job) => <RowOrders job={job} /> },
          ]}
        />
      )}
      <Failure error={error} />
      {olderJobs.value !== null && (
        <button type="button" class="button" onClick={older}>
          {t('jobs.older')}
        </button>
      )}
    </>
  );
}

function filterIn(query: URLSearchParams): { state: JobState | ''; machine: string } {
  return { state: kJobStates.find((one) => one === query.get('state')) ?? '', machine: query.get('machine') ?? '' };
}

const kCsv: CsvColumn<Job>[] = [
  { head: 'job', of: ({ id }) => id },
  { head: 'state', of: ({ state }) => state },
  { head: 'program', of: programText },
  { head: 'revision', of: ({ revision }) => revision },
  { head: 'machine', of: ({ machine }) => machine },
  { head: 'bytes', of: ({ bytes }) => bytes },
  { head: 'created', of: ({ created_at_ms }) => isoTime(created_at_ms) },
  { head: 'started', of: ({ started_at_ms }) => isoTime(started_at_ms) },
  { head: 'ended', of: ({ ended_at_ms }) => isoTime(ended_at_ms) },
  { head: 'reason', of: ({ reason }) => reason },
];

// Who feeds stands at the machine: there are its orders. Here a job is only taken out of the queue.
const RowOrders = ({ job }: { job: Job }) =>
  job.state === 'queued' ? (
    <button type="button" class="button button-small" onClick={() => showDialog(<CancelDialog id={job.id} />)} aria-label={t('order.cancel_job', { job: job.id })}>
      {t('order.cancel')}
    </button>
  ) : job.ended_at_ms === null ? (
    <a class="button button-small" href={hrefs.machine(job.machine)}>
      {t('jobs.to_machine')}
    </a>
  ) : null;

export const StateCell = ({ job }: { job: Job }) => (
  <>
    <Badge wording={jobWording(job.state)} old={isLost.value && job.ended_at_ms === null} />
    <Reason job={job} />
    {job.read_back && <p class="reason">{t('job.read_back', { text: job.read_back })}</p>}
    {job.state === 'armed' && <Expiry job={job} />}
  </>
);

// The reason of the last move, where it says more than the state. A job that is done needs none.
export const Reason = ({ job }: { job: Job }) =>
  job.reason === '' || job.reason === job.state || job.state === 'done' ? null : <p class="reason">{jobReason(job)}</p>;

export function Expiry({ job }: { job: Job }) {
  const who = t('expiry.armed_by', { name: job.armed_by ?? '?' });
  if (job.expires_at_ms === null) return <p class="expiry">{who}</p>;
  const at = clockTime(job.expires_at_ms);
  return (
    <p class="expiry">
      {who}: <strong>{isLive.value ? t('expiry.in', { left: countdown(job.expires_at_ms - seconds.value), at }) : t('expiry.at', { at })}</strong>
    </p>
  );
}

export function Times({ job }: { job: Job }) {
  const rows: [string, number | null][] = [
    ['time.queued', job.created_at_ms],
    ['time.armed', job.armed_at_ms],
    ['time.started', job.started_at_ms],
    ['time.ended', job.ended_at_ms],
  ];
  return (
    <dl class="times">
      {rows.map(([name, at]) =>
        at === null ? null : (
          <div key={name}>
            <dt>{t(name)}</dt>
            <dd>
              <time dateTime={new Date(at).toISOString()}>{shortTime(at, minutes.value)}</time>
            </dd>
          </div>
        ),
      )}
    </dl>
  );
}
