// Servers that share a store: the lines of all of them as one list, and what a person may do with each from this server.
import type { ServerNode } from '../api/types';

export type ServedLine = ServerNode['machines'][number] & { server: ServerNode };

// By machine.
export const linesOf = (servers: readonly ServerNode[]): ServedLine[] =>
  servers.flatMap((server) => server.machines.map((machine) => ({ ...machine, server }))).sort((a, b) => a.name.localeCompare(b.name));

export type LineOrder = 'hand_over' | 'take_over';

// This server gives away what it has, where there is another; it takes from one that is not heard of.
export function orderOf({ server }: ServedLine, servers: readonly ServerNode[]): LineOrder | null {
  if (server.this) return servers.length > 1 ? 'hand_over' : null;
  return server.answers ? null : 'take_over';
}
