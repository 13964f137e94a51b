// Queueing with a plan: for one machine or as a choice of a group's, not before a time, with an end that a person confirms.
// It sends nothing and arms nothing.
import { useState } from 'preact/hooks';
import { orderCalls } from '../../api/order_calls';
import { peopleCalls } from '../../api/people_calls';
import type { Release } from '../../api/types';
import { t } from '../../i18n/i18n';
import { OrderDialog } from '../../parts/dialog';
import { Failure } from '../../parts/failure';
import type { Queued } from '../../parts/queued';
import { useLoaded } from '../../parts/use_loaded';
import { fromLocalField } from '../../rules/orders';
import { programName } from '../../state/shop';

interface Props {
  release: Release;
  queued: (made: Queued) => void;
}

export function QueueDialog({ release, queued }: Props) {
  const groups = useLoaded('groups', peopleCalls.groups);
  const [group, setGroup] = useState('');
  const [at, setAt] = useState('');
  const [check, setCheck] = useState('');
  const not_before_ms = fromLocalField(at);
  const plan = { ...(not_before_ms === null ? {} : { not_before_ms }), ...(check.trim() === '' ? {} : { end_check: check.trim() }) };
  const send = async (key: string) => {
    const { program, revision, delivery } = release;
    if (group === '') queued({ jobs: [await orderCalls.planJob({ release: release.id, ...plan }, key)], left_out: [] });
    else queued(await orderCalls.planChoice(group, { program, revision, delivery, ...plan }, key));
  };
  const usable = groups.value?.filter(({ machines }) => machines.length > 1 && machines.includes(release.machine)) ?? [];
  return (
    <OrderDialog
      title={t('queue_plan.title', { program: programName(release.program) ?? t('program.number', { id: release.program }) })}
      confirm={t('queue_plan.confirm')}
      blocked={at !== '' && not_before_ms === null ? t('plan.no_time') : null}
      send={send}
    >
      <Failure error={groups.error} />
      <label class="field">
        <span>{t('queue_plan.for')}</span>
        <select value={group} onChange={(event) => setGroup(event.currentTarget.value)}>
          <option value="">{release.machine}</option>
          {usable.map(({ name, machines }) => (
            <option key={name} value={name}>
              {t('queue_plan.choice', { group: name, machines: machines.join(', ') })}
            </option>
          ))}
        </select>
      </label>
      <p class="hint">{t('queue_plan.choice_hint')}</p>
      <label class="field">
        <span>{t('plan.time_field')}</span>
        <input type="datetime-local" value={at} onInput={(event) => setAt(event.currentTarget.value)} />
      </label>
      <label class="field">
        <span>{t('queue_plan.end_check')}</span>
        <input type="text" maxLength={200} autocomplete="off" placeholder={t('queue_plan.end_example')} value={check} onInput={(event) => setCheck(event.currentTarget.value)} />
      </label>
    </OrderDialog>
  );
}
