// All that the page knows of the shop, as signals: each machine has its own, so that news of one draws one card and no
// other. Only the loader changes what stands here.
import { computed, signal, type ReadonlySignal, type Signal } from '@preact/signals';
import type { Alarm, Job, MachineItem, MachineStatus, Release, Role, Session } from '../api/types';
import { highest } from '../rules/roles';

// 'lost': what is shown was true at `heardAt` and may be false now; 0: nothing was ever heard.
export type Connection = { phase: 'connecting' } | { phase: 'live' } | { phase: 'lost'; heardAt: number };

export type MachineHead = Omit<MachineItem, 'status'>;

// What decides where a machine stands and which orders it takes. It changes seldom, the figures of a feed many times a
// second: what depends on this alone is not redrawn with each figure.
export type Core = Pick<
  MachineStatus,
  'line' | 'stall' | 'job' | 'needs_confirmation' | 'stop_wanted' | 'asks_since_ms' | 'confirms' | 'link_error' | 'link_error_said' | 'link_note'
> & { plc_alarm: number; wrong: number };

export interface Machine {
  readonly name: string;
  readonly head: Signal<MachineHead>;
  readonly status: Signal<MachineStatus>;
  readonly core: ReadonlySignal<Core>;
  reports: number; // progress reports taken so far: shows whether an answer is older than a report
}

export function newMachine(head: MachineHead, status: MachineStatus): Machine {
  const own = signal(status);
  let before: Core | null = null;
  const core = computed(() => (before = kept(before, coreOf(own.value))));
  return { name: head.name, head: signal(head), status: own, core, reports: 0 };
}

function coreOf(status: MachineStatus): Core {
  const { line, stall, job, needs_confirmation, stop_wanted, asks_since_ms, confirms, link_error, link_error_said, link_note } = status;
  const wrong = Object.values(status.line_errors).reduce((sum, one) => sum + one, 0);
  return { line, stall, job, needs_confirmation, stop_wanted, asks_since_ms, confirms, link_error, link_error_said, link_note, plc_alarm: status.plc?.alarm ?? 0, wrong };
}

// The one before, where it says the same: then nothing that depends on it is called. `link_error_said` follows from
// `link_error`, and comes as another object each time.
function kept(before: Core | null, now: Core): Core {
  if (before === null) return now;
  return (Object.keys(now) as (keyof Core)[]).every((name) => name === 'link_error_said' || before[name] === now[name]) ? before : now;
}

export type SessionState = 'unknown' | 'none' | Session;

export const session = signal<SessionState>('unknown');
export const signedOutBecause = signal<string | null>(null);
export const connection = signal<Connection>({ phase: 'connecting' });
export const loaded = signal(false);
export const loadError = signal<string | null>(null);

export const machines = signal<ReadonlyMap<string, Machine>>(new Map());
export const jobs = signal<ReadonlyMap<number, Job>>(new Map());
export const olderJobs = signal<string | null>(null); // where the next page of jobs begins
export const programs = signal<ReadonlyMap<number, string>>(new Map()); // names
export const releases = signal<readonly Release[]>([]);
export const alarms = signal<ReadonlyMap<number, Alarm>>(new Map()); // the open ones
export const receiptNews = signal(0); // grows when something was received or decided

export const isLive = computed(() => connection.value.phase === 'live');
export const isLost = computed(() => connection.value.phase === 'lost');

export const jobsNewestFirst = computed(() => [...jobs.value.values()].sort((a, b) => b.id - a.id));

const byRank = (a: Job, b: Job): number => a.rank - b.rank || a.id - b.id;

// The queue of each machine, in its order.
export const queues = computed(() => {
  const all = new Map<string, Job[]>();
  for (const job of jobs.value.values()) {
    if (job.state !== 'queued') continue;
    const queue = all.get(job.machine);
    if (queue) queue.push(job);
    else all.set(job.machine, [job]);
  }
  for (const queue of all.values()) queue.sort(byRank);
  return all;
});

const kNone: Job[] = [];
// The one that a person arms next: the first that is not on hold, or the first.
export const nextOf = (machine: string): Job | null => {
  const queue = queueOf(machine);
  return queue.find(({ on_hold }) => on_hold === null) ?? queue[0] ?? null;
};

export const queueOf = (machine: string): Job[] => queues.value.get(machine) ?? kNone;

// The job of each machine that has ended and whose end no person has confirmed: until then the server arms no other there.
const ended = computed(() => {
  const all = new Map<string, Job>();
  for (const job of jobs.value.values()) if (job.needs_end_confirmation) all.set(job.machine, job);
  return all;
});
export const endedOf = (machine: string): Job | null => ended.value.get(machine) ?? null;

export const coreOfMachine = (machine: string): Core | null => machines.value.get(machine)?.core.value ?? null;

export const programName = (id: number): string | null => programs.value.get(id) ?? null;

// The signed-in person; only for what is shown inside a session.
export function person(): Session {
  const now = session.value;
  return now === 'unknown' || now === 'none' ? { name: '', role: 'viewer', by: 'token', scope: [], machines: {} } : now;
}

// Their role on one machine: groups of machines may have another one than the rest of the shop.
export const roleOn = (machine: string): Role => person().machines[machine] ?? person().role;

// The highest role that they have anywhere, for what the whole list of machines offers.
export const bestRole = (): Role => highest([person().role, ...Object.values(person().machines)]);

export function clearShop(): void {
  loaded.value = false;
  loadError.value = null;
  connection.value = { phase: 'connecting' };
  machines.value = new Map();
  jobs.value = new Map();
  olderJobs.value = null;
  programs.value = new Map();
  releases.value = [];
  alarms.value = new Map();
}

export const textOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));
