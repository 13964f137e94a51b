// What an operator states of a proving: what was seen and measured on the parts that its transfers made.
import { deskCalls } from '../../api/desk_calls';
import type { Release } from '../../api/types';
import { t } from '../../i18n/i18n';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { atLeast } from '../../rules/roles';
import { roleOn } from '../../state/shop';

export function Proof({ release, changed }: { release: Release; changed: (release: Release) => void }) {
  const { proved_by, proof, state, transfers_done, machine } = release;
  if (state !== 'proving' && proved_by === null) return null;
  const may = atLeast(roleOn(machine), 'operator');
  const blocked = transfers_done === 0;
  return (
    <section class="card" aria-label={t('proof.title')}>
      <h2>{t('proof.title')}</h2>
      {proved_by !== null && <p>{t('proof.by', { name: proved_by, proof: proof ?? '' })}</p>}
      {state === 'proving' && proved_by === null && <p class="hint">{t(blocked ? 'proof.no_transfer' : 'proof.lacks', { machine })}</p>}
      {state === 'proving' && may && (
        <p class="dialog-buttons decide-buttons">
          <button
            type="button"
            class={`button${proved_by === null ? ' button-main' : ''}`}
            aria-disabled={blocked}
            onClick={() => !blocked && showDialog(<ProofDialog release={release} changed={changed} />)}
          >
            {t('proof.sign')}
          </button>
        </p>
      )}
    </section>
  );
}

const ProofDialog = ({ release, changed }: { release: Release; changed: (release: Release) => void }) => (
  <OrderDialog
    title={t('proof.sign_title', { id: release.id, machine: release.machine })}
    confirm={t('proof.confirm')}
    reason={t('proof.reason')}
    send={async (key, note) => changed(await deskCalls.signOff(release.id, note, key))}
  >
    <p>{t('proof.text')}</p>
  </OrderDialog>
);
