// What one check found, each finding with its line; what it did not check; its pictures.
import { deskCalls } from '../../api/desk_calls';
import type { Outcome } from '../../api/types';
import { count } from '../../format/numbers';
import { duration } from '../../format/times';
import { wordingOfOutcome } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Badge } from '../../parts/badge';
import { Facts } from '../../parts/facts';
import { Failure } from '../../parts/failure';
import { Icon } from '../../parts/icon';
import { useLoaded } from '../../parts/use_loaded';
import { hrefs } from '../../router';
import { atLeast } from '../../rules/roles';
import { findingsOf, type Finding } from '../../rules/verdicts';
import { roleOn } from '../../state/shop';
import { CheckPictures } from './check_pictures';

export const OutcomeBadge = ({ outcome }: { outcome: Outcome }) => <Badge wording={wordingOfOutcome(outcome)} />;

export function VerdictReport({ id, program }: { id: number; program: number }) {
  const { value: verdict, error } = useLoaded(String(id), () => deskCalls.check(id));
  if (!verdict) return <Failure error={error} />;
  const findings = findingsOf(verdict);
  return (
    <section class="card" aria-label={t('checks.report', { id })}>
      <h2>
        {t('checks.report', { id })} <OutcomeBadge outcome={verdict.verdict} />
      </h2>
      <p class="quiet-text">{t('checks.of', { revision: verdict.revision, machine: verdict.machine, control: verdict.control.title })}</p>
      {findings.length === 0 && <p>{t('checks.no_finding')}</p>}
      <ul class="faults">
        {findings.map((one) => (
          <FindingRow key={`${one.id} ${one.file} ${one.line} ${one.text}`} finding={one} program={program} revision={verdict.revision} />
        ))}
        {verdict.folded.map(({ id: kind, more }) => (
          <li key={kind} class="hint">
            {t('side.more', { count: more, id: kind })}
          </li>
        ))}
      </ul>
      {verdict.not_checked.length > 0 && (
        <>
          <h3>{t('checks.not_checked')}</h3>
          <ul class="listed">
            {verdict.not_checked.map((sentence) => (
              <li key={sentence}>{sentence}</li>
            ))}
          </ul>
        </>
      )}
      <Facts
        facts={[
          [t('checks.blocks'), count(verdict.blocks)],
          [t('checks.cycle'), verdict.timing ? duration(verdict.timing.cycle_s) : null],
          [t('checks.stalls'), verdict.timing && verdict.timing.stalls > 0 ? t('checks.stall_text', { count: verdict.timing.stalls, time: duration(verdict.timing.stall_s), line: verdict.timing.first_stall_line }) : null],
        ]}
      />
      {atLeast(roleOn(verdict.machine), 'programmer') && <CheckPictures verdict={verdict} />}
    </section>
  );
}

const kLooks = { error: ['tone-bad', 'bad'], warning: ['tone-waiting', 'waiting'], note: ['tone-active', 'quiet'] } as const;

function FindingRow({ finding, program, revision }: { finding: Finding; program: number; revision: number }) {
  const { line, file, text, alarm, severity } = finding;
  const [tone, shape] = kLooks[severity];
  return (
    <li class={`fault ${tone}`} data-fault={finding.id}>
      <span class="fault-go">
        <Icon shape={shape} /> <span class="unseen">{t(`severity.${severity}`)}</span>{' '}
        {line > 0 && file === null && (
          <a href={hrefs.program(program, 'text', { revision: String(revision), line: String(line) })}>{t('fault.line', { line })}</a>
        )}
        {line > 0 && file !== null && t('checks.line_of', { line, program: file })}
      </span>
      <p>{text}</p>
      {alarm && <p class="hint">{t('fault.alarm', { alarm })}</p>}
    </li>
  );
}
