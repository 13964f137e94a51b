// What one stored check found, with its pictures.
import { deskCalls } from '../../api/desk_calls';
import type { Outcome } from '../../api/types';
import { wordingOfOutcome } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Badge } from '../../parts/badge';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { hrefs } from '../../router';
import { atLeast } from '../../rules/roles';
import { roleOn } from '../../state/shop';
import { CheckPictures } from './check_pictures';
import { FindingList, ReportFacts } from './finding_list';

export const OutcomeBadge = ({ outcome }: { outcome: Outcome }) => <Badge wording={wordingOfOutcome(outcome)} />;

export function VerdictReport({ id, program }: { id: number; program: number }) {
  const { value: verdict, error } = useLoaded(String(id), () => deskCalls.check(id));
  if (!verdict) return <Failure error={error} />;
  return (
    <section class="card" aria-label={t('checks.report', { id })}>
      <h2>
        {t('checks.report', { id })} <OutcomeBadge outcome={verdict.verdict} />
      </h2>
      <p class="quiet-text">{t('checks.of', { revision: verdict.revision, machine: verdict.machine, control: verdict.control.title })}</p>
      <FindingList report={verdict} hrefOf={(line) => hrefs.program(program, 'text', { revision: String(verdict.revision), line: String(line) })} />
      <ReportFacts report={verdict} />
      {atLeast(roleOn(verdict.machine), 'programmer') && <CheckPictures verdict={verdict} />}
    </section>
  );
}
