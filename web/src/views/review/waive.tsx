// A verdict that warns, or that does not know everything, is answered for by a person with a reason.
import { deskCalls } from '../../api/desk_calls';
import type { VerdictSummary } from '../../api/types';
import { dateTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { person } from '../../state/shop';

export function WaiveButton({ verdict, waived }: { verdict: VerdictSummary; waived: () => void }) {
  const mayBeWaived = verdict.verdict === 'warn' || verdict.verdict === 'unknown';
  if (verdict.verdict === 'pass' && verdict.waivers.length === 0) return null;
  return (
    <section class="card" aria-label={t('waive.title', { id: verdict.id })}>
      <h2>{t('waive.title', { id: verdict.id })}</h2>
      {verdict.waivers.map((one) => (
        <p key={one.at_ms}>
          {t('checks.waived', { name: one.name, reason: one.reason })} <span class="quiet-text">{dateTime(one.at_ms)}</span>
        </p>
      ))}
      {verdict.waivers.length === 0 && <p class="hint">{t(`waive.${verdict.verdict}`)}</p>}
      {mayBeWaived && (
        <button type="button" class="button" onClick={() => showDialog(<WaiveDialog verdict={verdict} waived={waived} />)}>
          {t('waive.open')}
        </button>
      )}
    </section>
  );
}

const WaiveDialog = ({ verdict, waived }: { verdict: VerdictSummary; waived: () => void }) => (
  <OrderDialog
    title={t('waive.title', { id: verdict.id })}
    confirm={t('waive.confirm', { name: person().name })}
    reason={t('waive.reason')}
    send={async (key, reason) => {
      await deskCalls.waive(verdict.id, reason, key);
      waived();
    }}
  >
    <p>{t('waive.text')}</p>
  </OrderDialog>
);
