// The calls of whoever looks after the server: users, tokens, groups of machines, the audit, profiles, the store.
import { everything } from './calls';
import { request, requestRoot } from './client';
import type { SchemaNode } from '../rules/profile_form';
import type { AuditRow, Backup, BackupMade, MachineGroup, MachineWhole, Page, Role, ServerNode, StoreRoom, StoreVerification, Token, TokenMade, User } from './types';

const enc = encodeURIComponent;

export interface Roles {
  role: Role;
  grants: { group: string; role: Role }[];
}

export interface NewToken {
  name: string;
  role: Role;
  user: string | null;
  scope: string[] | null; // null: all that its role may
  expires_at_ms: number | null;
}

// Reading the store through, or copying it, takes as long as it is large.
const kLong_ms = 3_600_000;

export type SecretKind = 'password' | 'pin';

export const peopleCalls = {
  users: () => everything<User>('/users'),
  addUser: (name: string, roles: Roles, key: string) => request<User>('POST', '/users', { body: { name, ...roles }, key }),
  changeUser: (user: User, roles: Roles, disabled: boolean, key: string) =>
    request<User>('PUT', `/users/${enc(user.name)}`, { body: { ...roles, disabled }, ifMatch: user.revision, key }),
  unlock: (name: string, key: string) => request<User>('POST', `/users/${enc(name)}/unlock`, { key }),
  // No key: an answer that has to do with a secret is never kept.
  setSecret: (name: string, kind: SecretKind, secret: string) => request<null>('PUT', `/users/${enc(name)}/${kind}`, { body: { secret } }),
  removeSecret: (name: string, kind: SecretKind) => request<null>('DELETE', `/users/${enc(name)}/${kind}`),

  groups: () => request<Page<MachineGroup>>('GET', '/groups').then((page) => page.items),
  putGroup: (name: string, group: Omit<MachineGroup, 'name'>, key: string) => request<MachineGroup>('PUT', `/groups/${enc(name)}`, { body: group, key }),
  removeGroup: (name: string, key: string) => request<null>('DELETE', `/groups/${enc(name)}`, { key }),

  tokens: () => everything<Token>('/tokens'),
  addToken: (token: NewToken) => request<TokenMade>('POST', '/tokens', { body: token }),
  revoke: (id: number, key: string) => request<null>('DELETE', `/tokens/${id}`, { key }),

  // The API's own description of a profile.
  profileSchema: () => requestRoot<{ components: { schemas: Record<string, SchemaNode> } }>('/api/openapi.json').then(({ components }) => components.schemas['Profile'] ?? {}),
  addMachine: (profile: unknown, key: string) => request<MachineWhole>('POST', '/machines', { body: profile, key }),
  changeMachine: (machine: MachineWhole, profile: unknown, key: string) =>
    request<MachineWhole>('PUT', `/machines/${enc(machine.name)}`, { body: profile, ifMatch: machine.revision, key }),

  store: () => request<StoreRoom>('GET', '/store'),
  verifyStore: (key: string) => request<StoreVerification>('POST', '/store/verify', { key, timeoutMs: kLong_ms }),
  backups: () => request<Page<Backup>>('GET', '/backups').then((page) => page.items),
  addBackup: (key: string) => request<BackupMade>('POST', '/backups', { key, timeoutMs: kLong_ms }),
  removeBackup: (name: string, key: string) => request<null>('DELETE', `/backups/${enc(name)}`, { key }),

  servers: () => request<Page<ServerNode>>('GET', '/nodes').then((page) => page.items),
  handOver: (machine: string, node: string, reason: string, key: string) =>
    request<unknown>('POST', `/machines/${enc(machine)}/hand-over`, { body: { node, reason }, key }),
  takeOver: (machine: string, reason: string, key: string) => request<unknown>('POST', `/machines/${enc(machine)}/take-over`, { body: { reason }, key }),

  audit: (filter: Record<string, string>, after: string | null) => {
    const query = new URLSearchParams({ limit: '50' });
    for (const [name, value] of Object.entries(filter)) if (value !== '') query.set(name, value);
    if (after !== null) query.set('after', after);
    return request<Page<AuditRow>>('GET', `/audit?${query}`);
  },
};
