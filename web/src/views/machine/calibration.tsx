// Where the times of a machine's forecasts are from: assumed, a paper, or measured at this machine.
import type { MachineWhole } from '../../api/types';
import { t, wordOf } from '../../i18n/i18n';
import { Facts } from '../../parts/facts';

export function Calibration({ whole }: { whole: MachineWhole | null }) {
  if (!whole) return null;
  const cost = whole.profile.timing?.cost ?? null;
  const source = cost?.source ?? 'assumed';
  const spread = cost?.spread ?? 5;
  return (
    <section class="card" aria-label={t('calibration.title')}>
      <h2>{t('calibration.title')}</h2>
      <p class={`notice tone-${source === 'calibrated' ? 'good' : 'waiting'}`}>{wordOf('calibration', source)}</p>
      <Facts
        facts={[
          [t('calibration.origin'), cost?.origin || null],
          [t('calibration.spread'), t('calibration.factor', { spread: String(spread) })],
          [t('calibration.block'), cost ? `${cost.block_ms}\u202Fms` : t('calibration.usual')],
          [t('fact.revision'), whole.revision],
        ]}
      />
      <p class="hint">{t(source === 'calibrated' ? 'calibration.again' : 'calibration.how')}</p>
    </section>
  );
}
