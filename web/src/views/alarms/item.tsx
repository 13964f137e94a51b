// One alarm with what a person does about it.
import { useLayoutEffect, useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import type { Alarm } from '../../api/types';
import { shortTime } from '../../format/times';
import { localText } from '../../format/local_text';
import { reasonText } from '../../format/words';
import { t, wordOf } from '../../i18n/i18n';
import { minutes } from '../../parts/clock';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { Failure } from '../../parts/failure';
import { Icon } from '../../parts/icon';
import { stateOf } from '../../rules/alarms';
import { atLeast } from '../../rules/roles';
import { hrefs } from '../../router';
import { takeAlarms } from '../../state/changes';
import { loader } from '../../state/loader';
import { isLive, roleOn } from '../../state/shop';

const kTones = { critical: 'bad', warning: 'waiting', notice: 'ready' } as const;
const kShelfMinutes = 60;

// A person pressed a button of an alarm, which may leave the list by that and take the button with it.
let pressed = false;

// Alarms one below the other. When the one that was acknowledged leaves, the focus goes to the next one, or to the bell.
export function AlarmList({ alarms }: { alarms: readonly Alarm[] }) {
  useLayoutEffect(() => {
    if (!pressed || document.activeElement !== document.body) return;
    pressed = false;
    document.querySelector<HTMLElement>('.tray .alarm button, .alarm button, .bell-button')?.focus();
  });
  return (
    <ul class="alarm-list">
      {alarms.map((alarm) => (
        <AlarmItem key={alarm.id} alarm={alarm} />
      ))}
    </ul>
  );
}

function AlarmItem({ alarm }: { alarm: Alarm }) {
  const [error, setError] = useState<unknown>(null);
  const send = (call: Promise<Alarm>) => {
    pressed = true;
    setError(null);
    loader.order(call).then((now) => takeAlarms([now]), setError);
  };
  const tone = kTones[alarm.severity] ?? 'waiting';
  return (
    <li class={`alarm tone-${tone}`} data-alarm={alarm.id} data-state={stateOf(alarm, minutes.value)}>
      <Icon shape={tone === 'ready' ? 'ready' : 'bad'} />
      <div class="alarm-words">
        <p>
          <a href={hrefs.machine(alarm.machine)}>
            <strong>{alarm.machine}</strong>
          </a>{' '}
          <strong>{wordOf('alarm_kind', alarm.kind)}</strong>: {alarmText(alarm)}
        </p>
        <p class="quiet-text">{historyOf(alarm).join(', ')}</p>
        <Failure error={error} />
      </div>
      <Buttons alarm={alarm} send={send} />
    </li>
  );
}

const alarmText = (alarm: Alarm): string => localText(alarm.said, reasonText(alarm.text));

// What happened to it, in a line.
function historyOf(alarm: Alarm): string[] {
  const now = minutes.value;
  const state = stateOf(alarm, now);
  const said = [wordOf('alarm_state', state), shortTime(alarm.last_at_ms, now)];
  if (alarm.count > 1) said.push(t('alarm.times', { count: alarm.count, since: shortTime(alarm.raised_at_ms, now) }));
  if (alarm.acknowledged_by !== null) said.push(t('alarm.acknowledged_by', { name: alarm.acknowledged_by }));
  if (state === 'shelved') said.push(t('alarm.shelved_by', { name: alarm.shelved_by ?? '', reason: alarm.shelf_reason ?? '' }));
  return said;
}

function Buttons({ alarm, send }: { alarm: Alarm; send: (call: Promise<Alarm>) => void }) {
  const state = stateOf(alarm, minutes.value);
  if (state === 'closed' || !atLeast(roleOn(alarm.machine), 'operator') || !isLive.value) return null;
  return (
    <div class="alarm-buttons">
      {alarm.acknowledged_by === null && (
        <button type="button" class="button button-small" onClick={() => send(calls.acknowledge(alarm.id))} aria-label={t('alarm.acknowledge_of', { id: alarm.id })}>
          {t('alarm.acknowledge')}
        </button>
      )}
      {alarm.severity !== 'critical' && (state === 'active' || state === 'acknowledged') && (
        <button type="button" class="button button-small" onClick={() => showDialog(<ShelveDialog alarm={alarm} />)} aria-label={t('alarm.shelve_of', { id: alarm.id })}>
          {t('alarm.shelve')}
        </button>
      )}
      {state === 'shelved' && (
        <button type="button" class="button button-small" onClick={() => send(calls.unshelve(alarm.id))}>
          {t('alarm.unshelve')}
        </button>
      )}
    </div>
  );
}

const ShelveDialog = ({ alarm }: { alarm: Alarm }) => (
  <OrderDialog
    title={t('alarm.shelve_title', { machine: alarm.machine })}
    confirm={t('alarm.shelve_confirm', { minutes: kShelfMinutes })}
    reason={t('reason.kept')}
    send={async (key, reason) => takeAlarms([await calls.shelve(alarm.id, kShelfMinutes, reason, key)])}
  >
    <p>{alarmText(alarm)}</p>
    <p class="hint">{t('alarm.shelve_text')}</p>
  </OrderDialog>
);
