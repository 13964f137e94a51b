// The programs of a part, each with its next step towards a machine: hand it in, look at its review, or queue a job.
// Queueing sends nothing.
import { useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Part, Program, Release } from '../../api/types';
import { deliveryText, releaseText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { showDialog } from '../../parts/dialog';
import { Failure } from '../../parts/failure';
import { WhatWasQueued, type Queued } from '../../parts/queued';
import { useLoaded } from '../../parts/use_loaded';
import { hrefs } from '../../router';
import { isUnderReview, mayBeQueued, presentOf } from '../../rules/releases';
import { atLeast } from '../../rules/roles';
import { bestRole, roleOn } from '../../state/shop';
import { QueueDialog } from '../orders/queue_dialog';

export function PartPrograms({ part, programs }: { part: Part; programs: readonly Program[] }) {
  const [queued, setQueued] = useState<Queued | null>(null);
  return (
    <>
      <ul class="listed">
        {programs.map((program) => (
          <li key={program.id} data-program={program.id}>
            <a href={hrefs.program(program.id)}>{program.name}</a>{' '}
            <span class="quiet-text">
              {t('job.revision', { revision: program.revision })}, {program.origin.machine}
              {program.origin.part_revision !== part.revision && `, ${t('parts.older_values', { revision: program.origin.part_revision ?? 0 })}`}
            </span>
            <NextStep program={program} queued={setQueued} />
          </li>
        ))}
      </ul>
      {queued && <WhatWasQueued of={queued} />}
    </>
  );
}

function NextStep({ program, queued }: { program: Program; queued: (made: Queued) => void }) {
  const releases = useLoaded(`${program.id}/${program.revision}`, () => deskCalls.releasesOf(program.id));
  if (releases.error !== null) return <Failure error={releases.error} />;
  if (!releases.value) return null;
  const present = presentOf(releases.value, program);
  if (present.length === 0) return atLeast(bestRole(), 'programmer') ? <ToRelease program={program} /> : <p class="quiet-text">{t('parts.not_released')}</p>;
  return (
    <ul>
      {present.map((release) => (
        <li key={release.id}>
          {t('parts.release', { id: release.id, machine: release.machine, delivery: deliveryText(release.delivery), state: releaseText(release.state) })}{' '}
          <StepOf release={release} queued={queued} />
        </li>
      ))}
    </ul>
  );
}

const ToRelease = ({ program }: { program: Program }) => (
  <p>
    <a class="button button-small" href={hrefs.program(program.id, 'release')} aria-label={t('parts.to_release_of', { name: program.name })}>
      {t('parts.to_release')}
    </a>
  </p>
);

function StepOf({ release, queued }: { release: Release; queued: (made: Queued) => void }) {
  if (mayBeQueued(release) && atLeast(roleOn(release.machine), 'operator'))
    return (
      <button type="button" class="button button-small" onClick={() => showDialog(<QueueDialog release={release} queued={queued} />)} aria-label={t('parts.queue_of', { id: release.id })}>
        {t('parts.queue')}
      </button>
    );
  if (isUnderReview(release) && atLeast(roleOn(release.machine), 'approver')) return <a href={hrefs.reviewed(release.id)}>{t('parts.to_review')}</a>;
  if (release.state === 'draft') return <a href={hrefs.program(release.program, 'release')}>{t('release.hand_in')}</a>;
  return null;
}
