// Who may do what. The server decides; this only keeps buttons away from those whom it would refuse.
import type { Role } from '../api/types';

const kOrder: Role[] = ['viewer', 'operator', 'programmer', 'approver', 'admin'];

export const atLeast = (role: Role, needed: Role): boolean => kOrder.indexOf(role) >= kOrder.indexOf(needed);
