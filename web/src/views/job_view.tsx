// One job with all that is known of it, and its ledger.
import { useEffect, useState } from 'preact/hooks';
import { bytes, shortHash } from '../format/numbers';
import { deliveryText, jobWording } from '../format/words';
import { hrefOf } from '../route';
import { hasJob } from '../rules/lines';
import { isLive, programName, statusOf } from '../state/select';
import { Badge } from './badge';
import { useDesk } from './context';
import { Failure } from './dialog';
import { JobButtons } from './job_buttons';
import { Reason, Times } from './jobs_view';
import { LedgerView } from './ledger_view';
import { Expiry } from './machine_card';
import { WireProgress } from './wire_progress';

export function JobView({ id }: { id: number }) {
  const { state, sync } = useDesk();
  const [error, setError] = useState<unknown>(null);
  const job = state.jobs.get(id);
  const known = job !== undefined;
  useEffect(() => {
    setError(null);
    if (!known) void sync.order(sync.loadJob(id)).catch(setError);
  }, [id, known]);

  const status = job ? statusOf(state, job.machine) : null;
  const onLine = status !== null && status.job === id && hasJob(status);
  return (
    <>
      <p class="back">
        <a href={hrefOf({ view: 'jobs' })}>All jobs</a>
      </p>
      <h1 tabIndex={-1}>Job {id}</h1>
      <Failure error={error} />
      {job && (
        <>
          <section class="card" aria-label="Job" data-state={job.state}>
            <div class="job-head">
              <Badge wording={jobWording(job.state)} old={!isLive(state) && job.ended_at_ms === null} />
              <JobButtons job={job} />
            </div>
            <Reason job={job} />
            {job.state === 'armed' && <Expiry job={job} />}
            {onLine && <WireProgress status={status} />}
            <div class="job-facts">
              <dl class="facts">
                <dt>Program</dt>
                <dd>
                  {programName(state, job.program)}, revision {job.revision}
                </dd>
                <dt>SHA-256</dt>
                <dd>
                  <code title={job.sha256}>{shortHash(job.sha256)}…</code>
                </dd>
                <dt>Machine</dt>
                <dd>{job.machine}</dd>
                {job.read_back && (
                  <>
                    <dt>Read-back</dt>
                    <dd>{job.read_back}</dd>
                  </>
                )}
                <dt>Link</dt>
                <dd>
                  <code>{job.link}</code>
                </dd>
                <dt>Delivery</dt>
                <dd>
                  {deliveryText(job.delivery)}, {bytes(job.bytes)} on the wire
                </dd>
                <dt>Release</dt>
                <dd>{job.release}</dd>
                <dt>Queued by</dt>
                <dd>{job.created_by}</dd>
                {job.armed_by !== null && (
                  <>
                    <dt>Armed by</dt>
                    <dd>{job.armed_by}</dd>
                  </>
                )}
                {job.torn && (
                  <>
                    <dt>Torn block</dt>
                    <dd>
                      {job.confirmed_by === null
                        ? 'waits for a person who confirms that the control was reset'
                        : `reset confirmed by ${job.confirmed_by}: ${job.confirm_reason ?? ''}`}
                    </dd>
                  </>
                )}
              </dl>
              <Times job={job} />
            </div>
          </section>
          <LedgerView job={job} />
        </>
      )}
    </>
  );
}
