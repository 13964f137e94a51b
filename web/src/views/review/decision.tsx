// The decision on a release: towards the control only where nothing hinders it, back always. The server decides by the
// same rules, and its refusal is shown as it is.
import { useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Release, VerdictSummary } from '../../api/types';
import { releaseText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { minutes } from '../../parts/clock';
import { hindranceOf, stepsOf, type ReleaseStepOffer } from '../../rules/releases';
import { person } from '../../state/shop';

interface Props {
  release: Release;
  verdict: VerdictSummary | null;
  fourEyes: boolean;
  needsProof: boolean; // an operator signs the proving off first
  isApprover: boolean;
  changed: (release: Release) => void;
}

export function Decision({ release, verdict, fourEyes, needsProof, isApprover, changed }: Props) {
  const steps = stepsOf(release);
  const hindrance = hindranceOf(verdict, minutes.value);
  if (steps.length === 0) return null;
  const lacksProof = needsProof && release.state === 'proving' && release.proved_by === null;
  const isOwn = release.created_by === person().name;
  return (
    <section class="card" aria-label={t('decide.title')}>
      <h2>{t('decide.title')}</h2>
      {fourEyes && <p class={isOwn ? 'notice tone-waiting' : 'hint'}>{t(isOwn ? 'decide.own' : 'decide.four_eyes', { machine: release.machine })}</p>}
      {hindrance && <p class="notice tone-waiting">{t(`hindrance.${hindrance}`)}</p>}
      {lacksProof && <p class="hint">{t('decide.needs_proof')}</p>}
      {!isApprover && <p class="hint">{t('decide.only_approver', { machine: release.machine })}</p>}
      {isApprover && (
        <div class="dialog-buttons decide-buttons">
          {steps.map((step) => (
            <StepButton key={step.to} step={step} release={release} blocked={step.towardsControl && (hindrance !== null || lacksProof)} changed={changed} />
          ))}
        </div>
      )}
    </section>
  );
}

interface StepProps {
  step: ReleaseStepOffer;
  release: Release;
  changed: (release: Release) => void;
}

function StepButton({ blocked, ...props }: StepProps & { blocked: boolean }) {
  const { step, release } = props;
  const look = step.towardsControl ? ' button-main' : step.to === 'obsolete' ? ' button-danger' : '';
  return (
    <button type="button" class={`button${look}`} aria-disabled={blocked} onClick={() => !blocked && showDialog(<StepDialog {...props} />)}>
      {t(`decide.${release.state}_${step.to}`)}
    </button>
  );
}

const kFirstTransfers = 1;

// Returning, withdrawing and approving need a reason; a proving needs to know how often.
function StepDialog({ step, release, changed }: StepProps) {
  const [transfers, setTransfers] = useState(kFirstTransfers);
  const isProving = step.to === 'proving';
  return (
    <OrderDialog
      title={t('decide.step', { id: release.id, state: releaseText(step.to) })}
      confirm={t(`decide.${release.state}_${step.to}`)}
      danger={step.to === 'obsolete'}
      reason={t(step.to === 'approved' ? 'decide.sign_off' : isProving ? 'decide.comment' : 'decide.why')}
      send={async (key, note) => changed(await deskCalls.moveRelease(release.id, { to: step.to, note, ...(isProving ? { transfers } : {}) }, key))}
    >
      <p>{t(`decide_text.${step.to}`)}</p>
      {isProving && (
        <label class="field">
          <span>{t('decide.transfers')}</span>
          <input type="number" min={1} max={1000} required value={transfers} onInput={(event) => setTransfers(Number(event.currentTarget.value))} />
        </label>
      )}
    </OrderDialog>
  );
}
