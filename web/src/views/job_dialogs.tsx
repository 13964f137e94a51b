// The dialogs of a job's orders. What they say is part of the safety: who arms must see what and where, and that the
// motion is started at the control.
import { calls } from '../api/calls';
import type { Job } from '../api/types';
import { bytes, shortHash } from '../format/numbers';
import { deliveryText } from '../format/words';
import { kArmMinutes } from '../rules/lines';
import { offerFor, type JobAction } from '../rules/job_actions';
import { isLive, programName, statusOf } from '../state/select';
import { useDesk } from './context';
import { OrderDialog } from './dialog';

interface Props {
  job: Job;
  close: () => void;
}

// What happened to the job or the line while the dialog was open may forbid its order.
function useBlocked(job: Job, action: JobAction): string | null {
  const { state, session } = useDesk();
  const offer = offerFor(job, statusOf(state, job.machine), session.role, isLive(state));
  if (offer.actions.includes(action)) return null;
  if (!isLive(state)) return 'The connection to the server is lost: this cannot be ordered now.';
  if (offer.because) return `Not now: ${offer.because}.`;
  return `Not now: job ${job.id} is ${job.state}.`;
}

export function ArmDialog({ job, close }: Props) {
  const { state } = useDesk();
  const machine = state.machines.get(job.machine)?.item;
  return (
    <OrderDialog
      title={`Arm job ${job.id}?`}
      confirm={`Arm for ${kArmMinutes} minutes`}
      blocked={useBlocked(job, 'arm')}
      send={(key) => calls.arm(job.id, kArmMinutes, key)}
      close={close}
    >
      <dl class="facts facts-strong">
        <dt>Program</dt>
        <dd>{programName(state, job.program)}</dd>
        <dt>Revision</dt>
        <dd>{job.revision}</dd>
        <dt>SHA-256</dt>
        <dd>
          <code title={job.sha256}>{shortHash(job.sha256)}…</code>
        </dd>
        <dt>Machine</dt>
        <dd>
          {job.machine}
          {machine?.title ? `, ${machine.title}` : ''}
        </dd>
        <dt>Link</dt>
        <dd>
          <code>{job.link}</code>
        </dd>
        <dt>Delivery</dt>
        <dd>
          {deliveryText(job.delivery)}, {bytes(job.bytes)} on the wire
        </dd>
      </dl>
      <p class="notice tone-ready">
        <strong>The control starts the motion; dripfeed never does.</strong> While armed, the program goes out as soon as
        the control of this machine asks for it. Look at the machine before you arm.
      </p>
    </OrderDialog>
  );
}

export function CancelDialog({ job, close }: Props) {
  const queued = job.state === 'queued';
  return (
    <OrderDialog
      title={`Cancel job ${job.id}?`}
      confirm={queued ? 'Cancel the job' : 'Cancel at block end'}
      danger
      blocked={useBlocked(job, queued ? 'withdraw' : 'cancel')}
      send={(key) => calls.cancel(job.id, key)}
      close={close}
    >
      {queued ? (
        <p>The job leaves the queue. Nothing of it was sent.</p>
      ) : (
        <p>
          The block that is on the line is sent to its end, then the job is over. The control keeps what it already has
          and may execute it. The rest of the program is not sent.
        </p>
      )}
    </OrderDialog>
  );
}

export function ResumeDialog({ job, close }: Props) {
  return (
    <OrderDialog
      title={`Resume job ${job.id}?`}
      confirm="Resume"
      blocked={useBlocked(job, 'resume')}
      send={(key) => calls.resume(job.id, '', key)}
      close={close}
    >
      <p>A person stopped this job at a block end. It goes on with the next block; the control may move at once.</p>
    </OrderDialog>
  );
}

export function ResumeAsDc1Dialog({ job, close }: Props) {
  return (
    <OrderDialog
      title={`Resume job ${job.id} as if DC1 had come?`}
      confirm="Resume as if DC1"
      danger
      reason="Reason (kept on record)"
      blocked={useBlocked(job, 'resume_as_dc1')}
      send={(key, reason) => calls.resume(job.id, reason, key)}
      close={close}
    >
      <p>
        The control holds this line by DC3 and has not released it. Do this only when you know that its DC1 was lost. If
        its buffer is full, characters will be lost there.
      </p>
    </OrderDialog>
  );
}
