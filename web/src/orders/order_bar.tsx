// The orders of one machine in three places that never move: to stop stands first, then what sets something going, then
// what ends the job. A place that has nothing to do now stays, and says why; its button keeps the focus.
import { signal } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../api/calls';
import { newOrderKey } from '../api/client';
import type { Job, MachineStatus } from '../api/types';
import { t } from '../i18n/i18n';
import { minutes } from '../parts/clock';
import { showDialog } from '../parts/dialog';
import { Icon, type Shape } from '../parts/icon';
import { showLazyDialog } from '../parts/lazy';
import { offerFor, type Because, type JobAction } from '../rules/job_actions';
import { hasJob, isTorn } from '../rules/lines';
import { atLeast } from '../rules/roles';
import { loader } from '../state/loader';
import { endedOf, isLive, jobs, nextOf, roleOn, textOf, type Machine } from '../state/shop';
import { ArmDialog, CancelDialog, ResetDialog, ResumeDialog } from './dialogs';

interface Place {
  label: string;
  kind: 'stop' | 'main' | 'danger' | 'plain';
  press: (() => void) | null; // null: nothing to do here now
  why?: string; // for the one who points at it
  icon?: Shape;
  name?: string; // what a screen reader says
}

// Stops that were asked for and are not seen yet, by job.
const stopping = signal<ReadonlySet<number>>(new Set());

function setStopping(id: number, on: boolean): void {
  const next = new Set(stopping.peek());
  if (on) next.add(id);
  else next.delete(id);
  stopping.value = next;
}

export function OrderBar({ machine }: { machine: Machine }) {
  const [error, setError] = useState<string | null>(null);
  const may = atLeast(roleOn(machine.name), 'operator');
  const core = machine.core.value;
  const onLine = hasJob(core) && core.job !== null ? (jobs.value.get(core.job) ?? null) : null;
  const next = onLine ? null : (nextOf(machine.name));
  const job = onLine ?? next;
  const ended = onLine ? null : endedOf(machine.name);
  const offer = job ? offerFor(job, core, roleOn(machine.name), isLive.value, job.not_before_ms === null ? 0 : minutes.value, ended) : { actions: [] as JobAction[], because: null };

  const now = async (id: number, call: (id: number, key: string) => Promise<Job>, isStop: boolean) => {
    setError(null);
    if (isStop) setStopping(id, true);
    try {
      await loader.order(call(id, newOrderKey()));
    } catch (failure) {
      setError(textOf(failure));
      setStopping(id, false);
    }
  };
  // What was asked for has happened, or there is nothing left to stop.
  const canStop = offer.actions.includes('stop');
  const id = job?.id;
  useEffect(() => {
    if (!canStop && id !== undefined && stopping.peek().has(id)) setStopping(id, false);
  }, [canStop, id]);
  const places = [
    stopPlace(onLine, offer.actions, core.stop_wanted, (id) => void now(id, calls.stop, true), (id) => void now(id, calls.cancel, false)),
    confirmPlace(machine.name, core, ended, (failure) => setError(textOf(failure))) ?? mainPlace(job, offer.actions, offer.because),
    cancelPlace(job, offer.actions),
  ];
  return (
    <div class="orders-bar">
      <div class="orders-places" role="group" aria-label={t('orders.of', { machine: machine.name })}>
        {places.map((place, index) => (
          <OrderButton key={index} place={may ? place : { ...place, press: null, why: t('orders.only_operator') }} />
        ))}
      </div>
      <p class="orders-error" role="alert" title={error ?? undefined}>
        {error}
      </p>
    </div>
  );
}

const OrderButton = ({ place }: { place: Place }) => (
  <button
    type="button"
    class={`order order-${place.kind}`}
    aria-disabled={place.press === null}
    aria-label={place.name ?? place.label}
    title={place.press === null ? place.why : undefined}
    onClick={() => place.press?.()}
  >
    {place.icon && <Icon shape={place.icon} />}
    <span>{place.label}</span>
  </button>
);

function stopPlace(job: Job | null, actions: JobAction[], wanted: boolean, stop: (id: number) => void, disarm: (id: number) => void): Place {
  if (job && actions.includes('disarm'))
    return { label: t('order.disarm'), name: t('order.disarm_job', { job: job.id }), kind: 'stop', icon: 'stop', press: () => disarm(job.id) };
  if (!job || !actions.includes('stop')) {
    return { label: t('order.stop'), kind: 'stop', icon: 'stop', press: null, why: t('order.nothing_to_stop') };
  }
  // It may be pressed again: a stop does no harm, and one that was lost must not be the last.
  const label = wanted || stopping.value.has(job.id) ? t('order.stopping') : t('order.stop');
  return { label, name: t('order.stop_job', { job: job.id }), kind: 'stop', icon: 'stop', press: () => stop(job.id) };
}

// What a person confirms before anything is armed there: the reset after a torn block, or what the last job's end asks for.
function confirmPlace(machine: string, core: Pick<MachineStatus, 'line' | 'needs_confirmation'>, ended: Job | null, failed: (error: unknown) => void): Place | null {
  const confirm = (words: Pick<Place, 'label' | 'name' | 'kind'>, press: () => void): Place => ({ ...words, press: isLive.value ? press : null, why: t('because.not_live') });
  if (isTorn(core)) return confirm({ label: t('order.reset'), name: t('order.reset_of', { machine }), kind: 'danger' }, () => showDialog(<ResetDialog machine={machine} torn={core.needs_confirmation} />));
  if (!ended) return null;
  // Its dialog is loaded with what else is planned of jobs.
  const show = () => void showLazyDialog(() => import('../views/orders/plans'), ({ EndDialog }) => <EndDialog job={ended} />).catch(failed);
  return confirm({ label: t('order.confirm_end'), name: t('order.confirm_end_of', { job: ended.id }), kind: 'main' }, show);
}

function mainPlace(job: Job | null, actions: JobAction[], because: Because | null): Place {
  if (job && actions.includes('arm'))
    return { label: t('order.arm', { job: job.id }), name: t('order.arm_job', { job: job.id }), kind: 'main', press: () => showDialog(<ArmDialog id={job.id} />) };
  if (job && actions.includes('resume'))
    return { label: t('order.resume'), name: t('order.resume_job', { job: job.id }), kind: 'main', press: () => showDialog(<ResumeDialog id={job.id} />) };
  const why = because ? t(because.id, because.values) : t(job ? 'order.nothing_to_start' : 'order.nothing_queued');
  return { label: t('order.arm_none'), kind: 'main', press: null, why };
}

function cancelPlace(job: Job | null, actions: JobAction[]): Place {
  const can = job && (actions.includes('cancel') || actions.includes('withdraw'));
  if (!can) return { label: t('order.cancel'), kind: 'plain', press: null, why: t('order.nothing_to_cancel') };
  return { label: t('order.cancel'), name: t('order.cancel_job', { job: job.id }), kind: 'plain', press: () => showDialog(<CancelDialog id={job.id} />) };
}
