// Transfers of the past: filtered by the server, summed up, and as a file for a spreadsheet.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import { orderCalls } from '../../api/order_calls';
import type { HistoryGroup, HistorySums, Job, JobState } from '../../api/types';
import { bytes, count, wholePercent } from '../../format/numbers';
import { dateTime, duration } from '../../format/times';
import { jobReason, jobWording } from '../../format/words';
import { t } from '../../i18n/i18n';
import { programText } from '../../orders/dialogs';
import { Badge } from '../../parts/badge';
import { Choice, MachineField } from '../../parts/choice';
import { minutes } from '../../parts/clock';
import { CsvButton } from '../../parts/csv_button';
import { Empty, GoTo } from '../../parts/empty';
import { Facts, type Fact } from '../../parts/facts';
import { Failure } from '../../parts/failure';
import { Table, type Column } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { changeQuery, hrefs } from '../../router';
import { isoTime, type CsvColumn } from '../../rules/csv';
import { againstForecast, durationOf, kEndedStates, kGroupings, kRanges, rangeBegin, type Grouping } from '../../rules/history';
import { loader } from '../../state/loader';
import { takeJobs } from '../../state/changes';
import { reasonText } from './stop_reasons';

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
      {!loading && rows.length === 0 && error === null && <NoTransfer isFiltered={state !== '' || machine !== ''} />}
      {rows.length > 0 && (
        <Sums state={state} machine={machine} by={kGroupings.find((one) => one === query.get('by')) ?? ''} days={kRanges.find((one) => String(one) === query.get('days')) ?? null} />
      )}
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

// Of all transfers that fit the filter, as the server adds them up.
function Sums({ state, machine, by, days }: { state: JobState | ''; machine: string; by: Grouping | ''; days: number | null }) {
  const from_ms = rangeBegin(days, minutes.value);
  const { value, error } = useLoaded(`${state} ${machine} ${by} ${from_ms}`, () => orderCalls.historySums(by || 'machine', { state, machine, from_ms }));
  return (
    <section class="card" aria-label={t('past.sums')}>
      <h2>{t('past.sums')}</h2>
      <Failure error={error} />
      {value && <SumFacts sums={value.all} />}
      <div class="search-line">
        <Choice
          label={t('past.range')}
          value={days === null ? '' : String(days)}
          options={kRanges.map((one) => [String(one), t('past.days', { days: one })] as const)}
          empty={t('past.always')}
          change={(one) => changeQuery('days', one || null)}
        />
        <Choice
          label={t('past.by')}
          value={by}
          options={kGroupings.map((one) => [one, t(`past_by.${one}`)] as const)}
          empty={t('past.by_nothing')}
          change={(one) => changeQuery('by', one || null)}
        />
      </div>
      {value && by !== '' && <Groups groups={value.groups} by={by} />}
      <StopsByReason machine={machine} from_ms={from_ms} />
    </section>
  );
}

const SumFacts = ({ sums }: { sums: HistorySums['all'] }) => (
  <Facts
    facts={[
      [t('nav.jobs'), count(sums.jobs)],
      ...kEndedStates.map((state): Fact => [jobWording(state).text, sums[state] > 0 ? count(sums[state]) : null]),
      [t('past.bytes'), bytes(sums.bytes)],
      [t('past.time'), duration(sums.feeding_s)],
      [t('past.held'), sums.held_jobs > 0 ? heldText(sums) : null],
      [t('past.line_use'), sums.line_use === null ? null : wholePercent(sums.line_s, sums.line_free_s)],
      [t('past.forecast'), sums.forecast_jobs > 0 ? forecastText(sums) : null],
    ]}
  />
);

const heldText = ({ held_s, holds, holds_jobs }: HistorySums['all']): string =>
  holds_jobs > 0 ? t('past.held_times', { time: duration(held_s), count: holds }) : duration(held_s);

const forecastText = (sums: HistorySums['all']): string =>
  t('past.against', { took: duration(sums.forecast_took_s), expected: duration(sums.forecast_s), jobs: sums.forecast_jobs });

