// What the ledger states of a job: the interval in words, then its rows, oldest first, page by page. While the job is
// on the line the interval is asked for again every two seconds.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../api/calls';
import type { Job, LedgerInterval, LedgerRow } from '../api/types';
import { intervalText } from '../format/intervals';
import { count } from '../format/numbers';
import { clockTime } from '../format/times';
import { reasonText } from '../format/words';
import { t } from '../i18n/i18n';
import { Failure } from '../parts/failure';
import { Table } from '../parts/table';
import { isLive } from '../state/shop';
import { loader } from '../state/loader';

const kPage = 50;
const kAgainMs = 2_000;

export function LedgerView({ job }: { job: Job }) {
  const [interval, setBounds] = useState<LedgerInterval | null>(null);
  const [rows, setRows] = useState<LedgerRow[]>([]);
  const [next, setNext] = useState<string | null>(null);
  const [error, setError] = useState<unknown>(null);
  const live = isLive.value;
  const ended = job.ended_at_ms !== null;

  const load = async (after: string | null) => {
    setError(null);
    try {
      const page = await loader.order(calls.ledger(job.id, kPage, after));
      setBounds(page.interval);
      setRows((before) => (after === null ? page.items : [...before, ...page.items]));
      setNext(page.next);
    } catch (failure) {
      setError(failure);
    }
  };
  useEffect(() => {
    if (live) void load(null);
  }, [job.id, job.state, live]);
  useEffect(() => {
    if (!live || ended || job.state === 'queued') return undefined;
    const again = () => calls.ledger(job.id, 1, null).then((page) => setBounds(page.interval), setError);
    const timer = setInterval(() => void again(), kAgainMs);
    return () => clearInterval(timer);
  }, [job.id, job.state, live]);

  // A plain serial line confirms nothing: it has no such column.
  const confirms = interval?.known === 'confirmed';
  return (
    <section class="card" aria-label={t('ledger.title')}>
      <h2>{t('ledger.title')}</h2>
      <Failure error={error} />
      {interval && <p class="interval">{intervalText(interval, job.bytes, job.state)}</p>}
      {interval && interval.high > 0 && <p class="hint">{t('machine.executed_unknown')}</p>}
      {rows.length > 0 && (
        <Table
          label={t('ledger.title')}
          numbers
          rows={rows}
          keyOf={(row) => row.seq}
          columns={[
            { id: 'row', head: t('ledger.row'), cell: (row) => count(row.seq) },
            { id: 'time', head: t('ledger.time'), cell: (row) => clockTime(row.at_ms) },
            { id: 'handed', head: t('wire.handed'), cell: (row) => count(row.handed) },
            { id: 'clocked', head: t('wire.clocked'), cell: (row) => count(row.clocked) },
            confirms && { id: 'confirmed', head: t('wire.confirmed'), cell: (row) => count(row.confirmed) },
            { id: 'reserve', head: t('ledger.reserve'), cell: (row) => count(row.reserve) },
            { id: 'note', head: t('ledger.note'), class: 'note', cell: (row) => reasonText(row.note) },
          ]}
        />
      )}
      {next !== null && <p class="print-only">{t('ledger.more_rows', { count: rows.length })}</p>}
      {next !== null && (
        <button type="button" class="button" onClick={() => void load(next)}>
          {t('ledger.more', { count: kPage })}
        </button>
      )}
    </section>
  );
}
