// All alarms: what is open first, and the history page by page.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import type { Alarm } from '../../api/types';
import { t } from '../../i18n/i18n';
import { MachineField } from '../../parts/choice';
import { CsvButton } from '../../parts/csv_button';
import { Empty } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { byUrgency, isOpen } from '../../rules/alarms';
import { isoTime, type CsvColumn } from '../../rules/csv';
import { alarms, isLive } from '../../state/shop';
import { loader } from '../../state/loader';
import { AlarmList } from './item';

export function AlarmsView() {
  const [past, setPast] = useState<Alarm[]>([]);
  const [next, setNext] = useState<string | null>(null);
  const [error, setError] = useState<unknown>(null);
  const [machine, setMachine] = useState('');
  const live = isLive.value;
  const load = async (after: string | null) => {
    setError(null);
    try {
      const page = await loader.order(calls.alarms(after, machine || undefined));
      setPast((before) => (after === null ? page.items : [...before, ...page.items]));
      setNext(page.next);
    } catch (failure) {
      setError(failure);
    }
  };
  useEffect(() => {
    if (live) void load(null);
  }, [live, alarms.value.size, machine]);
  const isOfMachine = (alarm: Alarm): boolean => machine === '' || alarm.machine === machine;
  const open = [...alarms.value.values()].filter(isOfMachine).sort(byUrgency);
  const closed = past.filter((alarm) => isOfMachine(alarm) && !isOpen(alarm) && !alarms.value.has(alarm.id));
  return (
    <>
      <h1 tabIndex={-1}>{t('nav.alarms')}</h1>
      <div class="search-line" role="search">
        <MachineField label={t('column.machine')} value={machine} empty={t('list.all')} change={setMachine} />
        <CsvButton name="alarms" columns={kCsv} rows={[...open, ...closed]} />
      </div>
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

const kCsv: CsvColumn<Alarm>[] = [
  { head: 'alarm', of: ({ id }) => id },
  { head: 'severity', of: ({ severity }) => severity },
  { head: 'kind', of: ({ kind }) => kind },
  { head: 'machine', of: ({ machine }) => machine },
  { head: 'job', of: ({ job }) => job },
  { head: 'text', of: ({ text }) => text },
  { head: 'count', of: ({ count }) => count },
  { head: 'raised', of: ({ raised_at_ms }) => isoTime(raised_at_ms) },
  { head: 'last', of: ({ last_at_ms }) => isoTime(last_at_ms) },
  { head: 'cleared', of: ({ cleared_at_ms }) => isoTime(cleared_at_ms) },
  { head: 'acknowledged_by', of: ({ acknowledged_by }) => acknowledged_by },
  { head: 'acknowledged', of: ({ acknowledged_at_ms }) => isoTime(acknowledged_at_ms) },
];
