// How much of each day a machine's line fed: bars, and the same as a table for those who cannot see them.
import type { UsedDay } from '../../api/types';
import { duration } from '../../format/times';
import { t } from '../../i18n/i18n';

const kDayS = 86_400;

const share = (day: UsedDay): number => day.feeding_s / Math.max(1, Math.min(kDayS, (day.to_ms - day.from_ms) / 1000));

export const Use = ({ days }: { days: readonly UsedDay[] }) => (
  <table class="use">
    <thead class="unseen">
      <tr>
        <th scope="col">{t('use.day')}</th>
        <th scope="col">{t('use.feeding')}</th>
        <th scope="col">{t('use.jobs')}</th>
      </tr>
    </thead>
    <tbody>
      {days.map((day) => (
        <tr key={day.day}>
          <th scope="row">{day.day.slice(5)}</th>
          <td>
            <svg class="use-bar" viewBox="0 0 100 8" preserveAspectRatio="none" aria-hidden="true">
              <rect class="wire-track" width="100" height="8" />
              <rect class="wire-clocked" width={Math.round(share(day) * 1000) / 10} height="8" />
            </svg>
            <span>{duration(day.feeding_s)}</span>
          </td>
          <td>{t('use.done', { done: day.jobs_done, failed: day.jobs_failed })}</td>
        </tr>
      ))}
    </tbody>
  </table>
);
