// Dialogs of orders: a new one, another plan, another state, parts that were made, a job of a release.
import { useState } from 'preact/hooks';
import { orderCalls } from '../../api/order_calls';
import type { Order, OrderState, Release } from '../../api/types';
import { deliveryText, orderWording, releaseText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { MachineField } from '../../parts/choice';
import { OrderDialog } from '../../parts/dialog';
import { fromLocalField, localField, needsReason } from '../../rules/orders';
import { programName } from '../../state/shop';

interface Plan {
  part: string;
  quantity: string;
  machine: string;
  due: string;
  priority: string;
}

const planOf = (order: Order | null): Plan => ({
  part: order?.part ?? '',
  quantity: String(order?.quantity ?? 1),
  machine: order?.machine ?? '',
  due: localField(order?.due_at_ms ?? null),
  priority: String(order?.priority ?? 0),
});

const given = ({ part, quantity, machine, due, priority }: Plan) => ({
  part: part.trim(),
  quantity: Number(quantity),
  machine: machine === '' ? null : machine,
  due_at_ms: fromLocalField(due),
  priority: Number(priority),
});

interface FieldProps {
  label: string;
  value: string;
  type?: 'text' | 'number' | 'datetime-local';
  required?: boolean;
  min?: number;
  change: (value: string) => void;
}

const Field = ({ label, value, type = 'text', required = false, min, change }: FieldProps) => (
  <label class="field">
    <span>{label}</span>
    <input type={type as 'text'} value={value} required={required} autocomplete="off" onInput={(event) => change(event.currentTarget.value)} {...(min === undefined ? {} : { min })} />
  </label>
);

function PlanFields({ plan, set }: { plan: Plan; set: (plan: Plan) => void }) {
  return (
    <>
      <Field label={t('fact.part')} value={plan.part} required change={(part) => set({ ...plan, part })} />
      <Field label={t('orders_view.quantity')} type="number" min={1} value={plan.quantity} required change={(quantity) => set({ ...plan, quantity })} />
      <MachineField label={t('fact.machine')} value={plan.machine} empty={t('orders_view.any_machine')} change={(machine) => set({ ...plan, machine })} />
      <Field label={t('column.due')} type="datetime-local" value={plan.due} change={(due) => set({ ...plan, due })} />
      <Field label={t('orders_view.priority')} type="number" value={plan.priority} change={(priority) => set({ ...plan, priority })} />
    </>
  );
}

export function NewOrderDialog({ made, part = '' }: { made: (order: Order) => void; part?: string }) {
  const [number, setNumber] = useState('');
  const [operation, setOperation] = useState('');
  const [plan, setPlan] = useState({ ...planOf(null), part });
  return (
    <OrderDialog
      title={t('orders_view.add_title')}
      confirm={t('orders_view.add')}
      send={async (key) =>
        made(await orderCalls.addOrder({ number: number.trim(), ...(operation.trim() === '' ? {} : { operation: operation.trim() }), ...given(plan) }, key))
      }
    >
      <Field label={t('orders_view.number')} value={number} required change={setNumber} />
      <Field label={t('orders_view.operation')} value={operation} change={setOperation} />
      <PlanFields plan={plan} set={setPlan} />
    </OrderDialog>
  );
}

export interface Of {
  order: Order;
  changed: (order: Order) => void;
}

export function PlanDialog({ order, changed }: Of) {
  const [plan, setPlan] = useState(planOf(order));
  return (
    <OrderDialog
      title={t('orders_view.plan_title', { number: order.number })}
      confirm={t('orders_view.save_plan')}
      send={async (key) => changed(await orderCalls.changeOrder(order, { ...given(plan), metadata: order.metadata }, key))}
    >
      <PlanFields plan={plan} set={setPlan} />
    </OrderDialog>
  );
}

export const MoveDialog = ({ order, changed, to }: Of & { to: OrderState }) => (
  <OrderDialog
    title={t('orders_view.move_title', { number: order.number, state: orderWording(to).text })}
    confirm={t(`order_move.${to}`)}
    danger={to === 'cancelled'}
    {...(needsReason(to) ? { reason: t('reason.kept') } : {})}
    send={async (key, reason) => changed(await orderCalls.moveOrder(order.id, to, reason, key))}
  >
    <p>{t(`order_move_text.${to}`)}</p>
  </OrderDialog>
);

export function PartsDialog({ order, changed }: Of) {
  const [good, setGood] = useState('0');
  const [scrap, setScrap] = useState('0');
  const [note, setNote] = useState('');
  const isNothing = !(Number(good) > 0) && !(Number(scrap) > 0);
  return (
    <OrderDialog
      title={t('orders_view.parts_title', { number: order.number })}
      confirm={t('orders_view.report')}
      blocked={isNothing ? t('orders_view.no_parts') : null}
      send={async (key) => changed(await orderCalls.reportParts(order.id, Number(good), Number(scrap), note.trim(), key))}
    >
      <p>{t('orders_view.parts_text')}</p>
      <Field label={t('orders_view.good')} type="number" min={0} value={good} change={setGood} />
      <Field label={t('orders_view.scrap_field')} type="number" min={0} value={scrap} change={setScrap} />
      <Field label={t('orders_view.note')} value={note} change={setNote} />
    </OrderDialog>
  );
}

interface JobProps {
  order: Order;
  releases: readonly Release[]; // that may be queued, the likeliest first
  queued: () => void;
}

export function JobDialog({ order, releases, queued }: JobProps) {
  const [release, setRelease] = useState(String(releases[0]?.id ?? ''));
  return (
    <OrderDialog
      title={t('orders_view.job_title', { number: order.number })}
      confirm={t('releases.queue')}
      blocked={releases.length === 0 ? t('orders_view.no_release') : null}
      send={async (key) => {
        await orderCalls.addJob(order.id, Number(release), key);
        queued();
      }}
    >
      <p>{t('orders_view.job_text')}</p>
      <label class="field">
        <span>{t('column.release')}</span>
        <select value={release} onChange={(event) => setRelease(event.currentTarget.value)}>
          {releases.map((one) => (
            <option key={one.id} value={one.id}>
              {t('orders_view.release_option', {
                program: programName(one.program) ?? t('program.number', { id: one.program }),
                revision: one.revision,
                machine: one.machine,
                delivery: deliveryText(one.delivery),
                state: releaseText(one.state),
              })}
            </option>
          ))}
        </select>
      </label>
    </OrderDialog>
  );
}
