// What a check reports: each finding with its line, what it did not check, how long the program takes.
import type { Verdict } from '../../api/types';
import { count } from '../../format/numbers';
import { duration } from '../../format/times';
import { t } from '../../i18n/i18n';
import { Facts } from '../../parts/facts';
import { Icon } from '../../parts/icon';
import { findingsOf, type Finding, type FoundBy } from '../../rules/verdicts';

type HrefOf = (line: number) => string | null; // of the program itself; null: its text is at no address

export function FindingList({ report, hrefOf }: { report: FoundBy & Pick<Verdict, 'folded' | 'not_checked'>; hrefOf: HrefOf }) {
  const findings = findingsOf(report);
  return (
    <>
      {findings.length === 0 && <p>{t('checks.no_finding')}</p>}
      <ul class="faults">
        {findings.map((one) => (
          <FindingRow key={`${one.id} ${one.file} ${one.line} ${one.text}`} finding={one} hrefOf={hrefOf} />
        ))}
        {report.folded.map(({ id: kind, more }) => (
          <li key={kind} class="hint">
            {t('side.more', { count: more, id: kind })}
          </li>
        ))}
      </ul>
      {report.not_checked.length > 0 && (
        <>
          <h3>{t('checks.not_checked')}</h3>
          <ul class="listed">
            {report.not_checked.map((sentence) => (
              <li key={sentence}>{sentence}</li>
            ))}
          </ul>
        </>
      )}
    </>
  );
}

const kLooks = { error: ['tone-bad', 'bad'], warning: ['tone-waiting', 'waiting'], note: ['tone-active', 'quiet'] } as const;

function FindingRow({ finding, hrefOf }: { finding: Finding; hrefOf: HrefOf }) {
  const { line, file, text, alarm, severity } = finding;
  const [tone, shape] = kLooks[severity];
  const href = hrefOf(line);
  return (
    <li class={`fault ${tone}`} data-fault={finding.id}>
      <span class="fault-go">
        <Icon shape={shape} /> <span class="unseen">{t(`severity.${severity}`)}</span>{' '}
        {line > 0 && file === null && (href === null ? t('fault.line', { line }) : <a href={href}>{t('fault.line', { line })}</a>)}
        {line > 0 && file !== null && t('checks.line_of', { line, program: file })}
      </span>
      <p>{text}</p>
      {alarm && <p class="hint">{t('fault.alarm', { alarm })}</p>}
    </li>
  );
}

export const ReportFacts = ({ report }: { report: Pick<Verdict, 'blocks' | 'timing'> }) => (
  <Facts
    facts={[
      [t('checks.blocks'), count(report.blocks)],
      [t('checks.cycle'), report.timing ? duration(report.timing.cycle_s) : null],
      [
        t('checks.stalls'),
        report.timing && report.timing.stalls > 0
          ? t('checks.stall_text', { count: report.timing.stalls, time: duration(report.timing.stall_s), line: report.timing.first_stall_line })
          : null,
      ],
    ]}
  />
);
