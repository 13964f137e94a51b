// One machine: what it is, what its line does, and the job on it with the orders that it takes.
import type { Job, PlcReport } from '../api/types';
import { positionText } from '../format/intervals';
import { count } from '../format/numbers';
import { clockTime, countdown, duration } from '../format/times';
import { deliveryText, dialectText, lineWording, stallText } from '../format/words';
import { hrefOf } from '../route';
import { expiresAt, hasJob, isTorn } from '../rules/lines';
import { isLive, programName, queuedFor } from '../state/select';
import type { MachineEntry } from '../state/state';
import { Badge } from './badge';
import { useDesk, useNow } from './context';
import { JobButtons } from './job_buttons';
import { TornWarning } from './torn_warning';
import { WireProgress } from './wire_progress';

export function MachineCard({ entry }: { entry: MachineEntry }) {
  const { state } = useDesk();
  const { item } = entry;
  const { status } = item;
  const torn = isTorn(status);
  const wording = lineWording(torn ? 'torn' : status.line);
  const job = status.job === null ? null : (state.jobs.get(status.job) ?? null);
  const onLine = hasJob(status);
  return (
    <article class={`card machine edge-${wording.tone}`} aria-label={`Machine ${item.name}`} data-line={torn ? 'torn' : status.line}>
      <header class="machine-head">
        <div>
          <h2>{item.name}</h2>
          {item.title && <p class="machine-title">{item.title}</p>}
        </div>
        <Badge wording={wording} old={!isLive(state)} />
      </header>
      <p class="machine-line">
        {dialectText(item.dialect)}, {item.kind} · <code>{item.link || 'no link'}</code>
      </p>
      {torn && <TornWarning machine={item} />}
      {status.stall && !torn && (
        <p class="stall">
          <strong>{stallText(status.stall)}</strong>
        </p>
      )}
      {status.link_error && <p class="stall">Link: {status.link_error}</p>}
      {status.link_note && <p class="quiet-text">Link: {status.link_note}</p>}
      {status.plc && <PlcWords plc={status.plc} />}
      <LineErrors errors={status.line_errors} />
      {onLine && status.job !== null && <OnLine entry={entry} id={status.job} job={job} />}
      {!onLine && !torn && job && <LastJob job={job} />}
      {!onLine && !torn && !job && <p class="quiet-text">No job on the line.</p>}
      {!onLine && <Queue machine={item.name} />}
    </article>
  );
}

// What the machine's PLC says of it.
function PlcWords({ plc }: { plc: PlcReport }) {
  return (
    <p class={plc.alarm > 0 ? 'stall' : 'quiet-text'}>
      Machine: {plc.state}
      {plc.program > 0 && `, program ${plc.program}`}
      {plc.line > 0 && `, line ${plc.line}`}
      {plc.alarm > 0 && `, alarm ${plc.alarm}`}
    </p>
  );
}

// What the line's receiver counted; nothing is shown while it is all zero.
function LineErrors({ errors }: { errors: MachineEntry['item']['status']['line_errors'] }) {
  const seen = Object.entries(errors).filter(([, count]) => count > 0);
  if (seen.length === 0) return null;
  return <p class="stall">Received wrongly: {seen.map(([name, count]) => `${count} × ${name}`).join(', ')}</p>;
}

function OnLine({ entry, id, job }: { entry: MachineEntry; id: number; job: Job | null }) {
  const { state } = useDesk();
  const { status } = entry.item;
  const program = status.program || (job ? programName(state, job.program) : '');
  return (
    <>
      <div class="on-line">
        <span class="program">{program || 'program not known'}</span>
        <span class="quiet-text">
          {job ? `revision ${job.revision}, ${deliveryText(job.delivery)}, ` : ''}
          <a href={hrefOf({ view: 'job', id })}>job {id}</a>
        </span>
      </div>
      {job?.state === 'armed' && <Expiry job={job} />}
      <WireProgress status={status} />
      {status.handed > 0 && <Position entry={entry} />}
      {status.holds > 0 && (
        <p class="quiet-text">
          {status.holds === 1 ? '1 hold' : `${count(status.holds)} holds`} by the control, {duration(status.hold_s)} in all
        </p>
      )}
      {job && <JobButtons job={job} />}
    </>
  );
}

// Where the last characters are that left us. The control may be anywhere before.
function Position({ entry }: { entry: MachineEntry }) {
  const { status } = entry.item;
  return (
    <div class="position">
      <p>
        Sent position: <strong>{positionText(status.block_from, status.block)}</strong>
      </p>
      {entry.block && (
        <p class="block-text">
          {entry.block.line > 0 && <span class="block-line">line {entry.block.line}</span>}
          <code>{entry.block.text}</code>
        </p>
      )}
      <p class="hint">What the control executed of it is not known here.</p>
    </div>
  );
}

export function Expiry({ job }: { job: Job }) {
  const { state } = useDesk();
  const now = useNow(500);
  if (job.armed_at_ms === null) return null;
  const end = expiresAt(job.armed_at_ms);
  const left = isLive(state) ? `expires in ${countdown(end - now)}, at ${clockTime(end)}` : `expires at ${clockTime(end)}`;
  return (
    <p class="expiry">
      Armed by {job.armed_by ?? 'somebody'}: <strong>{left}</strong>
    </p>
  );
}

function LastJob({ job }: { job: Job }) {
  const { state } = useDesk();
  return (
    <p class="quiet-text">
      Last on the line: <a href={hrefOf({ view: 'job', id: job.id })}>job {job.id}</a>, {programName(state, job.program)},{' '}
      {job.state}
      {job.ended_at_ms !== null ? ` at ${clockTime(job.ended_at_ms)}` : ''}.
    </p>
  );
}

const kShown = 3;

function Queue({ machine }: { machine: string }) {
  const { state } = useDesk();
  const queued = queuedFor(state, machine);
  if (queued.length === 0) return null;
  return (
    <section class="queue" aria-label={`Queued for ${machine}`}>
      <h3>Queued</h3>
      <ul>
        {queued.slice(0, kShown).map((job) => (
          <li key={job.id}>
            <span>
              <a href={hrefOf({ view: 'job', id: job.id })}>job {job.id}</a>{' '}
              <strong>{programName(state, job.program)}</strong> revision {job.revision}
            </span>
            <JobButtons job={job} />
          </li>
        ))}
      </ul>
      {queued.length > kShown && (
        <p class="hint">
          <a href={hrefOf({ view: 'jobs' })}>{queued.length - kShown} more in the jobs</a>
        </p>
      )}
    </section>
  );
}
