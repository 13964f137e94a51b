// A verdict that warns, or that does not know everything, is answered for by a person with a reason: as a whole, or one
// point after the other. What holds for a time ends by itself.
import { useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { VerdictSummary } from '../../api/types';
import { dateTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { minutes } from '../../parts/clock';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { hasEnded, openPoints, type Waiver } from '../../rules/releases';
import { person } from '../../state/shop';

interface Props {
  verdict: VerdictSummary;
  waived: () => void;
}

export function WaiveButton({ verdict, waived }: Props) {
  const mayBeWaived = verdict.verdict === 'warn' || verdict.verdict === 'unknown';
  if (verdict.verdict === 'pass' && verdict.waivers.length === 0) return null;
  return (
    <section class="card" aria-label={t('waive.title', { id: verdict.id })}>
      <h2>{t('waive.title', { id: verdict.id })}</h2>
      {verdict.waivers.map((one) => (
        <p key={`${one.at_ms} ${one.point}`}>
          <WaiverText of={one} /> <span class="quiet-text">{dateTime(one.at_ms)}</span>
        </p>
      ))}
      {verdict.waivers.length === 0 && <p class="hint">{t(`waive.${verdict.verdict}`)}</p>}
      {mayBeWaived && verdict.points.length > 1 && <Points verdict={verdict} waived={waived} />}
      {mayBeWaived && (
        <button type="button" class="button" onClick={() => showDialog(<WaiveDialog verdict={verdict} point={null} waived={waived} />)}>
          {t('waive.open')}
        </button>
      )}
    </section>
  );
}

export function WaiverText({ of }: { of: Waiver }) {
  const ended = hasEnded(of, minutes.value);
  return (
    <>
      {t('checks.waived', { name: of.name, reason: of.reason })}
      {of.point !== null && ` (${of.point})`}
      {of.expires_at_ms !== null && (
        <>
          {' '}
          <strong>{t(ended ? 'waive.ended' : 'waive.until', { at: dateTime(of.expires_at_ms) })}</strong>
        </>
      )}
    </>
  );
}

// Each that no person waived yet.
function Points({ verdict, waived }: Props) {
  const open = openPoints(verdict, minutes.value);
  if (open.length === 0) return null;
  return (
    <>
      <p>{t('waive.points', { count: open.length, all: verdict.points.length })}</p>
      <ul class="faults">
        {open.map((point) => (
          <li key={point} class="fault tone-waiting">
            <p>{point}</p>
            <button
              type="button"
              class="button button-small"
              aria-label={t('waive.point_label', { point })}
              onClick={() => showDialog(<WaiveDialog verdict={verdict} point={point} waived={waived} />)}
            >
              {t('waive.point')}
            </button>
          </li>
        ))}
      </ul>
    </>
  );
}

// The end of that day, here.
function endOf(day: string): number | null {
  const [year = 0, month = 1, date = 1] = day.split('-').map(Number);
  return day === '' ? null : new Date(year, month - 1, date + 1).getTime();
}

function WaiveDialog({ verdict, point, waived }: Props & { point: string | null }) {
  const [day, setDay] = useState('');
  return (
    <OrderDialog
      title={t('waive.title', { id: verdict.id })}
      confirm={t('waive.confirm', { name: person().name })}
      reason={t('waive.reason')}
      send={async (key, reason) => {
        const until = endOf(day);
        await deskCalls.waive(verdict.id, { reason, ...(point === null ? {} : { point }), ...(until === null ? {} : { expires_at_ms: until }) }, key);
        waived();
      }}
    >
      {point !== null && <p class="notice tone-waiting">{point}</p>}
      <p>{t(point === null ? 'waive.text' : 'waive.text_point')}</p>
      <label class="field">
        <span>{t('waive.last_day')}</span>
        <input type="date" value={day} onInput={(event) => setDay(event.currentTarget.value)} />
      </label>
    </OrderDialog>
  );
}
