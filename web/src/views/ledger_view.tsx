// What the ledger states of a job: the interval in words, then its rows, oldest first, page by page. While the job is
// on the line the interval is asked for again every two seconds.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../api/calls';
import type { Job, LedgerInterval, LedgerRow } from '../api/types';
import { intervalText } from '../format/intervals';
import { count } from '../format/numbers';
import { clockTime } from '../format/times';
import { reasonText } from '../format/words';
import { isLive } from '../state/select';
import { useDesk } from './context';
import { Failure } from './dialog';

const kPage = 50;
const kAgainMs = 2_000;

export function LedgerView({ job }: { job: Job }) {
  const { state, sync } = useDesk();
  const [interval, setBounds] = useState<LedgerInterval | null>(null);
  const [rows, setRows] = useState<LedgerRow[]>([]);
  const [next, setNext] = useState<string | null>(null);
  const [error, setError] = useState<unknown>(null);
  const live = isLive(state);
  const ended = job.ended_at_ms !== null;

  const load = async (after: string | null) => {
    setError(null);
    try {
      const page = await sync.order(calls.ledger(job.id, kPage, after));
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

  return (
    <section class="card" aria-label="Ledger">
      <h2>Ledger</h2>
      <Failure error={error} />
      {interval && <p class="interval">{intervalText(interval, job.bytes, ended)}</p>}
      {interval && interval.high > 0 && <p class="hint">What the control executed of it is not known here.</p>}
      {rows.length > 0 && <Rows rows={rows} confirms={interval?.known === 'confirmed'} />}
      {next !== null && (
        <button type="button" class="button" onClick={() => void load(next)}>
          Show the next {kPage} rows
        </button>
      )}
    </section>
  );
}

// A plain serial line confirms nothing: it has no such column.
const Rows = ({ rows, confirms }: { rows: LedgerRow[]; confirms: boolean }) => (
  <table class="table table-numbers">
    <thead>
      <tr>
        <th scope="col">Row</th>
        <th scope="col">Time</th>
        <th scope="col">Handed</th>
        <th scope="col">Clocked</th>
        {confirms && <th scope="col">Confirmed</th>}
        <th scope="col">Reserve</th>
        <th scope="col">Note</th>
      </tr>
    </thead>
    <tbody>
      {rows.map((row) => (
        <tr key={row.seq}>
          <td data-label="Row">{count(row.seq)}</td>
          <td data-label="Time">{clockTime(row.at_ms)}</td>
          <td data-label="Handed">{count(row.handed)}</td>
          <td data-label="Clocked">{count(row.clocked)}</td>
          {confirms && <td data-label="Confirmed">{count(row.confirmed)}</td>}
          <td data-label="Reserve">{count(row.reserve)}</td>
          <td data-label="Note" class="note">
            {reasonText(row.note)}
          </td>
        </tr>
      ))}
    </tbody>
  </table>
);
