// The calls that this page makes, one function a route.
import { newOrderKey, request } from './client';
import type { Job, Ledger, MachineItem, MachineWhole, Page, Program, Receipt, Release, Session, StoredLikeness } from './types';

const enc = encodeURIComponent;

export interface JobQuery {
  state?: string;
  after?: string;
  limit?: number;
}

// All pages of a list, in the server's order.
async function everything<T>(path: string): Promise<T[]> {
  const items: T[] = [];
  let after: string | null = null;
  do {
    const page: Page<T> = await request('GET', `${path}?limit=200${after ? `&after=${enc(after)}` : ''}`);
    items.push(...page.items);
    after = page.next;
  } while (after);
  return items;
}

export const calls = {
  session: () => request<Session>('GET', '/session'),
  signIn: (token: string) => request<null>('POST', '/session', { body: { token } }),
  signOut: () => request<null>('DELETE', '/session'),

  machines: () => everything<MachineItem>('/machines'),
  machine: async (name: string) => summaryOf(await request<MachineWhole>('GET', `/machines/${enc(name)}`)),
  confirmReset: (name: string, reason: string, key: string) =>
    request<unknown>('POST', `/machines/${enc(name)}/confirm-reset`, { body: { reason }, key }),

  jobs: (query: JobQuery) => {
    const asked = new URLSearchParams({ limit: String(query.limit ?? 50) });
    if (query.state) asked.set('state', query.state);
    if (query.after) asked.set('after', query.after);
    return request<Page<Job>>('GET', `/jobs?${asked}`);
  },
  job: (id: number) => request<Job>('GET', `/jobs/${id}`),
  addJob: (release: number) => request<Job>('POST', '/jobs', { body: { release }, key: newOrderKey() }),
  arm: (id: number, minutes: number, key: string) => request<Job>('POST', `/jobs/${id}/arm`, { body: { minutes }, key }),
  stop: (id: number, key: string) => request<Job>('POST', `/jobs/${id}/stop`, { key }),
  cancel: (id: number, key: string) => request<Job>('POST', `/jobs/${id}/cancel`, { key }),
  resume: (id: number, reason: string, key: string) =>
    request<Job>('POST', `/jobs/${id}/resume`, { body: { reason }, key }),
  ledger: (id: number, limit: number, after: string | null) =>
    request<Ledger>('GET', `/jobs/${id}/ledger?limit=${limit}${after ? `&after=${enc(after)}` : ''}`),

  receipts: () => request<Page<Receipt>>('GET', '/receipts?limit=100'),
  acceptReceipt: (id: number, stored: StoredLikeness | null, key: string) =>
    request<Receipt>('POST', `/receipts/${id}/accept`, {
      body: stored ? { program: stored.program, revision: stored.revision } : {},
      key,
    }),
  acceptFromQuarantine: (id: number, reason: string, key: string) =>
    request<Receipt>('POST', `/receipts/${id}/accept`, { body: { reason }, key }),
  discardReceipt: (id: number, reason: string, key: string) =>
    request<Receipt>('POST', `/receipts/${id}/discard`, { body: { reason }, key }),

  releases: () => everything<Release>('/releases'),
  programs: () => everything<Program>('/programs'),
  program: (id: number) => request<Program>('GET', `/programs/${id}`),
};

export function summaryOf(whole: MachineWhole): MachineItem {
  const { profile } = whole;
  return {
    name: whole.name,
    title: profile.title ?? '',
    dialect: profile.dialect,
    kind: profile.kind,
    link: profile.link.url,
    revision: whole.revision,
    status: whole.status,
  };
}
