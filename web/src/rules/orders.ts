// What follows from an order's document.
import type { Order, OrderState } from '../api/types';
import type { Tone } from '../format/tones';

export const kOrderStates: readonly OrderState[] = ['open', 'held', 'done', 'cancelled'];

export const kOrderTones: Record<OrderState, Tone> = { open: 'active', held: 'waiting', done: 'good', cancelled: 'quiet' };

// Parts are still missing after its date.
export const isLate = (order: Order, nowMs: number): boolean =>
  order.due_at_ms !== null && order.due_at_ms < nowMs && order.open > 0 && (order.state === 'open' || order.state === 'held');

// States that a person may bring it to, the usual one first; those that need a reason are named.
const kMoves: Record<OrderState, readonly OrderState[]> = {
  open: ['held', 'done', 'cancelled'],
  held: ['open', 'done', 'cancelled'],
  done: ['open'],
  cancelled: ['open'],
};
export const movesOf = ({ state }: Order): readonly OrderState[] => kMoves[state];
export const needsReason = (to: OrderState): boolean => to === 'held' || to === 'cancelled';

export interface OrderFilter {
  state: OrderState | ''; // '': all
  machine: string;
  words: string;
}

export function filtered(orders: readonly Order[], { state, machine, words }: OrderFilter): Order[] {
  const wanted = words.trim().toLowerCase();
  return orders.filter(
    (one) =>
      (state === '' || one.state === state) &&
      (machine === '' || one.machine === machine) &&
      (wanted === '' || [one.number, one.operation ?? '', one.part].some((text) => text.toLowerCase().includes(wanted))),
  );
}

// The soonest first: by date, then by priority, then by number.
export const byUrgency = (a: Order, b: Order): number =>
  (a.due_at_ms ?? Infinity) - (b.due_at_ms ?? Infinity) || b.priority - a.priority || a.id - b.id;

// "2026-11-26T06:12" of a field, and back; local time.
export function localField(ms: number | null): string {
  if (ms === null) return '';
  const at = new Date(ms - new Date(ms).getTimezoneOffset() * 60_000);
  return at.toISOString().slice(0, 16);
}
export const fromLocalField = (text: string): number | null => (text === '' ? null : new Date(text).getTime());
