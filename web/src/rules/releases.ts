// Which releases may go to a machine.
import type { Release } from '../api/types';

export const isReleased = (release: Release): boolean => release.state === 'proving' || release.state === 'approved';

// A proving takes so many transfers and no more.
export const mayBeQueued = (release: Release): boolean =>
  release.state === 'approved' || (release.state === 'proving' && release.transfers_done < release.transfers_allowed);
