// What is to be made: orders of the planner or of people, the soonest first, with what was made of them.
import { useMemo } from 'preact/hooks';
import { orderCalls } from '../../api/order_calls';
import type { Order, OrderState } from '../../api/types';
import { count } from '../../format/numbers';
import { dateTime } from '../../format/times';
import { orderWording } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Badge } from '../../parts/badge';
import { minutes } from '../../parts/clock';
import { Choice, MachineField } from '../../parts/choice';
import { CsvButton } from '../../parts/csv_button';
import { showDialog } from '../../parts/dialog';
import { Empty, GoTo } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { changeQuery, goUnlessLeft, hrefs } from '../../router';
import { isoTime, type CsvColumn } from '../../rules/csv';
import { byUrgency, filtered, isLate, kOrderStates } from '../../rules/orders';
import { atLeast } from '../../rules/roles';
import { bestRole } from '../../state/shop';
import { NewOrderDialog } from './dialogs';

const stateOf = (text: string | null): OrderState | '' => (text === 'all' ? '' : (kOrderStates.find((one) => one === text) ?? 'open'));

export function OrdersView({ query }: { query: URLSearchParams }) {
  const filter = { state: stateOf(query.get('state')), machine: query.get('machine') ?? '', words: query.get('q') ?? '' };
  const { value, error, loading } = useLoaded(`orders ${filter.state}`, () => orderCalls.orders(filter.state));
  const rows = useMemo(() => filtered(value ?? [], filter).sort(byUrgency), [value, filter.state, filter.machine, filter.words]);
  const may = atLeast(bestRole(), 'operator');
  const add = (
    <button type="button" class="button button-main" onClick={newOrder}>
      {t('orders_view.add')}
    </button>
  );
  return (
    <>
      <h1 tabIndex={-1}>{t('nav.orders')}</h1>
      <p class="lead">{t('orders_view.lead')}</p>
      <Filters filter={filter}>
        {may && add}
        <CsvButton name="orders" columns={kCsv} rows={rows} />
      </Filters>
      <Failure error={error} />
      {loading && !value && (
        <p class="waiting" role="status">
          {t('page.loading')}
        </p>
      )}
      {value && rows.length === 0 && <NoOrder isEveryOne={value.length === 0 && filter.state === 'open'} add={may ? add : null} />}
      {rows.length > 0 && <Orders rows={rows} />}
    </>
  );
}

const NoOrder = ({ isEveryOne, add }: { isEveryOne: boolean; add: preact.ComponentChildren }) =>
  isEveryOne ? (
    <Empty action={add}>{t(add === null ? 'orders_view.no_open_viewer' : 'orders_view.no_open')}</Empty>
  ) : (
    <Empty action={<GoTo href={`${hrefs.orders}?state=all`}>{t('list.show_all')}</GoTo>}>{t('orders_view.none')}</Empty>
  );

function newOrder(): void {
  const follow = goUnlessLeft();
  showDialog(<NewOrderDialog made={(order) => follow(hrefs.order(order.id))} />);
}

interface FilterProps {
  filter: { state: OrderState | ''; machine: string; words: string };
  children: preact.ComponentChildren;
}

const Filters = ({ filter, children }: FilterProps) => (
  <div class="search-line" role="search">
    <label class="field search-words">
      <span>{t('orders_view.words')}</span>
      <input type="search" value={filter.words} onInput={(event) => changeQuery('q', event.currentTarget.value || null)} autocomplete="off" />
    </label>
    <Choice
      label={t('column.state')}
      value={filter.state || 'all'}
      options={[['all', t('list.all')], ...kOrderStates.map((one) => [one, orderWording(one).text] as const)]}
      change={(state) => changeQuery('state', state)}
    />
    <MachineField label={t('column.machine')} value={filter.machine} empty={t('list.all')} change={(machine) => changeQuery('machine', machine || null)} />
    {children}
  </div>
);

export const orderName = (order: Pick<Order, 'number' | 'operation'>): string => (order.operation === null ? order.number : `${order.number} / ${order.operation}`);

const Orders = ({ rows }: { rows: readonly Order[] }) => (
  <Table
    label={t('nav.orders')}
    rows={rows}
    name="orders"
    keyOf={({ id }) => id}
    marks={({ id, state }) => ({ 'data-order': String(id), 'data-state': state })}
    columns={[
      {
        id: 'order',
        head: t('column.order'),
        by: orderName,
        cell: (order) => (
          <a href={hrefs.order(order.id)}>
            <strong>{orderName(order)}</strong>
          </a>
        ),
      },
      { id: 'part', head: t('column.part'), by: ({ part }) => part, cell: ({ part }) => part },
      { id: 'due', head: t('column.due'), by: ({ due_at_ms }) => due_at_ms, cell: (order) => <Due order={order} /> },
      { id: 'made', head: t('column.made'), by: ({ good, quantity }) => good / quantity, cell: (order) => <Made order={order} /> },
      { id: 'priority', head: t('column.priority'), by: ({ priority }) => priority, cell: ({ priority }) => priority },
      { id: 'machine', head: t('column.machine'), by: ({ machine }) => machine, cell: ({ machine }) => machine ?? '' },
      {
        id: 'state',
        head: t('column.state'),
        by: ({ state }) => kOrderStates.indexOf(state),
        cell: (order) => (
          <>
            <Badge wording={orderWording(order.state)} />
            {order.reason && <span class="reason">{order.reason}</span>}
          </>
        ),
      },
    ]}
  />
);

export const Due = ({ order }: { order: Order }) => {
  if (order.due_at_ms === null) return <span class="quiet-text">{t('orders_view.no_date')}</span>;
  return (
    <>
      {dateTime(order.due_at_ms).slice(0, 16)}
      {isLate(order, minutes.value) && <span class="late">{t('orders_view.late')}</span>}
    </>
  );
};

export const Made = ({ order }: { order: Order }) => (
  <>
    <span class="made">
      <progress max={order.quantity} value={Math.min(order.good, order.quantity)} aria-label={t('orders_view.made', { good: order.good, quantity: order.quantity })} />{' '}
      {t('orders_view.made', { good: count(order.good), quantity: count(order.quantity) })}
    </span>
    {order.scrap > 0 && <span class="reason">{t('orders_view.scrap', { count: order.scrap, text: count(order.scrap) })}</span>}
  </>
);

const kCsv: CsvColumn<Order>[] = [
  { head: 'number', of: ({ number }) => number },
  { head: 'operation', of: ({ operation }) => operation },
  { head: 'part', of: ({ part }) => part },
  { head: 'machine', of: ({ machine }) => machine },
  { head: 'state', of: ({ state }) => state },
  { head: 'due', of: ({ due_at_ms }) => isoTime(due_at_ms) },
  { head: 'priority', of: ({ priority }) => priority },
  { head: 'quantity', of: ({ quantity }) => quantity },
  { head: 'good', of: ({ good }) => good },
  { head: 'scrap', of: ({ scrap }) => scrap },
  { head: 'open', of: ({ open }) => open },
  { head: 'transfers', of: ({ transfers }) => transfers },
  { head: 'waiting', of: ({ waiting }) => waiting },
  { head: 'reason', of: ({ reason }) => reason },
  { head: 'created_by', of: ({ created_by }) => created_by },
  { head: 'created', of: ({ created_at_ms }) => isoTime(created_at_ms) },
  { head: 'changed', of: ({ changed_at_ms }) => isoTime(changed_at_ms) },
];
