// Where the guided tour is: a step from 0 on; null: it is not taken. It stays over a reload of this tab.
import { signal } from '@preact/signals';

const kStored = 'dripfeed.tour';

const stored = (): number | null => {
  const step = Number(sessionStorage.getItem(kStored) ?? 'none');
  return Number.isInteger(step) && step >= 0 ? step : null;
};

export const tourStep = signal<number | null>(stored());

export function setTour(step: number | null): void {
  if (step === null) sessionStorage.removeItem(kStored);
  else sessionStorage.setItem(kStored, String(step));
  tourStep.value = step;
}
