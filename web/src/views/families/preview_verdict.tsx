// The verdict on a preview, once the values rest. While they change the one before stays, marked as old, and a check that
// runs is given up, so that the next preview does not wait for it. The server stores nothing.
import { useEffect, useRef } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Delivery, PreviewVerdict as JudgedPreview } from '../../api/types';
import { duration } from '../../format/times';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { useAfterPause } from '../../parts/use_after_pause';
import { useLoaded } from '../../parts/use_loaded';
import type { Values } from '../../rules/part_values';
import { FindingList, ReportFacts } from '../program/finding_list';
import { OutcomeBadge } from '../program/verdict_report';

const kPause_ms = 400; // a check takes longer than rendering

interface Props {
  family: string;
  machine: string;
  delivery: Delivery;
  values: string; // as JSON
  isNew: boolean; // the values change just now
}

export function PreviewVerdict({ family, machine, delivery, values, isNew }: Props) {
  const shown = JSON.stringify([family, machine, delivery, values]);
  const asked = useAfterPause(shown, kPause_ms);
  const key = isNew || asked !== shown ? null : asked;
  const running = useRef<AbortController | null>(null);
  const { value: now, error, loading } = useLoaded(key, () => {
    running.current = new AbortController();
    return deskCalls.previewVerdict(family, JSON.parse(values) as Values, machine, delivery, running.current.signal);
  });
  useEffect(() => () => running.current?.abort(), [key]);
  const kept = useRef<JudgedPreview | null>(null);
  if (now) kept.current = now;
  const isOld = key === null || loading;
  const verdict = now ?? (isOld ? kept.current : null);
  if (error !== null) return <Failure error={error} />;
  if (!verdict) return <p role="status">{t('checks.running')}</p>;
  return (
    <details class={isOld ? 'judged quiet-text' : 'judged'} aria-busy={isOld}>
      <summary>
        {t('preview.verdict')} <OutcomeBadge outcome={verdict.verdict} /> {verdict.timing && t('preview.cycle', { time: duration(verdict.timing.cycle_s) })}
      </summary>
      <FindingList report={verdict} hrefOf={() => null} />
      <ReportFacts report={verdict} />
    </details>
  );
}
