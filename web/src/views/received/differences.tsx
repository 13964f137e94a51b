// How a received text differs from the stored program of its name: line by line, and as values of the part where these
// explain it. The server renders the family with them and compares every number, so nothing here is a guess.
import { useState } from 'preact/hooks';
import { newOrderKey } from '../../api/client';
import { deskCalls } from '../../api/desk_calls';
import type { ReceivedValues, Receipt } from '../../api/types';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { hrefs } from '../../router';
import { loader } from '../../state/loader';
import { ComparedView } from '../program/compare';

interface Props {
  receipt: Receipt;
  text: string;
}

export function Differences({ receipt, text }: Props) {
  const { stored } = receipt;
  const compared = useLoaded(stored ? `${receipt.id} ${stored.revision}` : null, () =>
    deskCalls.compareText(stored?.program ?? 0, { text, revision: stored?.revision ?? 0, machine: receipt.machine }),
  );
  const values = useLoaded(stored ? `${receipt.id} values` : null, () => deskCalls.explainReceipt(receipt.id));
  if (!stored) return null;
  return (
    <>
      {values.value && values.value.values.length > 0 && <ChangedValues found={values.value} />}
      {values.value && values.value.values.length === 0 && values.value.why_not && (
        <p class="hint">
          {t('sent_back.no_values')} {values.value.why_not}
        </p>
      )}
      <details>
        <summary>{t('sent_back.compare', { revision: stored.revision })}</summary>
        {compared.loading && <p role="status">{t('compare.running')}</p>}
        <Failure error={compared.error} />
        {compared.value && <ComparedView of={compared.value} chosen={() => undefined} />}
      </details>
    </>
  );
}

function ChangedValues({ found }: { found: ReceivedValues }) {
  const { part, values, rest } = found;
  return (
    <section class="card" aria-label={t('sent_back.values')}>
      <h3>{part === null ? t('sent_back.values') : t('sent_back.values_of', { part })}</h3>
      <p class={`notice tone-${found.explains_all ? 'good' : 'waiting'}`} role="status">
        {found.explains_all ? t('sent_back.explained') : `${t('sent_back.not_explained')} ${found.why_not ?? ''}`}
      </p>
      <ul class="listed">
        {values.map(({ name, before, after }) => (
          <li key={name}>
            <code>{name}</code> {before} → <strong>{after}</strong>
          </li>
        ))}
      </ul>
      {rest.length > 0 && (
        <ul class="listed">
          {rest.map(({ line, stored, received }) => (
            <li key={line}>
              {t('sent_back.left_over', { line })} <code>{stored}</code> → <code>{received}</code>
            </li>
          ))}
        </ul>
      )}
      {found.explains_all && part !== null && <TakeValues found={found} part={part} />}
    </section>
  );
}

// The part gets them as a new revision; a part that was changed since the program was rendered keeps its own.
function TakeValues({ found, part }: { found: ReceivedValues; part: string }) {
  const [error, setError] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const [taken, setTaken] = useState<number | null>(null);
  const take = async () => {
    setBusy(true);
    setError(null);
    try {
      const now = await loader.order(deskCalls.part(part));
      const values = { ...now.values, ...Object.fromEntries(found.values.map(({ name, after }) => [name, after])) };
      setTaken((await loader.order(deskCalls.changePart(part, found.part_revision ?? 0, values, newOrderKey()))).revision);
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  if (taken !== null)
    return (
      <p class="notice tone-good" role="status">
        <a href={hrefs.part(part)}>{t('sent_back.taken', { part, revision: taken })}</a>
      </p>
    );
  return (
    <>
      <Failure error={error} />
      <button type="button" class="button" disabled={busy} onClick={() => void take()}>
        {t('sent_back.take_values', { part })}
      </button>
    </>
  );
}
