// The stock along a program: asked for when a person wants to see it. Where none is known, a person may state one.
import { useEffect, useState } from 'preact/hooks';
import { ApiError } from '../../api/client';
import type { ToolPath } from '../../api/types';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { stockOf, type Stock } from '../../path/stock';
import { StockForm } from './stock_form';

export interface StockSource {
  key: string; // another one: another stock
  load: (stock: string) => Promise<ArrayBuffer>; // '' : the one that is known
}

interface Props {
  path: ToolPath;
  source: StockSource;
  show: (stock: Stock | null) => void;
}

export function StockPanel({ path, source, show }: Props) {
  const [wanted, setWanted] = useState(false);
  const [stated, setStated] = useState('');
  const { value, error, loading } = useLoaded(wanted ? `${source.key} ${stated}` : null, async () => stockOf(await source.load(stated)));
  useEffect(() => show(wanted ? value : null), [value, wanted]);
  const isMissing = error instanceof ApiError && error.status === 422;
  return (
    <div class="path-stock">
      <button type="button" class="button button-small" aria-pressed={wanted} onClick={() => setWanted(!wanted)}>
        {t('path_stock.show')}
      </button>
      {wanted && loading && (
        <span class="hint" role="status">
          {t('path_stock.running')}
        </span>
      )}
      {wanted && <Failure error={error} />}
      {wanted && (isMissing || stated !== '') && <StockForm path={path} state={setStated} />}
      {wanted && value && <StockNotes stock={value} isStated={stated !== ''} />}
    </div>
  );
}

function StockNotes({ stock, isStated }: { stock: Stock; isStated: boolean }) {
  const notes = [...(isStated ? [t('path_stock.stated')] : []), ...(stock.is_cut_off ? [t('path_stock.cut_off')] : []), ...stock.notes];
  return (
    <>
      <p class="hint">{t(stock.kind === 'map' ? 'path_stock.map' : 'path_stock.bar', { step: Number(stock.step_mm.toPrecision(2)) })}</p>
      {notes.length > 0 && (
        <details class="path-notes">
          <summary>
            {t('path_stock.notes')} ({notes.length})
          </summary>
          <ul class="listed">
            {notes.map((one) => (
              <li key={one}>{one}</li>
            ))}
          </ul>
        </details>
      )}
    </>
  );
}
