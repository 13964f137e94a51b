// One part: its values, and its programs for machines. Rendering stores the program; it is looked at in the library.
import { useState } from 'preact/hooks';
import { newOrderKey } from '../../api/client';
import { deskCalls } from '../../api/desk_calls';
import type { Delivery, Rendered } from '../../api/types';
import { count } from '../../format/numbers';
import { dateTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { AttachedFiles } from '../../parts/attached_files';
import { showDialog } from '../../parts/dialog';
import { Failure } from '../../parts/failure';
import { TargetForm, type Fits } from '../../parts/target';
import { useLoaded } from '../../parts/use_loaded';
import { goUnlessLeft, hrefs } from '../../router';
import { isMadeOn, wantedBy } from '../../rules/part_values';
import { atLeast } from '../../rules/roles';
import { loader } from '../../state/loader';
import { bestRole, person } from '../../state/shop';
import { NewOrderDialog } from '../orders/dialogs';
import { PartPrograms } from './part_programs';
import { ValuesForm } from './values_form';

export function PartView({ number }: { number: string }) {
  const part = useLoaded(number, () => deskCalls.part(number));
  const name = part.value?.family ?? null;
  const family = useLoaded(name, () => deskCalls.family(name ?? ''));
  const programs = useLoaded(number, () => deskCalls.programs({ part: number, shelf: 'all' }, null));
  const may = atLeast(person().role, 'programmer');
  const known = part.value;
  return (
    <>
      <p class="back">
        <a href={hrefs.families}>{t('parts.back')}</a>
      </p>
      <h1 tabIndex={-1}>{t('parts.title', { number })}</h1>
      <Failure error={part.error ?? family.error} />
      {known && family.value && (
        <>
          <p class="lead">
            <a href={hrefs.family(known.family)}>{family.value.title || known.family}</a>, {t('job.revision', { revision: known.revision })},{' '}
            {t('library.changed', { name: known.changed_by, at: dateTime(known.changed_at_ms) })}
          </p>
          <ValuesForm
            key={known.revision}
            family={family.value}
            number={number}
            values={known.values}
            may={may}
            confirm={t('parts.save', { next: known.revision + 1 })}
            save={async (_, values, key) => part.set(await deskCalls.changePart(number, known.revision, values, key))}
          />
          <section>
            <h2>{t('parts.programs')}</h2>
            {atLeast(bestRole(), 'programmer') && <RenderForm part={number} fits={(machine) => isMadeOn(wantedBy(family.value?.text ?? ''), machine)} done={programs.again} />}
            <Failure error={programs.error} />
            {programs.value?.items.length === 0 && <p class="quiet-text">{t('parts.no_program')}</p>}
            {programs.value && <PartPrograms part={known} programs={programs.value.items} />}
          </section>
          <OrderIt part={number} />
          <AttachedFiles owner={{ part: number }} may={may} />
        </>
      )}
    </>
  );
}

function OrderIt({ part }: { part: string }) {
  if (!atLeast(bestRole(), 'operator')) return null;
  const ask = () => {
    const follow = goUnlessLeft();
    showDialog(<NewOrderDialog part={part} made={(order) => follow(hrefs.order(order.id))} />);
  };
  return (
    <p class="apart">
      <button type="button" class="button" onClick={ask}>
        {t('parts.order')}
      </button>
    </p>
  );
}

function RenderForm({ part, fits, done }: { part: string; fits: Fits; done: () => void }) {
  const [error, setError] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const [made, setMade] = useState<Rendered | null>(null);
  const render = async (machine: string, delivery: Delivery) => {
    setBusy(true);
    setError(null);
    setMade(null);
    try {
      setMade(await loader.order(deskCalls.render(part, machine, delivery, newOrderKey())));
      done();
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  return (
    <>
      <TargetForm fits={fits} busy={busy} confirm={busy ? t('parts.rendering') : t('parts.render')} send={(machine, delivery) => void render(machine, delivery)} />
      <Failure error={error} />
      {made && (
        <p class="notice tone-good" role="status">
          <a href={hrefs.program(made.program)}>{made.name}</a>, {t('library.blocks', { count: made.blocks, text: count(made.blocks) })}: {made.because}
        </p>
      )}
    </>
  );
}