function Groups({ groups, by }: { groups: readonly HistoryGroup[]; by: Grouping }) {
  const head = t(`past_by.${by}`);
  return (
    <>
      {by === 'shift' && <p class="hint">{t('past.shifts')}</p>}
      {by === 'part' && <p class="hint">{t('past.parts')}</p>}
      <Table
        label={t('past.sums_by', { by: head })}
        rows={groups}
        keyOf={({ name }) => name}
        columns={[
          { id: 'name', head, by: ({ name }) => name, cell: ({ name }) => name || t('past.no_part') },
          { id: 'jobs', head: t('nav.jobs'), by: ({ jobs }) => jobs, cell: ({ jobs }) => count(jobs) },
          ...kEndedStates.map((state): Column<HistoryGroup> => ({ id: state, head: jobWording(state).text, by: (group) => group[state], cell: (group) => count(group[state]) })),
          { id: 'bytes', head: t('past.bytes'), by: (group) => group.bytes, cell: (group) => bytes(group.bytes) },
          { id: 'time', head: t('past.time'), by: ({ feeding_s }) => feeding_s, cell: ({ feeding_s }) => duration(feeding_s) },
          { id: 'held', head: t('past.held'), by: ({ held_s }) => held_s, cell: (group) => (group.held_jobs > 0 ? duration(group.held_s) : '–') },
          { id: 'use', head: t('past.line_use'), by: ({ line_use }) => line_use, cell: (group) => wholePercent(group.line_s, group.line_free_s) },
          {
            id: 'forecast',
            head: t('past.of_forecast'),
            by: againstForecast,
            cell: (group) => wholePercent(group.forecast_took_s, group.forecast_s),
          },
        ]}
      />
      <CsvButton name={`sums-by-${by}`} columns={groupCsv(by)} rows={groups} />
    </>
  );
}

const kFigures = [
  'jobs', 'done', 'failed', 'cancelled', 'interrupted', 'bytes', 'fed', 'held_jobs', 'holds_jobs', 'holds', 'line_jobs', 'forecast_jobs',
  'feeding_s', 'held_s', 'line_s', 'line_free_s', 'forecast_s', 'forecast_took_s', 'line_use',
] as const satisfies readonly (keyof HistorySums['all'])[];

const groupCsv = (by: Grouping): CsvColumn<HistoryGroup>[] => [
  { head: by, of: ({ name }) => name },
  { head: 'from', of: ({ from_ms }) => isoTime(from_ms) },
  { head: 'to', of: ({ to_ms }) => isoTime(to_ms) },
  ...kFigures.map((figure): CsvColumn<HistoryGroup> => ({ head: figure, of: (group) => group[figure] })),
];

// How often people stated which reason, in the time of the sums.
function StopsByReason({ machine, from_ms }: { machine: string; from_ms: number | null }) {
  const { value, error } = useLoaded(`stops ${machine} ${from_ms ?? ''}`, () => orderCalls.stopReasons({ machine, from_ms }));
  return (
    <section aria-label={t('stops.by_reason')}>
      <h3>{t('stops.by_reason')}</h3>
      <Failure error={error} />
      {value?.counts.length === 0 && <p class="quiet-text">{t('stops.no_count')}</p>}
      {value && value.counts.length > 0 && (
        <Table
          label={t('stops.by_reason')}
          rows={value.counts}
          keyOf={(one) => `${one.machine} ${one.reason}`}
          columns={[
            { id: 'reason', head: t('column.reason'), by: ({ reason }) => reasonText(reason), cell: ({ reason }) => reasonText(reason) },
            { id: 'machine', head: t('column.machine'), by: (one) => one.machine, cell: (one) => <a href={hrefs.machine(one.machine)}>{one.machine}</a> },
            { id: 'count', head: t('stops.count'), by: (one) => one.count, cell: (one) => count(one.count) },
          ]}
        />
      )}
    </section>
  );
}

const History = ({ rows }: { rows: readonly Job[] }) => (
  <Table
    label={t('title.history')}
    rows={rows}
    name="history"
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

const NoTransfer = ({ isFiltered }: { isFiltered: boolean }) => (
  <Empty action={isFiltered ? <GoTo href={hrefs.history}>{t('list.show_all')}</GoTo> : <GoTo href={hrefs.jobs}>{t('nav.jobs')}</GoTo>}>
    {t(isFiltered ? 'past.none' : 'past.empty')}
  </Empty>
);

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
