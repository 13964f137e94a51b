// What the colours of the picture stand for.
import { duration } from '../../format/times';
import { t } from '../../i18n/i18n';
import { rangesOf, type ColorBy, type Range } from '../../path/color';
import type { PathData } from '../../path/data';
import { feedUnit, mm } from './words';

interface Row {
  key: string;
  line?: string; // class of a line of one colour
  ramp?: string; // class of a ramp
  low?: string;
  text: string;
}

const rounded = (value: number): string => String(Number(value.toPrecision(4)));

// Those whose colour does not say a value.
function kindRows(data: PathData, by: ColorBy): Row[] {
  const has = (name: string) => data.kinds.includes(data.kindNames.indexOf(name));
  const rows: Row[] = [];
  if (has('rapid') && by !== 'time') rows.push({ key: 'rapid', line: 'path-line-rapid', text: t('path_kind.rapid') });
  if (by !== 'kind') return rows;
  rows.push({ key: 'cut', line: '', text: t('path_kind.cut') });
  if (has('thread')) rows.push({ key: 'thread', line: 'path-line-thread', text: t('path_kind.thread') });
  return rows;
}

function feedRows(data: PathData): Row[] {
  return [...rangesOf(data, 'feed')].map(([kind, [low, high]]) => {
    const text = `${mm(high)} ${feedUnit(data.kindNames[kind] ?? '')}`;
    return low < high ? { key: String(kind), ramp: '', low: mm(low), text } : { key: String(kind), line: 'path-line-fast', text };
  });
}

const kTexts: Partial<Record<ColorBy, (range: Range) => [low: string, high: string]>> = {
  speed: ([low, high]) => [rounded(low), `${rounded(high)} mm/min`],
  time: ([low, high]) => [duration(low), duration(high)],
  deviation: ([low, high]) => [t('path_color.under', { size: rounded(-1000 * low) }), t('path_color.over', { size: rounded(1000 * high) })],
};

function valueRows(data: PathData, by: ColorBy): Row[] {
  if (by === 'kind') return [];
  if (by === 'feed') return feedRows(data);
  const [range] = rangesOf(data, by).values();
  const texts = range && kTexts[by]?.(range);
  const rows: Row[] = texts ? [{ key: by, ramp: by === 'deviation' ? 'path-ramp-deviation' : '', low: texts[0], text: texts[1] }] : [];
  return [...rows, { key: 'unknown', line: 'path-line-unknown', text: t('path_color.unknown') }];
}

export function Legend({ data, by }: { data: PathData; by: ColorBy }) {
  return (
    <ul class="path-legend" aria-label={t('path.legend')}>
      {[...kindRows(data, by), ...valueRows(data, by)].map(({ key, line, ramp, low, text }) => (
        <li key={key}>
          {low} <span class={ramp === undefined ? `path-line ${line ?? ''}` : `path-ramp ${ramp}`} /> {text}
        </li>
      ))}
    </ul>
  );
}
