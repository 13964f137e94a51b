// The toolpath beside the text. It is the path of the text as it stands: a stored revision's, or what is being
// written, asked for again after a pause.
import { useRef, useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Delivery, Program, ToolPath } from '../../api/types';
import { deliveryText, kDeliveries } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { Older } from '../../parts/older';
import { useAsked } from '../../parts/use_asked';
import { useNumberOf } from '../../parts/use_number_of';
import { PathView } from '../path/path_view';

interface Props {
  program: Program;
  revision: number;
  written: string | null; // a text that differs from the revision's; null: it does not
  machine: string;
  line: number;
  chosen: (line: number) => void;
}

const kPause_ms = 1_200;

export function PathPanel({ program, revision, written, machine, line, chosen }: Props) {
  const { text: asked, isOlder: isBehind, askNow } = useAsked(written, kPause_ms);
  const number = useNumberOf(asked);
  const [delivery, setDelivery] = useState<Delivery>('memory');
  const key = `${program.id} ${machine} ${delivery} ${asked === null ? `revision ${revision}` : `written ${number}`}`;
  const { value, error, loading } = useLoaded<ToolPath>(key, () =>
    asked === null
      ? deskCalls.programPath(program.id, revision, machine, machine ? delivery : null)
      : deskCalls.pathOfText({ text: asked, dialect: program.dialect, ...(machine ? { machine, delivery } : {}) }),
  );
  const stock = {
    key,
    load: (stated: string) =>
      asked === null
        ? deskCalls.programStock(program.id, revision, machine, machine ? delivery : null, stated)
        : deskCalls.stockOfText({ text: asked, dialect: program.dialect, stock: stated, ...(machine ? { machine, delivery } : {}) }),
  };
  const kept = useRef<ToolPath | null>(null);
  if (value) kept.current = value;
  const shown = value ?? kept.current;
  const isOlder = isBehind || (loading && shown !== null);
  return (
    <section class="path" aria-label={t('path.title')} aria-busy={loading}>
      <div class="path-head">
        <h2>{t('path.title')}</h2>
        {machine !== '' && (
          <label class="choice">
            <span>{t('fact.delivery')}</span>
            <select value={delivery} onChange={(event) => setDelivery(event.currentTarget.value as Delivery)}>
              {kDeliveries.map((one) => (
                <option key={one} value={one}>
                  {deliveryText(one)}
                </option>
              ))}
            </select>
          </label>
        )}
      </div>
      <Failure error={error} />
      {loading && !shown && (
        <p class="waiting" role="status">
          {t('path.running')}
        </p>
      )}
      {isOlder && <Older what={t('path.older')} askNow={askNow} />}
      {shown && <PathView path={shown} isOfMachine={machine !== ''} stock={stock} line={line} chosen={chosen} />}
    </section>
  );
}
