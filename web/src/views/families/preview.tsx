// The program that values give for a machine, as they are typed, and its toolpath. The server renders it and
// stores nothing.
import { useEffect, useRef, useState } from 'preact/hooks';
import { deskCalls, type PathOrder } from '../../api/desk_calls';
import type { Preview as Rendering, ToolPath } from '../../api/types';
import { bytes, count } from '../../format/numbers';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { TargetFields, useTarget, type Fits } from '../../parts/target';
import { useLoaded } from '../../parts/use_loaded';
import { usePaced } from '../../parts/use_paced';
import type { Values } from '../../rules/part_values';
import { PathView } from '../path/path_view';
import { Drawing } from './drawing';
import { Legend } from './legend';
import { PreviewVerdict } from './preview_verdict';

const kShownLines = 400;

interface Props {
  family: string;
  fits: Fits;
  values: Values;
  failed: (error: unknown) => void; // the form shows what is about its fields
  isShown: (error: unknown) => boolean; // it does
  lit: string | null; // the parameter that is looked at
  light: (parameter: string | null) => void;
  chosen: (parameter: string) => void;
}

export function Preview({ family, fits, values, failed, isShown, lit, light, chosen }: Props) {
  const target = useTarget(fits);
  const { machine, delivery } = target;
  const [look, setLook] = useState<'text' | 'path'>('text');
  const typed = JSON.stringify(values);
  const [asked, ask] = useState(typed);
  const { value: now, error, loading } = useLoaded(machine === '' ? null : `${family} ${machine} ${delivery} ${asked}`, () =>
    deskCalls.preview(family, JSON.parse(asked) as Values, machine, delivery),
  );
  usePaced(typed, asked, loading, ask);
  // The one before stays until the next one is there.
  const kept = useRef<{ of: string; value: Rendering } | null>(null);
  if (now) kept.current = { of: asked, value: now };
  const { value, of } = kept.current ?? { value: null, of: asked };
  useEffect(() => failed(error), [error]);
  if (target.names.length === 0) return <p class="notice tone-waiting">{t('preview.no_machine')}</p>;
  return (
    <section class="card preview" aria-label={t('preview.title')} aria-busy={loading}>
      <h2>{t('preview.title')}</h2>
      <div class="writing-bar">
        <TargetFields target={target} />
        <div class="segments" role="group" aria-label={t('preview.look')}>
          {(['text', 'path'] as const).map((one) => (
            <button key={one} type="button" aria-pressed={look === one} onClick={() => setLook(one)}>
              {t(one === 'text' ? 'preview.text' : 'path.title')}
            </button>
          ))}
        </div>
      </div>
      {error !== null && !isShown(error) && <Failure error={error} />}
      {loading && !value && <p role="status">{t('parts.rendering')}</p>}
      {value && (
        <>
          <Drawing views={value.drawing} lit={lit} light={light} chosen={chosen} />
          <p class="hint">
            {t('library.blocks', { count: value.blocks, text: count(value.blocks) })}, {bytes(value.bytes)}: {value.because}
          </p>
          <PreviewVerdict family={family} machine={machine} delivery={delivery} values={of} isNew={loading || of !== typed} />
          <Legend rows={value.legend} />
          {look === 'text' && <PreviewText text={value.text} />}
          {look === 'path' && <PreviewPath order={{ text: value.text, machine, delivery, nominal: { family, values: JSON.parse(of) as Values } }} />}
        </>
      )}
    </section>
  );
}

function PreviewText({ text }: { text: string }) {
  const lines = text.split('\n');
  return (
    <>
      <pre class="text-box" tabIndex={0} aria-label={t('preview.text')}>
        {lines.slice(0, kShownLines).join('\n')}
      </pre>
      {lines.length > kShownLines && <p class="hint">{t('preview.cut', { shown: kShownLines })}</p>}
    </>
  );
}

function PreviewPath({ order }: { order: PathOrder }) {
  const [line, setLine] = useState(0);
  const { value, error, loading } = useLoaded(JSON.stringify(order), () => deskCalls.pathOfText(order));
  const kept = useRef<ToolPath | null>(null);
  if (value) kept.current = value;
  const shown = value ?? kept.current;
  return (
    <div class="path">
      <Failure error={error} />
      {loading && !shown && <p role="status">{t('path.running')}</p>}
      {shown && <PathView path={shown} isOfMachine stock={{ key: JSON.stringify(order), load: (stock) => deskCalls.stockOfText({ ...order, stock }) }} line={line} chosen={setLine} />}
      {line > 0 && <code class="path-text">{order.text.split('\n')[line - 1]}</code>}
    </div>
  );
}
