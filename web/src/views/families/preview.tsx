// The program that values give for a machine, as they are typed. The server renders it and stores nothing.
import { useEffect, useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Delivery } from '../../api/types';
import { bytes, count } from '../../format/numbers';
import { deliveryText, kDeliveries } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import type { Values } from '../../rules/part_values';
import { atLeast } from '../../rules/roles';
import { machines, roleOn } from '../../state/shop';

const kPauseMs = 500;
const kShownLines = 400;

interface Props {
  family: string;
  values: Values;
  failed: (error: unknown) => void; // the form shows what is about its fields
  isShown: (error: unknown) => boolean; // it does
}

export function Preview({ family, values, failed, isShown }: Props) {
  const names = [...machines.value.keys()].filter((one) => atLeast(roleOn(one), 'programmer'));
  const [machine, setMachine] = useState('');
  const [delivery, setDelivery] = useState<Delivery>('drip');
  const asked = useSettled(JSON.stringify(values));
  const name = machine || names[0] || '';
  const { value, error, loading } = useLoaded(name === '' ? null : `${family} ${name} ${delivery} ${asked}`, () =>
    deskCalls.preview(family, JSON.parse(asked) as Values, name, delivery),
  );
  useEffect(() => failed(error), [error]);
  if (names.length === 0) return null;
  const lines = value?.text.split('\n') ?? [];
  return (
    <section class="card preview" aria-label={t('preview.title')} aria-busy={loading}>
      <h2>{t('preview.title')}</h2>
      <div class="writing-bar">
        <label class="choice">
          <span>{t('fact.machine')}</span>
          <select value={name} onChange={(event) => setMachine(event.currentTarget.value)}>
            {names.map((one) => (
              <option key={one} value={one}>
                {one}
              </option>
            ))}
          </select>
        </label>
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
      </div>
      {error !== null && !isShown(error) && <Failure error={error} />}
      {loading && !value && <p role="status">{t('parts.rendering')}</p>}
      {value && (
        <>
          <p class="hint">
            {t('library.blocks', { count: value.blocks, text: count(value.blocks) })}, {bytes(value.bytes)}: {value.because}
          </p>
          <pre class="text-box" tabIndex={0} aria-label={t('preview.text')}>
            {lines.slice(0, kShownLines).join('\n')}
          </pre>
          {lines.length > kShownLines && <p class="hint">{t('preview.cut', { shown: kShownLines })}</p>}
        </>
      )}
    </section>
  );
}

// What was typed, once it rests.
function useSettled(value: string): string {
  const [settled, setSettled] = useState(value);
  useEffect(() => {
    if (value === settled) return;
    const timer = setTimeout(() => setSettled(value), kPauseMs);
    return () => clearTimeout(timer);
  }, [value, settled]);
  return settled;
}
