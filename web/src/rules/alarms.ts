// What follows from an alarm's document (states as in ISA-18.2).
import type { Alarm, Severity } from '../api/types';

export const isOpen = (alarm: Alarm): boolean => alarm.cleared_at_ms === null || alarm.acknowledged_at_ms === null;

export const isShelved = (alarm: Alarm, nowMs: number): boolean =>
  alarm.shelved_until_ms !== null && alarm.shelved_until_ms > nowMs;

// A person must look at it: it is open, no person has acknowledged it, and it is not shelved.
export const asksForPerson = (alarm: Alarm, nowMs: number): boolean =>
  isOpen(alarm) && alarm.acknowledged_at_ms === null && !isShelved(alarm, nowMs);

const kOrder: Record<Severity, number> = { critical: 0, warning: 1, notice: 2 };

// The most urgent first: what no person acknowledged, then by severity, then the newest.
export function byUrgency(a: Alarm, b: Alarm): number {
  const unseen = Number(a.acknowledged_at_ms !== null) - Number(b.acknowledged_at_ms !== null);
  return unseen || (kOrder[a.severity] ?? 1) - (kOrder[b.severity] ?? 1) || b.last_at_ms - a.last_at_ms || b.id - a.id;
}

export type AlarmState = 'active' | 'acknowledged' | 'gone' | 'closed' | 'shelved';

export function stateOf(alarm: Alarm, nowMs: number): AlarmState {
  if (!isOpen(alarm)) return 'closed';
  if (isShelved(alarm, nowMs)) return 'shelved';
  if (alarm.cleared_at_ms !== null) return 'gone';
  return alarm.acknowledged_at_ms !== null ? 'acknowledged' : 'active';
}
