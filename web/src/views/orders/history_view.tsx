// Transfers of the past: filtered by the server, summed up, and as a file for a spreadsheet.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import { orderCalls } from '../../api/order_calls';
import type { Job, JobState } from '../../api/types';
import { bytes, count } from '../../format/numbers';
import { dateTime, duration } from '../../format/times';
import { jobReason, jobWording } from '../../format/words';
import { t } from '../../i18n/i18n';
import { programText } from '../../orders/dialogs';
import { Badge } from '../../parts/badge';
import { Choice, MachineField } from '../../parts/choice';
import { CsvButton } from '../../parts/csv_button';
import { Empty } from '../../parts/empty';
import { Facts, type Fact } from '../../parts/facts';
import { Failure } from '../../parts/failure';
import { Table, type Column } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { changeQuery, hrefs } from '../../router';
import { isoTime, type CsvColumn } from '../../rules/csv';
import { durationOf, groupsOf, kEndedStates, kGroupings, sumsOf, type Group, type Grouping } from '../../rules/history';
import { loader } from '../../state/loader';
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
        <Choice
          label={t('column.state')}
          value={state}
          options={kEndedStates.map((one) => [one, jobWording(one).text] as const)}
          empty={t('list.all')}
          change={(one) => changeQuery('state', one || null)}
        />
        <MachineField label={t('column.machine')} value={machine} empty={t('list.all')} change={(one) => changeQuery('machine', one || null)} />
        <CsvButton name="jobs" columns={kCsv} rows={rows} />
      </div>
      <Failure error={error} />
      {!loading && rows.length === 0 && error === null && <Empty>{t('past.none')}</Empty>}
      {rows.length > 0 && <Sums rows={rows} isWhole={more === null} by={kGroupings.find((one) => one === query.get('by')) ?? ''} />}
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

function Sums({ rows, isWhole, by }: { rows: readonly Job[]; isWhole: boolean; by: Grouping | '' }) {
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
      <Choice
        label={t('past.by')}
        value={by}
        options={kGroupings.map((one) => [one, t(`past_by.${one}`)] as const)}
        empty={t('past.by_nothing')}
        change={(one) => changeQuery('by', one || null)}
      />
      {by !== '' && <Groups rows={rows} by={by} />}
    </section>
  );
}

// Of the part by its order; a transfer without one is of no part that is known.
function Groups({ rows, by }: { rows: readonly Job[]; by: Grouping }) {
  const orders = useLoaded(by === 'part' ? 'orders' : null, () => orderCalls.orders(''));
  const parts = new Map(orders.value?.map(({ id, part }) => [id, part]));
  if (by === 'part' && !orders.value) return <Failure error={orders.error} />;
  const groups = groupsOf(rows, by, (order) => (order === null ? '' : (parts.get(order) ?? '')));
  const head = t(`past_by.${by}`);
  return (
    <>
      {by === 'shift' && <p class="hint">{t('past.shifts')}</p>}
      <Table
        label={t('past.sums_by', { by: head })}
        rows={groups}
        keyOf={({ name }) => name}
        columns={[
          { id: 'name', head, by: ({ name }) => name, cell: ({ name }) => name || t('past.no_part') },
          { id: 'jobs', head: t('nav.jobs'), by: ({ jobs }) => jobs, cell: ({ jobs }) => count(jobs) },
          ...kEndedStates.map(
            (state): Column<Group> => ({ id: state, head: jobWording(state).text, by: ({ sums }) => sums.states[state], cell: ({ sums }) => count(sums.states[state]) }),
          ),
          { id: 'bytes', head: t('past.bytes'), by: ({ sums }) => sums.bytes, cell: ({ sums }) => bytes(sums.bytes) },
          { id: 'time', head: t('past.time'), by: ({ sums }) => sums.seconds, cell: ({ sums }) => duration(sums.seconds) },
        ]}
      />
      <CsvButton name={`sums-by-${by}`} columns={groupCsv(by)} rows={groups} />
    </>
  );
}

const groupCsv = (by: Grouping): CsvColumn<Group>[] => [
  { head: by, of: ({ name }) => name },
  { head: 'jobs', of: ({ jobs }) => jobs },
  ...kEndedStates.map((state): CsvColumn<Group> => ({ head: state, of: ({ sums }) => sums.states[state] })),
  { head: 'bytes', of: ({ sums }) => sums.bytes },
  { head: 'seconds', of: ({ sums }) => Math.round(sums.seconds * 10) / 10 },
];

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
