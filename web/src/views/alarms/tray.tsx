// The bell in the head: how many alarms ask for a person, and the tray with them. Sound, the title of the page and the
// browser's own notifications follow the same count, in every view.
import { computed, effect, signal } from '@preact/signals';
import { t, wordOf } from '../../i18n/i18n';
import { minutes } from '../../parts/clock';
import { Icon } from '../../parts/icon';
import { asksForPerson, byUrgency } from '../../rules/alarms';
import { hrefs } from '../../router';
import { alarms } from '../../state/shop';
import { AlarmList } from './item';
import { beep, settings, setSetting } from './signals';

export const asking = computed(() => [...alarms.value.values()].filter((alarm) => asksForPerson(alarm, minutes.value)).sort(byUrgency));

const isOpen = signal(false);

export function AlarmBell() {
  const count = asking.value.length;
  const worst = asking.value[0]?.severity === 'critical' ? 'tone-bad' : count > 0 ? 'tone-waiting' : 'tone-quiet';
  return (
    <div class="bell">
      <button
        type="button"
        class={`bell-button ${worst}`}
        aria-expanded={isOpen.value}
        aria-controls="alarm-tray"
        onClick={() => {
          isOpen.value = !isOpen.value;
        }}
      >
        <Icon shape="bell" /> {t('bell.alarms', { count })}
      </button>
      {isOpen.value && <Tray />}
    </div>
  );
}

const kShown = 8;

function Tray() {
  const close = (event: KeyboardEvent) => {
    if (event.key !== 'Escape') return;
    isOpen.value = false;
    document.querySelector<HTMLElement>('.bell-button')?.focus();
  };
  const shown = asking.value.slice(0, kShown);
  return (
    <section id="alarm-tray" class="tray" aria-label={t('nav.alarms')} onKeyDown={close}>
      {shown.length === 0 && <p class="quiet-text">{t('tray.none')}</p>}
      <AlarmList alarms={shown} />
      {asking.value.length > kShown && <p class="quiet-text">{t('tray.more', { count: asking.value.length - kShown })}</p>}
      <div class="tray-foot">
        <a href={hrefs.alarms} onClick={() => (isOpen.value = false)}>
          {t('tray.all')}
        </a>
        <Choice name="sound" label={t('tray.sound')} changed={(on) => on && beep()} />
        {'Notification' in globalThis && (
          <Choice name="notify" label={t('tray.notify')} changed={(on) => on && void Notification.requestPermission()} />
        )}
      </div>
    </section>
  );
}

const Choice = ({ name, label, changed }: { name: 'sound' | 'notify'; label: string; changed: (on: boolean) => void }) => (
  <label class="choice">
    <input
      type="checkbox"
      checked={settings.value[name]}
      onChange={(event) => {
        setSetting(name, event.currentTarget.checked);
        changed(event.currentTarget.checked);
      }}
    />
    {label}
  </label>
);

// A new alarm, not one that was there when the page was loaded.
export function announceAlarms(): () => void {
  let known: Set<number> | null = null;
  return effect(() => {
    const now = asking.value;
    const before = known;
    known = new Set(now.map((alarm) => alarm.id));
    if (before === null) return;
    const fresh = now.filter((alarm) => !before.has(alarm.id));
    if (fresh.length === 0) return;
    if (settings.peek().sound) beep();
    const first = fresh[0];
    if (first && settings.peek().notify && document.hidden && Notification.permission === 'granted')
      new Notification(`${first.machine}: ${wordOf('alarm_kind', first.kind)}`, { body: first.text, tag: `dripfeed ${first.id}` });
  });
}
