// The orders that a job takes now, as buttons for those who may give them.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../api/calls';
import { newOrderKey } from '../api/client';
import type { Job } from '../api/types';
import { offerFor, type JobAction } from '../rules/job_actions';
import { isLive, statusOf } from '../state/select';
import { useDesk } from './context';
import { Failure } from './dialog';
import { ArmDialog, CancelDialog, ResumeAsDc1Dialog, ResumeDialog } from './job_dialogs';

interface Look {
  label: string;
  kind: 'main' | 'plain' | 'danger';
}

const kLooks: Record<JobAction, Look> = {
  arm: { label: 'Arm…', kind: 'main' },
  disarm: { label: 'Disarm', kind: 'main' },
  stop: { label: 'Stop at block end', kind: 'main' },
  cancel: { label: 'Cancel at block end…', kind: 'danger' },
  withdraw: { label: 'Cancel…', kind: 'plain' },
  resume: { label: 'Resume…', kind: 'main' },
  resume_as_dc1: { label: 'Resume as if DC1…', kind: 'plain' },
};

export function JobButtons({ job }: { job: Job }) {
  const { state, sync, session } = useDesk();
  const [open, setOpen] = useState<JobAction | null>(null);
  const [busy, setBusy] = useState(false);
  const [note, setNote] = useState<string | null>(null);
  const [error, setError] = useState<unknown>(null);
  useEffect(() => {
    setNote(null);
    setError(null);
  }, [job.id, job.state]);

  const offer = offerFor(job, statusOf(state, job.machine), session.role, isLive(state));
  // Disarm and stop take nothing away and must be quick: no dialog stands before them.
  const sendNow = async (action: 'disarm' | 'stop') => {
    setBusy(true);
    setError(null);
    try {
      await sync.order(action === 'stop' ? calls.stop(job.id, newOrderKey()) : calls.cancel(job.id, newOrderKey()));
      if (action === 'stop') setNote('Stop asked for: the feed stops at the next block end.');
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  const press = (action: JobAction) => {
    if (action === 'disarm' || action === 'stop') void sendNow(action);
    else setOpen(action);
  };

  const close = () => setOpen(null);
  const nothing = offer.actions.length === 0 && !offer.because && open === null && error === null;
  if (nothing) return null;
  return (
    <div class="job-buttons">
      <div class="buttons">
        {offer.actions.map((action) => (
          <button
            key={action}
            type="button"
            class={`button button-${kLooks[action].kind}`}
            disabled={busy}
            onClick={() => press(action)}
            aria-label={`${kLooks[action].label.replace('…', '')}, job ${job.id}`}
          >
            {kLooks[action].label}
          </button>
        ))}
      </div>
      {offer.because && <p class="hint">Cannot be armed now: {offer.because}.</p>}
      {note && (
        <p class="hint" role="status">
          {note}
        </p>
      )}
      <Failure error={error} />
      {open === 'arm' && <ArmDialog job={job} close={close} />}
      {(open === 'cancel' || open === 'withdraw') && <CancelDialog job={job} close={close} />}
      {open === 'resume' && <ResumeDialog job={job} close={close} />}
      {open === 'resume_as_dc1' && <ResumeAsDc1Dialog job={job} close={close} />}
    </div>
  );
}
