// The dialogs of orders. What they say is part of the safety: who arms must see what and where, and that the motion is
// started at the control. A dialog stays until its person closes it; what happened meanwhile blocks its order.
import { calls } from '../api/calls';
import type { Job, TornBlock } from '../api/types';
import { bytes, shortHash } from '../format/numbers';
import { deliveryText, reasonText } from '../format/words';
import { t } from '../i18n/i18n';
import { OrderDialog } from '../parts/dialog';
import { Facts } from '../parts/facts';
import { offerFor, type JobAction } from '../rules/job_actions';
import { kArmMinutes } from '../rules/lines';
import { coreOfMachine, endedOf, isLive, jobs, machines, programName, roleOn } from '../state/shop';

// Why the order cannot be given now, or null.
function blockedBecause(id: number, action: JobAction): string | null {
  const job = jobs.value.get(id);
  if (!job) return t('blocked.unknown_job', { job: id });
  const offer = offerFor(job, coreOfMachine(job.machine), roleOn(job.machine), isLive.value, Date.now(), endedOf(job.machine));
  if (offer.actions.includes(action)) return null;
  if (!isLive.value) return t('blocked.not_live');
  if (offer.because) return t('blocked.because', { because: t(offer.because.id, offer.because.values) });
  return t('blocked.state', { job: id, state: t(`job_state.${job.state}`) });
}

export const programText = (job: Job): string => programName(job.program) ?? t('program.number', { id: job.program });

export function ArmDialog({ id }: { id: number }) {
  const job = jobs.value.get(id);
  if (!job) return null;
  return (
    <OrderDialog
      title={t('arm.title', { job: id })}
      confirm={t('arm.confirm', { minutes: kArmMinutes })}
      blocked={blockedBecause(id, 'arm')}
      send={(key) => calls.arm(id, kArmMinutes, key)}
    >
      <WhatIsArmed job={job} />
    </OrderDialog>
  );
}

export function WhatIsArmed({ job }: { job: Job }) {
  const title = machines.value.get(job.machine)?.head.value.title;
  return (
    <>
      <Facts
        strong
        facts={[
          [t('fact.program'), programText(job)],
          [t('fact.revision'), job.revision],
          [t('fact.sha256'), <code title={job.sha256}>{shortHash(job.sha256)}…</code>],
          [t('fact.machine'), title ? `${job.machine}, ${title}` : job.machine],
          [t('fact.link'), <code>{job.link}</code>],
          [t('fact.delivery'), t('fact.delivery_bytes', { delivery: deliveryText(job.delivery), bytes: bytes(job.bytes) })],
        ]}
      />
      <p class="notice tone-ready">
        <strong>{t('arm.control_starts')}</strong> {t('arm.look_first')}
      </p>
    </>
  );
}

export function CancelDialog({ id }: { id: number }) {
  const queued = jobs.value.get(id)?.state === 'queued';
  return (
    <OrderDialog
      title={t('cancel.title', { job: id })}
      confirm={t(queued ? 'cancel.confirm_queued' : 'cancel.confirm')}
      danger
      blocked={blockedBecause(id, queued ? 'withdraw' : 'cancel')}
      send={(key) => calls.cancel(id, key)}
    >
      <p>{t(queued ? 'cancel.queued' : 'cancel.running')}</p>
    </OrderDialog>
  );
}

export const ResumeDialog = ({ id }: { id: number }) => (
  <OrderDialog
    title={t('resume.title', { job: id })}
    confirm={t('resume.confirm')}
    blocked={blockedBecause(id, 'resume')}
    send={(key) => calls.resume(id, '', key)}
  >
    <p>{t('resume.text')}</p>
  </OrderDialog>
);

export const ResumeAsDc1Dialog = ({ id }: { id: number }) => (
  <OrderDialog
    title={t('as_dc1.title', { job: id })}
    confirm={t('as_dc1.confirm')}
    danger
    reason={t('reason.kept')}
    blocked={blockedBecause(id, 'resume_as_dc1')}
    send={(key, reason) => calls.resume(id, reason, key)}
  >
    <p>{t('as_dc1.text')}</p>
  </OrderDialog>
);

export const ResetDialog = ({ machine, torn }: { machine: string; torn: TornBlock | null }) => (
  <OrderDialog
    title={t('reset.title', { machine })}
    confirm={t('reset.confirm')}
    danger
    reason={t('reset.reason')}
    blocked={isLive.value ? null : t('blocked.not_live')}
    send={(key, reason) => calls.confirmReset(machine, reason, key)}
  >
    {torn && <p class="torn-text">{reasonText(torn.text)}</p>}
    <p>{t('reset.text')}</p>
  </OrderDialog>
);
