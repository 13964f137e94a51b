// Transfers of the past: filtered by the server, summed up, and as a file for a spreadsheet.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import type { Job, JobState } from '../../api/types';
import { bytes, count } from '../../format/numbers';
import { dateTime, duration } from '../../format/times';
import { jobReason, jobWording } from '../../format/words';
import { t } from '../../i18n/i18n';
import { programText } from '../../orders/dialogs';
import { Badge } from '../../parts/badge';
import { CsvButton } from '../../parts/csv_button';
import { Empty } from '../../parts/empty';
import { Facts, type Fact } from '../../parts/facts';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { changeQuery, hrefs } from '../../router';
import { isoTime, type CsvColumn } from '../../rules/csv';
import { durationOf, kEndedStates, sumsOf } from '../../rules/history';
import { loader } from '../../state/loader';
import { machines } from '../../state/shop';
import { takeJobs } from '../../state/changes';

const kPage = 200;

export function HistoryView({ query }: { query: URLSearchParams }) {
  const state = kEndedStates.find((one) => one === query.get('state')) ?? '';
  const machine = query.get('machine') ?? '';
  const { rows, more, error, loading } = useHistory(state, machine);
  return (
    <>
      <p class="back">
        <a href={hrefs.jobs}>{t('job.all')}</a>
      </p>
      <h1 tabIndex={-1}>{t('title.history')}</h1>
      <div class="search-line" role="search">
        <Choice label={t('column.state')} value={state} name="state" options={kEndedStates.map((one) => [one, jobWording(one).text])} />
        <Choice label={t('column.machine')} value={machine} name="machine" options={[...machines.value.keys()].map((one) => [one, one])} />
        <CsvButton name="jobs" columns={kCsv} rows={rows} />
      </div>
      <Failure error={error} />
      {!loading && rows.length === 0 && error === null && <Empty>{t('past.none')}</Empty>}
      {rows.length > 0 && <Sums rows={rows} isWhole={more === null} />}
      {rows.length > 0 && <History rows={rows} />}
      {more && (
        <button type="button" class="button" onClick={more}>
          {t('list.more')}
        </button>
      )}
    </>
  );
}

function useHistory(state: JobState | '', machine: string) {
  const key = `${state} ${machine}`;
  const ask = (after: string | null) => calls.jobs({ state, machine, limit: kPage, ...(after ? { after } : {}) });
  const first = useLoaded(key, () => ask(null));
  const [older, setOlder] = useState<{ of: unknown; items: Job[]; next: string | null } | null>(null);
  const [failed, setFailed] = useState<unknown>(null);
  const later = older !== null && older.of === first.value ? older : null;
  const all = [...(first.value?.items ?? []), ...(later?.items ?? [])];
  const next = later ? later.next : (first.value?.next ?? null);
  // Their programs' names.
  useEffect(() => {
    takeJobs(all);
    loader.completeNames();
  }, [first.value, older]);
  const more = () => {
    setFailed(null);
    loader.order(ask(next)).then((page) => setOlder({ of: first.value, items: [...(later?.items ?? []), ...page.items], next: page.next }), setFailed);
  };
  return { rows: all.filter(({ ended_at_ms }) => ended_at_ms !== null), more: next === null ? null : more, error: first.error ?? failed, loading: first.loading };
}

interface ChoiceProps {
  label: string;
  name: string;
  value: string;
  options: readonly (readonly [value: string, text: string])[];
}

const Choice = ({ label, name, value, options }: ChoiceProps) => (
  <label class="field">
    <span>{label}</span>
    <select value={value} onChange={(event) => changeQuery(name, event.currentTarget.value || null)}>
      <option value="">{t('list.all')}</option>
      {options.map(([one, text]) => (
        <option key={one} value={one}>
          {text}
        </option>
      ))}
    </select>
  </label>
);

function Sums({ rows, isWhole }: { rows: readonly Job[]; isWhole: boolean }) {
  const sums = sumsOf(rows);
  return (
    <section class="card" aria-label={t('past.sums')}>
      <h2>{t('past.sums')}</h2>
      {!isWhole && <p class="hint">{t('past.of_shown', { count: rows.length })}</p>}
      <Facts
        facts={[
          [t('nav.jobs'), count(rows.length)],
          ...kEndedStates.map((state): Fact => [jobWording(state).text, sums.states[state] > 0 ? count(sums.states[state]) : null]),
          [t('past.bytes'), bytes(sums.bytes)],
          [t('past.time'), duration(sums.seconds)],
        ]}
      />
    </section>
  );
}

const History = ({ rows }: { rows: readonly Job[] }) => (
  <Table
    label={t('title.history')}
    rows={rows}
    keyOf={({ id }) => id}
    marks={({ id, state }) => ({ 'data-job': String(id), 'data-state': state })}
    columns={[
      { id: 'job', head: t('column.job'), by: ({ id }) => id, cell: ({ id }) => <a href={hrefs.job(id)}>{id}</a> },
      {
        id: 'state',
        head: t('column.state'),
        by: ({ state }) => jobWording(state).text,
        cell: (job) => (
          <>
            <Badge wording={jobWording(job.state)} />
            {job.state !== 'done' && job.reason !== '' && <span class="reason">{jobReason(job)}</span>}
          </>
        ),
      },
      { id: 'program', head: t('column.program'), by: programText, cell: (job) => <a href={hrefs.program(job.program)}>{programText(job)}</a> },
      { id: 'machine', head: t('column.machine'), by: ({ machine }) => machine, cell: ({ machine }) => machine },
      { id: 'order', head: t('column.order'), by: ({ order }) => order, cell: ({ order }) => order !== null && <a href={hrefs.order(order)}>{order}</a> },
      { id: 'bytes', head: t('past.bytes'), by: (job) => job.bytes, cell: (job) => bytes(job.bytes) },
      { id: 'time', head: t('past.time'), by: durationOf, cell: (job) => durationText(job) },
      { id: 'ended', head: t('time.ended'), by: ({ ended_at_ms }) => ended_at_ms, cell: ({ ended_at_ms }) => dateTime(ended_at_ms ?? 0) },
    ]}
  />
);

const durationText = (job: Job): string => {
  const seconds = durationOf(job);
  return seconds === null ? '' : duration(seconds);
};

const kCsv: CsvColumn<Job>[] = [
  { head: 'job', of: ({ id }) => id },
  { head: 'state', of: ({ state }) => state },
  { head: 'reason', of: ({ reason }) => reason },
  { head: 'program', of: programText },
  { head: 'revision', of: ({ revision }) => revision },
  { head: 'sha256', of: ({ sha256 }) => sha256 },
  { head: 'machine', of: ({ machine }) => machine },
  { head: 'release', of: ({ release }) => release },
  { head: 'order', of: ({ order }) => order },
  { head: 'delivery', of: ({ delivery }) => delivery },
  { head: 'bytes', of: (job) => job.bytes },
  { head: 'queued_by', of: ({ created_by }) => created_by },
  { head: 'armed_by', of: ({ armed_by }) => armed_by },
  { head: 'queued', of: ({ created_at_ms }) => isoTime(created_at_ms) },
  { head: 'started', of: ({ started_at_ms }) => isoTime(started_at_ms) },
  { head: 'ended', of: ({ ended_at_ms }) => isoTime(ended_at_ms) },
  { head: 'seconds', of: durationOf },
];
