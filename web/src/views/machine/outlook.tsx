// What is ahead of a feed: how long it still takes and how much lies in the control's buffer, each as a range and with
// the source that it is known from.
import type { Job, MachineStatus } from '../../api/types';
import { aboutRange, duration } from '../../format/times';
import { t } from '../../i18n/i18n';
import { seconds } from '../../parts/clock';
import { Facts } from '../../parts/facts';
import { bufferedBlocks } from '../../rules/forecast';
import { forecastOf, timeLeftOf } from '../../state/forecasts';
import { linesOf } from '../../state/program_lines';
import { isLive } from '../../state/shop';

export function Outlook({ machine, job, status }: { machine: string; job: Job; status: MachineStatus }) {
  const forecast = forecastOf(job.id);
  const left = isLive.value ? timeLeftOf(machine, status, job, seconds.value) : null;
  return (
    <div class="outlook">
      <Facts
        facts={[
          [t('forecast.title'), left && t(`forecast.${left.by}`, { left: aboutRange(left.low_ms, left.high_ms) })],
          [t('forecast.whole'), forecast === null || forecast.cycle_s === null ? null : duration(forecast.cycle_s)],
          [t('buffer.title'), bufferText(job, status)],
        ]}
      />
      {forecast?.stale && <p class="hint">{t('forecast.stale')}</p>}
    </div>
  );
}

function bufferText(job: Job, status: MachineStatus): string | null {
  if (job.delivery !== 'drip' || status.block <= 0) return null;
  const found = bufferedBlocks(status, forecastOf(job.id), linesOf(job.program, job.revision));
  if (found === null) return t('buffer.unknown');
  return found.low === 0 ? t('buffer.most', { high: found.high }) : t('buffer.blocks', { low: found.low, high: found.high });
}
