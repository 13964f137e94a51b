// Why a transfer stood still or broke off: what people stated, and a button for each reason of the shop, large enough for a
// tablet at the machine. It changes nothing else of the job.
import { useState } from 'preact/hooks';
import { newOrderKey } from '../../api/client';
import { orderCalls } from '../../api/order_calls';
import type { Job } from '../../api/types';
import { dateTime } from '../../format/times';
import { hasWord, t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { atLeast } from '../../rules/roles';
import { loader } from '../../state/loader';
import { isLive, roleOn } from '../../state/shop';

// The usual reasons in the language that is spoken; a shop's own as it wrote them.
export function reasonText(reason: string): string {
  const id = `stop_reason.${reason.replaceAll(' ', '_')}`;
  return hasWord(id) ? t(id) : reason;
}

export function StopReasons({ job }: { job: Job }) {
  const stated = useLoaded(`${job.id}`, () => orderCalls.jobStopReasons(job.id));
  // A transfer that is done asks for no reason; what was stated meanwhile stays to be read.
  const isDone = job.state === 'done';
  if (isDone && stated.value?.length === 0) return null;
  const may = atLeast(roleOn(job.machine), 'operator') && !isDone;
  return (
    <section class="card stop-reasons" aria-label={t('stops.of', { job: job.id })}>
      <h2>{t('stops.of', { job: job.id })}</h2>
      <Failure error={stated.error} />
      {stated.value?.length === 0 && <p class="quiet-text">{t('stops.none')}</p>}
      <ul class="listed">
        {stated.value?.map((one) => (
          <li key={`${one.at_ms} ${one.reason}`}>
            <strong>{reasonText(one.reason)}</strong> {one.note}{' '}
            <span class="quiet-text">{t('library.changed', { name: one.by, at: dateTime(one.at_ms) })}</span>
          </li>
        ))}
      </ul>
      {may && <StateReason job={job} stated={stated.again} />}
    </section>
  );
}

// Of the list alone: from now on nothing is counted.
function StateReason({ job, stated }: { job: Job; stated: () => void }) {
  const offered = useLoaded('offered', () => orderCalls.stopReasons({ machine: job.machine, from_ms: Date.now() }));
  const [note, setNote] = useState('');
  const [error, setError] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const can = isLive.value && !busy;
  const state = async (reason: string) => {
    setBusy(true);
    setError(null);
    try {
      await loader.order(orderCalls.stateStopReason(job.id, reason, note.trim(), newOrderKey()));
      setNote('');
      stated();
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  return (
    <>
      <label class="field">
        <span>{t('stops.note')}</span>
        <input type="text" maxLength={500} autocomplete="off" value={note} onInput={(event) => setNote(event.currentTarget.value)} />
      </label>
      <Failure error={error ?? offered.error} />
      <div class="stop-reason-buttons" role="group" aria-label={t('stops.state')}>
        {offered.value?.offered.map((reason) => (
          <button key={reason} type="button" class="button" aria-disabled={!can} onClick={() => can && void state(reason)}>
            {reasonText(reason)}
          </button>
        ))}
      </div>
    </>
  );
}
