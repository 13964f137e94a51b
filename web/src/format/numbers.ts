// Counts and shares as text. A share is rounded down, so that 100 % is shown only when nothing is missing.
import { t } from '../i18n/i18n';

const kGrouped = new Intl.NumberFormat('en-US', { maximumFractionDigits: 0 });

export const count = (value: number): string => kGrouped.format(value).replace(/,/g, '\u202F');

export const bytes = (value: number): string => t('unit.bytes', { value, text: count(value) });

// 0..1; 0 where there is no whole.
export const share = (part: number, whole: number): number => (whole > 0 ? Math.min(Math.max(part / whole, 0), 1) : 0);

export function percent(part: number, whole: number): string {
  if (whole <= 0) return '–';
  return `${(Math.floor(share(part, whole) * 1000) / 10).toFixed(1)} %`;
}

export function wholePercent(part: number, whole: number): string {
  return whole <= 0 ? '–' : `${Math.floor(share(part, whole) * 100)}\u202F%`;
}

export const shortHash = (sha256: string): string => sha256.slice(0, 12);
