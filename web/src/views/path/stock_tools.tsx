// How the stock is looked at: against its nominal, cut open along an axis.
import { t } from '../../i18n/i18n';
import { againstNominal, type Stock } from '../../path/stock';
import { kAxes, mm } from './words';

export interface StockLook {
  compares: boolean;
  axis: number | null; // along which it is cut open; null: it is whole
  share: number; // of its extent there, up to which it is shown
}
export const kWholeStock: StockLook = { compares: false, axis: null, share: 0.5 };

interface Props {
  stock: Stock;
  look: StockLook;
  extent: (axis: number) => readonly [low: number, high: number];
  change: (look: StockLook) => void;
}

export function StockTools({ stock, look, extent, change }: Props) {
  const { axis, share } = look;
  const [low, high] = axis === null ? [0, 0] : extent(axis);
  const at = mm(low + share * (high - low));
  return (
    <div class="path-tools">
      {stock.nominal.length > 0 && (
        <button type="button" class="button button-small" aria-pressed={look.compares} onClick={() => change({ ...look, compares: !look.compares })}>
          {t('path_stock.compare')}
        </button>
      )}
      <div class="segments" role="group" aria-label={t('path_stock.section')}>
        {[null, 0, 1, 2].map((one) => (
          <button key={String(one)} type="button" aria-pressed={one === axis} onClick={() => change({ ...look, axis: one })}>
            {one === null ? t('path_stock.whole') : kAxes[one]}
          </button>
        ))}
      </div>
      {axis !== null && (
        <label class="path-slider">
          <span>{t('path_stock.section_at', { axis: kAxes[axis] ?? '' })}</span>
          <input
            type="range"
            min={0}
            max={1}
            step={0.005}
            value={share}
            aria-valuetext={`${at} mm`}
            onInput={(event) => change({ ...look, share: Number(event.currentTarget.value) })}
          />
          <span class="path-clock">{at} mm</span>
        </label>
      )}
    </div>
  );
}

// Of the whole program: what stands over the nominal in the end, and where it is below.
export function StockLegend({ stock }: { stock: Stock }) {
  const heights = stock.start.slice();
  stock.places.forEach((place, i) => (heights[place] = stock.heights[i] ?? 0));
  const found = againstNominal(stock, heights);
  const size = (value: number | undefined): string => (value === undefined || !Number.isFinite(value) ? '–' : `${mm(value)} mm`);
  return (
    <ul class="path-legend" aria-label={t('path_stock.legend')}>
      <li>
        <span class="path-swatch path-swatch-under" /> {t('path_stock.under', { size: size(found?.under_mm) })}
      </li>
      <li>
        <span class="path-swatch path-swatch-even" /> {t('path_stock.even')}
      </li>
      <li>
        <span class="path-swatch path-swatch-over" /> {t('path_stock.over', { size: size(found?.over_mm) })}
      </li>
    </ul>
  );
}
