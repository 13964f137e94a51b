// What is planned of a job, where it stands in its queue and when it has ended: the time before which it is not armed, its
// choice of machines, and the end that a person confirms. Nothing here arms by itself.
import { useState } from 'preact/hooks';
import { orderCalls } from '../../api/order_calls';
import type { Job } from '../../api/types';
import { dateTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { WhatIsArmed } from '../../orders/dialogs';
import { seconds } from '../../parts/clock';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { kArmMinutes } from '../../rules/lines';
import { fromLocalField, localField } from '../../rules/orders';
import { hasEnded } from '../../rules/plans';
import { atLeast } from '../../rules/roles';
import { hrefs } from '../../router';
import { takeJobs } from '../../state/changes';
import { isLive, jobs, roleOn } from '../../state/shop';

export function Plan({ job }: { job: Job }) {
  const isQueued = job.state === 'queued';
  const may = atLeast(roleOn(job.machine), 'operator') && isLive.value;
  const isEarly = isQueued && job.not_before_ms !== null && job.not_before_ms > seconds.value;
  return (
    <div class="plan">
      {job.not_before_ms !== null && <p class={isEarly ? 'reason' : 'quiet-text'}>{t(isEarly ? 'plan.not_before' : 'plan.was_not_before', { at: dateTime(job.not_before_ms) })}</p>}
      {job.on_hold && <p class="notice tone-waiting">{t('plan.on_hold', { name: job.on_hold.by, reason: job.on_hold.reason })}</p>}
      {job.retry_of !== null && (
        <p class="quiet-text">
          <a href={hrefs.job(job.retry_of)}>{t('plan.retry_of', { job: job.retry_of })}</a>
        </p>
      )}
      {job.choice !== null && isQueued && <p class="quiet-text">{choiceText(job)}</p>}
      {job.end_check !== null && <p class={job.needs_end_confirmation ? 'notice tone-waiting' : 'quiet-text'}>{endText(job)}</p>}
      {may && <PlanButtons job={job} isEarly={isEarly} />}
    </div>
  );
}

function PlanButtons({ job, isEarly }: { job: Job; isEarly: boolean }) {
  const isQueued = job.state === 'queued';
  return (
    <p class="plan-buttons">
      {isQueued && (
        <button type="button" class="button button-small" onClick={() => showDialog(<TimeDialog job={job} />)} aria-label={t('plan.time_of', { job: job.id })}>
          {t('plan.time')}
        </button>
      )}
      {isQueued && <HoldButton job={job} />}
      {hasEnded(job) && (
        <button type="button" class="button button-small" onClick={() => showDialog(<RetryDialog job={job} />)}>
          {t('plan.retry')}
        </button>
      )}
      {isEarly && atLeast(roleOn(job.machine), 'approver') && (
        <button type="button" class="button button-small" onClick={() => showDialog(<EarlyDialog job={job} />)}>
          {t('plan.early')}
        </button>
      )}
      {job.needs_end_confirmation && (
        <button type="button" class="button button-main" onClick={() => showDialog(<EndDialog job={job} />)}>
          {t('plan.confirm_end', { job: job.id })}
        </button>
      )}
    </p>
  );
}

export function HoldButton({ job }: { job: Job }) {
  const on = job.on_hold !== null;
  return (
    <button
      type="button"
      class="button button-small"
      onClick={() => showDialog(on ? <EndHoldDialog job={job} /> : <HoldDialog job={job} />)}
      aria-label={t(on ? 'plan.end_hold_of' : 'plan.hold_of', { job: job.id })}
    >
      {t(on ? 'plan.end_hold' : 'plan.hold')}
    </button>
  );
}

const HoldDialog = ({ job }: { job: Job }) => (
  <OrderDialog
    title={t('plan.hold_title', { job: job.id })}
    confirm={t('plan.hold_confirm')}
    reason={t('plan.hold_reason')}
    send={(key, reason) => orderCalls.hold(job.id, reason, key).then((now) => takeJobs([now]))}
  >
    <p>{t('plan.hold_text')}</p>
  </OrderDialog>
);

const EndHoldDialog = ({ job }: { job: Job }) => (
  <OrderDialog title={t('plan.end_hold_title', { job: job.id })} confirm={t('plan.end_hold_confirm')} send={(key) => orderCalls.endHold(job.id, key).then((now) => takeJobs([now]))}>
    <p>{t('plan.on_hold', { name: job.on_hold?.by ?? '', reason: job.on_hold?.reason ?? '' })}</p>
  </OrderDialog>
);

const RetryDialog = ({ job }: { job: Job }) => (
  <OrderDialog
    title={t('plan.retry_title', { job: job.id })}
    confirm={t('plan.retry_confirm')}
    send={(key) =>
      orderCalls.retry(job.id, key).then((now) => {
        takeJobs([now]);
        location.hash = hrefs.job(now.id);
      })
    }
  >
    <p>{t('plan.retry_text')}</p>
  </OrderDialog>
);

function choiceText(job: Job): string {
  const others = [...jobs.value.values()].filter((one) => one.choice === job.choice && one.id !== job.id && one.state === 'queued').map((one) => one.machine);
  return others.length === 0 ? t('plan.choice_alone') : t('plan.choice', { machines: others.sort().join(', ') });
}

function endText(job: Job): string {
  const check = job.end_check ?? '';
  if (job.needs_end_confirmation) return t('plan.end_waits', { job: job.id, check });
  if (job.end_confirmed_by === null) return t('plan.end_asked', { check });
  return t('plan.end_confirmed', { check, name: job.end_confirmed_by, at: dateTime(job.end_confirmed_at_ms ?? 0), note: job.end_note ?? '' });
}

function TimeDialog({ job }: { job: Job }) {
  const [at, setAt] = useState(localField(job.not_before_ms));
  return (
    <OrderDialog
      title={t('plan.time_title', { job: job.id })}
      confirm={t('plan.time_confirm')}
      blocked={at !== '' && fromLocalField(at) === null ? t('plan.no_time') : null}
      send={(key) => orderCalls.schedule(job.id, fromLocalField(at), key).then((now) => takeJobs([now]))}
    >
      <label class="field">
        <span>{t('plan.time_field')}</span>
        <input type="datetime-local" value={at} onInput={(event) => setAt(event.currentTarget.value)} />
      </label>
      <p class="hint">{t('plan.time_hint')}</p>
    </OrderDialog>
  );
}

const EarlyDialog = ({ job }: { job: Job }) => (
  <OrderDialog
    title={t('arm.title', { job: job.id })}
    confirm={t('arm.confirm', { minutes: kArmMinutes })}
    reason={t('plan.early_reason')}
    send={(key, reason) => orderCalls.armEarly(job.id, kArmMinutes, reason, key).then((now) => takeJobs([now]))}
  >
    <p class="notice tone-waiting">{t('plan.not_before', { at: dateTime(job.not_before_ms ?? 0) })}</p>
    <WhatIsArmed job={job} />
  </OrderDialog>
);

export function EndDialog({ job }: { job: Job }) {
  const [note, setNote] = useState('');
  return (
    <OrderDialog
      title={t('plan.confirm_title', { job: job.id, machine: job.machine })}
      confirm={t('plan.confirm')}
      send={(key) => orderCalls.confirmEnd(job.id, note.trim(), key).then((now) => takeJobs([now]))}
    >
      <p>
        <strong>{job.end_check}</strong>
      </p>
      <p>{t('plan.confirm_text')}</p>
      <label class="field">
        <span>{t('plan.note')}</span>
        <input type="text" maxLength={500} autocomplete="off" value={note} onInput={(event) => setNote(event.currentTarget.value)} />
      </label>
    </OrderDialog>
  );
}
