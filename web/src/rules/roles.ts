// Who may do what. The server decides; this only keeps buttons away from those whom it would refuse.
import type { Role } from '../api/types';

export const kRoles: readonly Role[] = ['viewer', 'operator', 'programmer', 'approver', 'admin'];

export const highest = (roles: Role[]): Role => roles.reduce((best, role) => (kRoles.indexOf(role) > kRoles.indexOf(best) ? role : best), 'viewer');

export const atLeast = (role: Role, needed: Role): boolean => kRoles.indexOf(role) >= kRoles.indexOf(needed);
