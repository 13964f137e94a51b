// The calls that this page makes, one function a route.
import { newOrderKey, request, requestText } from './client';
import type {
  Alarm,
  Job,
  JobForecast,
  Ledger,
  LineTest,
  MachineItem,
  MachineWhole,
  Page,
  Program,
  ProgramLines,
  ProviderAnswer,
  ProviderSignIn,
  Receipt,
  Release,
  NewSession,
  Session,
  SignInProvider,
  StoredLikeness,
  Utilisation,
} from './types';

const enc = encodeURIComponent;

export interface JobQuery {
  state?: string;
  machine?: string;
  after?: string;
  limit?: number;
}

// The stream of what passes on a machine's line.
export const wireUrl = (name: string): string => `/api/v1/machines/${enc(name)}/wire`;

const kLineTestMs = 120_000;
const kMostPages = 50; // a list that never ends is cut here

// All pages of a list, in the server's order.
export async function everything<T>(path: string, query: Record<string, string> = {}): Promise<T[]> {
  const items: T[] = [];
  const asked = new URLSearchParams({ limit: '200', ...query });
  for (let pages = 0; pages < kMostPages; ++pages) {
    const page: Page<T> = await request('GET', `${path}?${asked}`);
    items.push(...page.items);
    if (page.next === null) break;
    asked.set('after', page.next);
  }
  return items;
}

export const calls = {
  session: () => request<Session>('GET', '/session'),
  signIn: (who: NewSession) => request<null>('POST', '/session', { body: who }),
  signInProvider: () => request<SignInProvider>('GET', '/session/provider'),
  beginByProvider: () => request<ProviderSignIn>('POST', '/session/provider/begin'),
  signInByProvider: (answer: ProviderAnswer) => request<null>('POST', '/session/provider', { body: answer }),
  signOut: () => request<null>('DELETE', '/session'),

  machines: () => everything<MachineItem>('/machines'),
  machine: (name: string) => request<MachineWhole>('GET', `/machines/${enc(name)}`),
  testLine: (name: string, key: string) =>
    request<LineTest>('POST', `/machines/${enc(name)}/line-test`, { key, timeoutMs: kLineTestMs }),
  confirmReset: (name: string, reason: string, key: string) =>
    request<unknown>('POST', `/machines/${enc(name)}/confirm-reset`, { body: { reason }, key }),

  jobs: (query: JobQuery) => {
    const asked = new URLSearchParams({ limit: String(query.limit ?? 50) });
    if (query.state) asked.set('state', query.state);
    if (query.machine) asked.set('machine', query.machine);
    if (query.after) asked.set('after', query.after);
    return request<Page<Job>>('GET', `/jobs?${asked}`);
  },
  jobsIn: (state: string) => everything<Job>('/jobs', { state }),
  job: (id: number) => request<Job>('GET', `/jobs/${id}`),
  jobForecast: (id: number) => request<JobForecast>('GET', `/jobs/${id}/forecast`),
  addJob: (release: number) => request<Job>('POST', '/jobs', { body: { release }, key: newOrderKey() }),
  arm: (id: number, minutes: number, key: string) => request<Job>('POST', `/jobs/${id}/arm`, { body: { minutes }, key }),
  stop: (id: number, key: string) => request<Job>('POST', `/jobs/${id}/stop`, { key }),
  cancel: (id: number, key: string) => request<Job>('POST', `/jobs/${id}/cancel`, { key }),
  resume: (id: number, reason: string, key: string) =>
    request<Job>('POST', `/jobs/${id}/resume`, { body: { reason }, key }),
  moveJob: (id: number, before: number | null, key: string) =>
    request<Job>('POST', `/jobs/${id}/move`, { body: { before }, key }),
  ledger: (id: number, limit: number, after: string | null) =>
    request<Ledger>('GET', `/jobs/${id}/ledger?limit=${limit}${after ? `&after=${enc(after)}` : ''}`),

  openAlarms: () => everything<Alarm>('/alarms', { state: 'open' }),
  alarms: (after: string | null, machine?: string) =>
    request<Page<Alarm>>(
      'GET',
      `/alarms?state=all&limit=50${machine ? `&machine=${enc(machine)}` : ''}${after ? `&after=${enc(after)}` : ''}`,
    ),
  acknowledge: (id: number) => request<Alarm>('POST', `/alarms/${id}/acknowledge`, { body: {}, key: newOrderKey() }),
  shelve: (id: number, minutes: number, reason: string, key: string) =>
    request<Alarm>('POST', `/alarms/${id}/shelve`, { body: { minutes, reason }, key }),
  unshelve: (id: number) => request<Alarm>('POST', `/alarms/${id}/unshelve`, { body: {}, key: newOrderKey() }),

  programLines: (program: number, revision: number, from: number, count: number) =>
    request<ProgramLines>('GET', `/programs/${program}/lines?revision=${revision}&from=${from}&count=${count}`),
  utilisation: (machine: string, days: number) =>
    request<Utilisation>('GET', `/machines/${enc(machine)}/utilisation?days=${days}`),

  receipts: (after: string | null) =>
    request<Page<Receipt>>('GET', `/receipts?limit=100${after ? `&after=${enc(after)}` : ''}`),
  receiptText: (id: number, broken: boolean) => requestText(`/receipts/${id}/text${broken ? '?form=read' : ''}`),
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
