// Which releases may go to a machine.
import type { MachineGroup, Release, ReleaseState, VerdictSummary } from '../api/types';

export const isReleased = (release: Release): boolean => release.state === 'proving' || release.state === 'approved';

// A proving takes so many transfers and no more.
export const mayBeQueued = (release: Release): boolean =>
  release.state === 'approved' || (release.state === 'proving' && release.transfers_done < release.transfers_allowed);

// It waits for a person's decision.
export const isUnderReview = ({ state }: Release): boolean => state === 'in_review' || state === 'proving';

// The newest verdict on what it binds.
export const verdictOf = (verdicts: readonly VerdictSummary[], release: Release): VerdictSummary | null =>
  verdicts
    .filter((one) => one.sha256 === release.sha256 && one.machine === release.machine && one.delivery === release.delivery)
    .sort((a, b) => b.id - a.id)[0] ?? null;

// The newest one before it that went to the same machine.
export const lastBefore = (releases: readonly Release[], release: Release): Release | null =>
  releases
    .filter((one) => one.id < release.id && one.machine === release.machine && (one.approved_by !== null || one.state === 'proving'))
    .sort((a, b) => b.id - a.id)[0] ?? null;

// Those of the program's present revision that are still of use, the newest first.
export const presentOf = (releases: readonly Release[], { revision }: { revision: number }): Release[] =>
  releases.filter((one) => one.revision === revision && one.state !== 'obsolete').sort((a, b) => b.id - a.id);

// Those that may be queued for an order, the likeliest first: for its machine alone, and of its part's programs first.
export function fitting(releases: readonly Release[], machine: string | null, ofPart: ReadonlySet<number>): Release[] {
  const rank = ({ program }: Release): number => (ofPart.has(program) ? 0 : 1);
  return releases.filter((one) => mayBeQueued(one) && (machine === null || one.machine === machine)).sort((a, b) => rank(a) - rank(b) || b.id - a.id);
}

export type Hindrance = 'not_checked' | 'failed' | 'not_waived' | 'waiver_ended' | 'stale';

type Waived = Pick<VerdictSummary, 'points' | 'waivers'>;
export type Waiver = VerdictSummary['waivers'][number];

export const hasEnded = ({ expires_at_ms }: Waiver, now_ms: number): boolean => expires_at_ms !== null && expires_at_ms <= now_ms;

// null: of all of them.
const isPointWaived = ({ waivers }: Waived, point: string | null, now_ms: number): boolean =>
  waivers.some((one) => one.point === point && !hasEnded(one, now_ms));

// Points that no person waived yet.
export const openPoints = (verdict: Waived, now_ms: number): string[] =>
  isPointWaived(verdict, null, now_ms) ? [] : verdict.points.filter((point) => !isPointWaived(verdict, point, now_ms));

const isWaived = (verdict: Waived, now_ms: number): boolean =>
  isPointWaived(verdict, null, now_ms) || (verdict.points.length > 0 && openPoints(verdict, now_ms).length === 0);

// What keeps it from going on towards the control. The server decides; this is for people.
export function hindranceOf(verdict: Pick<VerdictSummary, 'verdict' | 'stale'> & Waived | null, now_ms: number): Hindrance | null {
  if (!verdict) return 'not_checked';
  if (verdict.verdict === 'fail') return 'failed';
  if (verdict.stale) return 'stale';
  if (verdict.verdict === 'pass' || isWaived(verdict, now_ms)) return null;
  return verdict.waivers.some((one) => hasEnded(one, now_ms)) ? 'waiver_ended' : 'not_waived';
}

// Whether another person than who wrote or released a text must approve it on this machine.
export const needsFourEyes = (groups: readonly MachineGroup[], machine: string): boolean =>
  groups.some((group) => group.four_eyes && group.machines.includes(machine));

// Whether an operator signs a proving off before it is approved for this machine; only a group can waive that.
export const needsSignOff = (groups: readonly MachineGroup[], machine: string): boolean =>
  !groups.some((group) => !group.operator_sign_off && group.machines.includes(machine));

export interface ReleaseStepOffer {
  to: ReleaseState;
  towardsControl: boolean; // it needs a verdict that clears
}

// Steps that an approver may take from a state, the usual one first.
const kSteps: Record<ReleaseState, readonly ReleaseStepOffer[]> = {
  draft: [],
  in_review: [
    { to: 'proving', towardsControl: true },
    { to: 'draft', towardsControl: false },
    { to: 'obsolete', towardsControl: false },
  ],
  proving: [
    { to: 'approved', towardsControl: true },
    { to: 'in_review', towardsControl: false },
    { to: 'obsolete', towardsControl: false },
  ],
  approved: [{ to: 'obsolete', towardsControl: false }],
  obsolete: [],
};
export const stepsOf = ({ state }: Release): readonly ReleaseStepOffer[] => kSteps[state];
