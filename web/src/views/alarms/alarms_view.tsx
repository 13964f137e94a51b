// All alarms: what is open first, and the history page by page.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import type { Alarm } from '../../api/types';
import { t } from '../../i18n/i18n';
import { Empty } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { byUrgency, isOpen } from '../../rules/alarms';
import { alarms, isLive } from '../../state/shop';
import { loader } from '../../state/loader';
import { AlarmList } from './item';

export function AlarmsView() {
  const [past, setPast] = useState<Alarm[]>([]);
  const [next, setNext] = useState<string | null>(null);
  const [error, setError] = useState<unknown>(null);
  const live = isLive.value;
  const load = async (after: string | null) => {
    setError(null);
    try {
      const page = await loader.order(calls.alarms(after));
      setPast((before) => (after === null ? page.items : [...before, ...page.items]));
      setNext(page.next);
    } catch (failure) {
      setError(failure);
    }
  };
  useEffect(() => {
    if (live) void load(null);
  }, [live, alarms.value.size]);
  const open = [...alarms.value.values()].sort(byUrgency);
  const closed = past.filter((alarm) => !isOpen(alarm) && !alarms.value.has(alarm.id));
  return (
    <>
      <h1 tabIndex={-1}>{t('nav.alarms')}</h1>
      <section aria-label={t('alarms.open')}>
        <h2>{t('alarms.open')}</h2>
        {open.length === 0 ? (
          <Empty>{t('alarms.none_open')}</Empty>
        ) : (
          <AlarmList alarms={open} />
        )}
      </section>
      <section aria-label={t('alarms.history')}>
        <h2>{t('alarms.history')}</h2>
        <Failure error={error} />
        {closed.length === 0 && error === null && <p class="quiet-text">{t('alarms.none_closed')}</p>}
        <AlarmList alarms={closed} />
        {next !== null && (
          <button type="button" class="button" onClick={() => void load(next)}>
            {t('list.more')}
          </button>
        )}
      </section>
    </>
  );
}
