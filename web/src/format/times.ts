// Instants in local time, and durations. Instants are milliseconds since 1970.
import { t } from '../i18n/i18n';

const two = (value: number): string => String(value).padStart(2, '0');

export function clockTime(ms: number): string {
  const at = new Date(ms);
  return `${two(at.getHours())}:${two(at.getMinutes())}:${two(at.getSeconds())}`;
}

export function dateTime(ms: number): string {
  const at = new Date(ms);
  return `${at.getFullYear()}-${two(at.getMonth() + 1)}-${two(at.getDate())} ${clockTime(ms)}`;
}

// The date is left out for today.
export function shortTime(ms: number, nowMs: number): string {
  const sameDay = new Date(ms).toDateString() === new Date(nowMs).toDateString();
  return sameDay ? clockTime(ms) : dateTime(ms);
}

// "9:05", minutes and seconds; negative counts as 0. Rounded up, so that 0:00 means that it is over.
export function countdown(ms: number): string {
  const seconds = Math.max(0, Math.ceil(ms / 1000));
  return `${Math.floor(seconds / 60)}:${two(seconds % 60)}`;
}

// About how long, in the roughness that a forecast deserves.
export function aboutText(ms: number): string {
  const minutes = ms / 60_000;
  if (minutes < 1) return t('time.under_a_minute');
  if (minutes < 90) return t('time.about_minutes', { minutes: Math.round(minutes) });
  return t('time.about_hours', { hours: tenths(ms) });
}

// A range as one text where its ends are about the same.
export function aboutRange(low: number, high: number): string {
  const [least, most] = [aboutText(low), aboutText(high)];
  if (least === most) return most;
  const minutes = (ms: number) => Math.round(ms / 60_000);
  return high < 90 * 60_000 ? t('time.range_minutes', { low: Math.max(0, minutes(low)), high: minutes(high) }) : t('time.range_hours', { low: tenths(low), high: tenths(high) });
}

const tenths = (ms: number): number => Math.round(ms / 360_000) / 10;

export function duration(seconds: number): string {
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  const whole = Math.floor(seconds);
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${two(whole % 60)} s`;
  return `${Math.floor(whole / 3600)} h ${two(Math.floor(whole / 60) % 60)} min`;
}
