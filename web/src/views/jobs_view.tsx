// The transfers, newest first, with what each takes now.
import { useState } from 'preact/hooks';
import type { Job } from '../api/types';
import { shortTime } from '../format/times';
import { jobWording, reasonText } from '../format/words';
import { hrefOf } from '../route';
import { atLeast } from '../rules/roles';
import { isLive, newestFirst, programName } from '../state/select';
import { Badge } from './badge';
import { useDesk, useNow } from './context';
import { Failure } from './dialog';
import { JobButtons } from './job_buttons';
import { Expiry } from './machine_card';

export function JobsView() {
  const { state, sync, session } = useDesk();
  const may = atLeast(session.role, 'operator');
  const [error, setError] = useState<unknown>(null);
  const jobs = newestFirst(state);
  const older = async () => {
    setError(null);
    await sync.order(sync.loadOlderJobs()).catch(setError);
  };
  return (
    <>
      <h1 tabIndex={-1}>Jobs</h1>
      {jobs.length === 0 && (
        <p class="empty">
          No job yet. Queue one from a release under <a href={hrefOf({ view: 'releases' })}>New job</a>.
        </p>
      )}
      {jobs.length > 0 && (
        <table class="table">
          <thead>
            <tr>
              <th scope="col">Job</th>
              <th scope="col">State</th>
              <th scope="col">Program</th>
              <th scope="col">Machine</th>
              <th scope="col">Times</th>
              {may && <th scope="col">Orders</th>}
            </tr>
          </thead>
          <tbody>
            {jobs.map((job) => (
              <JobRow key={job.id} job={job} may={may} />
            ))}
          </tbody>
        </table>
      )}
      <Failure error={error} />
      {state.olderJobs !== null && (
        <button type="button" class="button" onClick={() => void older()}>
          Show older jobs
        </button>
      )}
    </>
  );
}

function JobRow({ job, may }: { job: Job; may: boolean }) {
  const { state } = useDesk();
  return (
    <tr>
      <td data-label="Job">
        <a class="job-id" href={hrefOf({ view: 'job', id: job.id })} aria-label={`Details of job ${job.id}`}>
          {job.id}
        </a>
      </td>
      <td data-label="State">
        <Badge wording={jobWording(job.state)} old={!isLive(state) && job.ended_at_ms === null} />
        <Reason job={job} />
        {job.read_back && <p class="reason">read-back: {job.read_back}</p>}
        {job.state === 'armed' && <Expiry job={job} />}
      </td>
      <td data-label="Program">
        <strong>{programName(state, job.program)}</strong> <span class="quiet-text">rev. {job.revision}</span>
      </td>
      <td data-label="Machine">{job.machine}</td>
      <td data-label="Times">
        <Times job={job} />
      </td>
      {may && (
        <td data-label="Orders" class="orders">
          <JobButtons job={job} />
        </td>
      )}
    </tr>
  );
}

// The reason of the last move, where it says more than the state.
export function Reason({ job }: { job: Job }) {
  if (job.reason === '' || job.reason === job.state) return null;
  return <p class="reason">{reasonText(job.reason)}</p>;
}

export function Times({ job }: { job: Job }) {
  const now = useNow(60_000);
  const rows: [string, number | null][] = [
    ['queued', job.created_at_ms],
    ['armed', job.armed_at_ms],
    ['started', job.started_at_ms],
    ['ended', job.ended_at_ms],
  ];
  return (
    <dl class="times">
      {rows.map(([name, at]) =>
        at === null ? null : (
          <div key={name}>
            <dt>{name}</dt>
            <dd>
              <time dateTime={new Date(at).toISOString()}>{shortTime(at, now)}</time>
            </dd>
          </div>
        ),
      )}
    </dl>
  );
}
