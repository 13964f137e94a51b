// For which machine, and how the program goes to it: two fields that stand in several forms.
import { useState } from 'preact/hooks';
import type { Delivery } from '../api/types';
import { deliveryText, kDeliveries } from '../format/words';
import { t } from '../i18n/i18n';
import { atLeast } from '../rules/roles';
import { machines, roleOn } from '../state/shop';

export interface TargetState {
  names: readonly string[]; // of machines that may be chosen
  machine: string; // '' where there is none
  delivery: Delivery;
  choose: (machine: string) => void;
  deliver: (delivery: Delivery) => void;
}

export type Fits = (machine: { kind: string; dialect: string }) => boolean;

// Machines on which one is a programmer, and that fit. The first one until another is chosen.
export function useTarget(fits: Fits): TargetState {
  const [chosen, choose] = useState('');
  const [delivery, deliver] = useState<Delivery>('drip');
  const names = [...machines.value.values()]
    .filter((one) => fits(one.head.value) && atLeast(roleOn(one.name), 'programmer'))
    .map((one) => one.name);
  return { names, machine: names.includes(chosen) ? chosen : (names[0] ?? ''), delivery, choose, deliver };
}

export const TargetFields = ({ target }: { target: TargetState }) => (
  <>
    <label class="choice">
      <span>{t('fact.machine')}</span>
      <select value={target.machine} onChange={(event) => target.choose(event.currentTarget.value)}>
        {target.names.map((one) => (
          <option key={one} value={one}>
            {one}
          </option>
        ))}
      </select>
    </label>
    <label class="choice">
      <span>{t('fact.delivery')}</span>
      <select value={target.delivery} onChange={(event) => target.deliver(event.currentTarget.value as Delivery)}>
        {kDeliveries.map((one) => (
          <option key={one} value={one}>
            {deliveryText(one)}
          </option>
        ))}
      </select>
    </label>
  </>
);

interface FormProps {
  fits: Fits;
  busy: boolean;
  confirm: string;
  send: (machine: string, delivery: Delivery) => void;
}

// Both, and a button that does something for them.
export function TargetForm({ fits, busy, confirm, send }: FormProps) {
  const target = useTarget(fits);
  if (target.names.length === 0) return <p class="notice tone-waiting">{t('checks.no_machine')}</p>;
  return (
    <form
      class="writing-bar"
      onSubmit={(event) => {
        event.preventDefault();
        if (!busy) send(target.machine, target.delivery);
      }}
    >
      <TargetFields target={target} />
      <button type="submit" class="button button-main" aria-disabled={busy}>
        {confirm}
      </button>
    </form>
  );
}
