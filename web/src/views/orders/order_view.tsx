// One order: its plan, what was made of it, and its jobs. Queueing a job sends nothing; a person arms each at its machine.
import { useEffect } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import { orderCalls } from '../../api/order_calls';
import type { Job, Order } from '../../api/types';
import { dateTime } from '../../format/times';
import { jobWording, orderWording } from '../../format/words';
import { t } from '../../i18n/i18n';
import { programText } from '../../orders/dialogs';
import { AttachedFiles } from '../../parts/attached_files';
import { Badge } from '../../parts/badge';
import { showDialog } from '../../parts/dialog';
import { Facts } from '../../parts/facts';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { hrefs } from '../../router';
import { movesOf } from '../../rules/orders';
import { fitting } from '../../rules/releases';
import { atLeast } from '../../rules/roles';
import { loader } from '../../state/loader';
import { bestRole, jobs as liveJobs, releases, roleOn } from '../../state/shop';
import { JobDialog, MoveDialog, PartsDialog, PlanDialog } from './dialogs';
import { Due, Made, orderName } from './orders_view';

export function OrderView({ id }: { id: number }) {
  const { value: order, error, set, again } = useLoaded(String(id), () => orderCalls.order(id));
  return (
    <>
      <p class="back">
        <a href={hrefs.orders}>{t('orders_view.back')}</a>
      </p>
      <h1 tabIndex={-1}>{order ? t('orders_view.title', { number: orderName(order) }) : t('nav.orders')}</h1>
      <Failure error={error} />
      {order && <Shown order={order} changed={set} again={again} />}
    </>
  );
}

function Shown({ order, changed, again }: { order: Order; changed: (order: Order) => void; again: () => void }) {
  const may = atLeast(bestRole(), 'operator');
  return (
    <>
      <section class="card" aria-label={t('column.order')} data-state={order.state}>
        <Facts
          facts={[
            [t('column.state'), <Badge wording={orderWording(order.state)} />],
            [t('orders_view.reason'), order.reason],
            [t('fact.part'), <a href={hrefs.part(order.part)}>{order.part}</a>],
            [t('column.made'), <Made order={order} />],
            [t('column.due'), <Due order={order} />],
            [t('fact.machine'), order.machine ?? t('orders_view.any_machine')],
            [t('column.priority'), order.priority],
            [t('orders_view.added'), t('library.changed', { name: order.created_by, at: dateTime(order.created_at_ms) })],
            [t('orders_view.metadata'), Object.keys(order.metadata).length > 0 ? <code>{JSON.stringify(order.metadata)}</code> : null],
          ]}
        />
        {may && (
          <div class="dialog-buttons decide-buttons">
            <button type="button" class="button button-main" onClick={() => showDialog(<PartsDialog order={order} changed={changed} />)}>
              {t('orders_view.report_open')}
            </button>
            <button type="button" class="button" onClick={() => showDialog(<PlanDialog order={order} changed={changed} />)}>
              {t('orders_view.plan')}
            </button>
            {movesOf(order).map((to) => (
              <button key={to} type="button" class={to === 'cancelled' ? 'button button-danger' : 'button'} onClick={() => showDialog(<MoveDialog order={order} changed={changed} to={to} />)}>
                {t(`order_move.${to}`)}…
              </button>
            ))}
          </div>
        )}
      </section>
      <AttachedFiles owner={{ order: order.id }} may={atLeast(bestRole(), 'programmer')} />
      <JobsOf order={order} may={may && order.state === 'open'} changed={again} />
    </>
  );
}

function JobsOf({ order, may, changed }: { order: Order; may: boolean; changed: () => void }) {
  const jobs = useLoaded(`jobs ${order.id} ${order.state}`, () => orderCalls.jobsOf(order.id));
  const made = useLoaded(may ? `part ${order.part}` : null, () => deskCalls.programs({ part: order.part }, null));
  useEffect(() => {
    if (may) void loader.order(loader.loadReleases()).catch(() => undefined);
  }, [may]);
  const ofPart = new Set(made.value?.items.map(({ id }) => id));
  const usable = fitting(releases.value, order.machine, ofPart).filter(({ machine }) => atLeast(roleOn(machine), 'operator'));
  const queue = () =>
    showDialog(
      <JobDialog
        order={order}
        releases={usable}
        queued={() => {
          jobs.again();
          changed();
        }}
      />,
    );
  return (
    <section class="card" aria-label={t('nav.jobs')}>
      <h2>{t('nav.jobs')}</h2>
      <Failure error={jobs.error} />
      {jobs.value?.length === 0 && <p class="quiet-text">{t('orders_view.no_job')}</p>}
      {jobs.value && jobs.value.length > 0 && <JobTable rows={jobs.value.map((job) => liveJobs.value.get(job.id) ?? job)} />}
      {may && (
        <button type="button" class="button" onClick={queue}>
          {t('orders_view.job_open')}
        </button>
      )}
    </section>
  );
}

const JobTable = ({ rows }: { rows: readonly Job[] }) => (
  <Table
    label={t('nav.jobs')}
    rows={rows}
    keyOf={({ id }) => id}
    marks={({ id, state }) => ({ 'data-job': String(id), 'data-state': state })}
    columns={[
      { id: 'job', head: t('column.job'), cell: ({ id }) => <a href={hrefs.job(id)}>{id}</a> },
      { id: 'state', head: t('column.state'), cell: ({ state }) => <Badge wording={jobWording(state)} /> },
      { id: 'program', head: t('column.program'), cell: (job) => programText(job) },
      { id: 'machine', head: t('column.machine'), cell: ({ machine }) => <a href={hrefs.machine(machine)}>{machine}</a> },
      { id: 'by', head: t('column.by'), cell: (job) => t('library.changed', { name: job.created_by, at: dateTime(job.created_at_ms) }) },
    ]}
  />
);
