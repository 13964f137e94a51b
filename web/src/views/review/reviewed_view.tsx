// One release as its reviewer sees it: what it binds, what was checked, what has changed, who did what with it so far,
// and the decision.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import { deskCalls } from '../../api/desk_calls';
import { peopleCalls } from '../../api/people_calls';
import type { AuditRow, Release } from '../../api/types';
import { shortHash } from '../../format/numbers';
import { dateTime } from '../../format/times';
import { deliveryText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Facts } from '../../parts/facts';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { hrefs } from '../../router';
import { lastBefore, needsFourEyes, needsSignOff, verdictOf } from '../../rules/releases';
import { atLeast } from '../../rules/roles';
import { takePrograms } from '../../state/changes';
import { roleOn } from '../../state/shop';
import { Since } from '../program/since';
import { VerdictReport } from '../program/verdict_report';
import { Decision } from './decision';
import { Proof } from './proof';
import { StateOf } from './review_view';
import { WaiveButton } from './waive';

export function ReviewedView({ id }: { id: number }) {
  const { value: release, error, set } = useLoaded(String(id), () => deskCalls.release(id));
  const program = useLoaded(release ? String(release.program) : null, () => calls.program(release?.program ?? 0));
  useEffect(() => {
    if (program.value) takePrograms([program.value]);
  }, [program.value]);
  return (
    <>
      <p class="back">
        <a href={hrefs.review}>{t('review.back')}</a>
      </p>
      <h1 tabIndex={-1}>
        {release && program.value ? t('review.title', { program: program.value.name, revision: release.revision, machine: release.machine }) : t('review.release', { id })}
      </h1>
      <Failure error={error ?? program.error} />
      {release && <Reviewed release={release} changed={set} />}
    </>
  );
}

function Reviewed({ release, changed }: { release: Release; changed: (release: Release) => void }) {
  const [round, setRound] = useState(0);
  const key = `${release.id} ${release.state} ${release.proof ?? ''} ${round}`;
  const verdicts = useLoaded(key, () => deskCalls.checks(release.program));
  const releases = useLoaded(String(release.program), () => deskCalls.releasesOf(release.program));
  const groups = useLoaded('groups', () => peopleCalls.groups());
  const isApprover = atLeast(roleOn(release.machine), 'approver');
  const history = useLoaded(isApprover ? key : null, () => deskCalls.releaseHistory(release.id));
  const verdict = verdicts.value ? verdictOf(verdicts.value, release) : null;
  return (
    <>
      <section class="card" aria-label={t('review.what')}>
        <h2>{t('review.what')}</h2>
        <Facts
          facts={[
            [t('column.state'), <StateOf release={release} />],
            [t('column.machine'), `${release.machine}, ${deliveryText(release.delivery)}`],
            [t('fact.sha256'), <code title={release.sha256}>{shortHash(release.sha256)}…</code>],
            [t('review.drafted'), t('library.changed', { name: release.created_by, at: dateTime(release.created_at_ms) })],
            [t('review.look'), <Links release={release} />],
          ]}
        />
        {history.value && history.value.length > 0 && <History rows={history.value} />}
      </section>
      <Failure error={verdicts.error ?? releases.error ?? groups.error ?? history.error} />
      {verdict && <VerdictReport key={verdict.id} id={verdict.id} program={release.program} />}
      {verdict && isApprover && <WaiveButton verdict={verdict} waived={() => setRound((before) => before + 1)} />}
      <section class="card" aria-label={t('review.since')}>
        <h2>{t('review.since')}</h2>
        {releases.value && <Since release={release} before={lastBefore(releases.value, release)} />}
      </section>
      {verdicts.value && (
        <>
          <Proof release={release} changed={changed} />
          <Decision
            release={release}
            verdict={verdict}
            fourEyes={needsFourEyes(groups.value ?? [], release.machine)}
            needsProof={needsSignOff(groups.value ?? [], release.machine)}
            isApprover={isApprover}
            changed={changed}
          />
        </>
      )}
    </>
  );
}

const Links = ({ release }: { release: Release }) => {
  const of = { revision: String(release.revision), machine: release.machine };
  return (
    <>
      <a href={hrefs.program(release.program, 'text', of)}>{t('review.text')}</a>, <a href={hrefs.program(release.program, 'text', { ...of, path: '1' })}>{t('path.title')}</a>
    </>
  );
};

const History = ({ rows }: { rows: readonly AuditRow[] }) => (
  <>
    <h3>{t('review.history')}</h3>
    <ol class="listed">
      {[...rows].reverse().map((row) => (
        <li key={row.seq}>
          <span class="quiet-text">{dateTime(row.at_ms)}</span> {row.actor}: {row.detail || row.action}
        </li>
      ))}
    </ol>
  </>
);
