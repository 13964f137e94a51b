// How far a transfer is: wire bytes as a bar and as three figures, each of which says only what is known. In the bar
// the three differ by shape: clocked is full, handed a thin line ahead of it, confirmed a strip of its own below.
import { useComputed, type ReadonlySignal } from '@preact/signals';
import type { MachineStatus } from '../api/types';
import { bytes, count, percent, share } from '../format/numbers';
import { t } from '../i18n/i18n';
import { hasJob } from '../rules/lines';

const kWide = 1000;
const kHigh = 12;
const kThin = 4;
const kGap = 2;

const widthOf = (part: number, total: number): number => Math.round(share(part, total) * kWide);

// Bound to the status: a report changes widths and the label, and redraws nothing else. After a job it is empty.
export function WireBar({ status }: { status: ReadonlySignal<MachineStatus> }) {
  const total = useComputed(() => (hasJob(status.value) ? status.value.total : 0));
  const handed = useComputed(() => widthOf(status.value.handed, total.value));
  const clocked = useComputed(() => widthOf(status.value.clocked, total.value));
  const confirmed = useComputed(() => widthOf(status.value.confirmed, total.value));
  const confirms = useComputed(() => status.value.confirms);
  const label = useComputed(() =>
    total.value > 0 ? t('wire.bar', { share: percent(status.value.clocked, total.value), total: bytes(total.value) }) : t('wire.no_job'),
  );
  return (
    <svg class="wire-bar" viewBox={`0 0 ${kWide} ${kHigh + kGap + kThin}`} preserveAspectRatio="none" role="img" aria-label={label}>
      <rect class="wire-track" width={kWide} height={kHigh} />
      <rect class="wire-handed" y={(kHigh - kThin) / 2} width={handed} height={kThin} />
      <rect class="wire-clocked" width={clocked} height={kHigh} />
      {confirms.value && <rect class="wire-track" y={kHigh + kGap} width={kWide} height={kThin} />}
      {confirms.value && <rect class="wire-confirmed" y={kHigh + kGap} width={confirmed} height={kThin} />}
    </svg>
  );
}

export function WireFigures({ status }: { status: MachineStatus }) {
  const { handed, clocked, confirmed, total } = status;
  return (
    <dl class="figures">
      <Figure kind="handed" value={handed} total={total} says={t('wire.to_driver')} />
      <Figure kind="clocked" value={clocked} total={total} says={t(status.estimated ? 'wire.estimated' : 'wire.line_time')} />
      {status.confirms ? (
        <Figure kind="confirmed" value={confirmed} total={total} says={t('wire.acknowledged')} />
      ) : (
        <div class="figure">
          <dt>
            <span class="swatch swatch-none" />
            {t('wire.confirmed')}
          </dt>
          <dd class="figure-says">{t('wire.never_confirms')}</dd>
        </div>
      )}
      <div class="figure figure-total">
        <dt>{t('wire.of')}</dt>
        <dd>
          <span class="figure-count">{count(total)}</span>
          <span />
          <span class="figure-says">{t('wire.bytes')}</span>
        </dd>
      </div>
    </dl>
  );
}

interface FigureProps {
  kind: 'handed' | 'clocked' | 'confirmed';
  value: number;
  total: number;
  says: string;
}

const Figure = ({ kind, value, total, says }: FigureProps) => (
  <div class="figure">
    <dt>
      <span class={`swatch swatch-${kind}`} />
      {t(`wire.${kind}`)}
    </dt>
    <dd>
      <span class="figure-count">{count(value)}</span>
      <span class="figure-share">{percent(value, total)}</span>
      <span class="figure-says">{says}</span>
    </dd>
  </div>
);
