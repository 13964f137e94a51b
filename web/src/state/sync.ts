// Keeps the state like the server's: loads everything when the live stream opens, applies the events that came
// meanwhile on top, and asks anew for what no event carries. After each loss it loads everything again, because a
// server that was restarted counts its events from the beginning.
import { calls } from '../api/calls';
import { ApiError } from '../api/client';
import type { ServerEvent } from '../live/event_stream';
import { LiveConnection, type LiveListener } from '../live/connection';
import { meaningOf } from './event_actions';
import type { Store } from './store';

const kBlockEveryMs = 1_000; // the text of the block is no part of the live progress

export class Sync implements LiveListener {
  private live: LiveConnection | null = null;
  private round = 0; // of loading; what belongs to an older one is dropped
  private waiting: ServerEvent[] | null = null; // events that came while loading
  private readonly refreshing = new Set<string>();
  private readonly dirty = new Set<string>();
  private readonly blockAt = new Map<string, number>();
  private readonly blockDue = new Map<string, ReturnType<typeof setTimeout>>();
  private readonly askedPrograms = new Set<number>();
  private readonly askedJobs = new Set<number>();

  constructor(private readonly store: Store) {}

  // At the start of the page: is there a session already?
  async begin(): Promise<void> {
    try {
      this.store.dispatch({ type: 'signed_in', session: await calls.session() });
      this.open();
    } catch (error) {
      const noSession = error instanceof ApiError && error.status === 401;
      this.store.dispatch({ type: 'signed_out', because: noSession ? null : textOf(error) });
    }
  }

  async signIn(token: string): Promise<void> {
    await calls.signIn(token);
    this.store.dispatch({ type: 'signed_in', session: await calls.session() });
    this.open();
  }

  // An order of a person. An answer that the session is over ends it here too.
  async order<T>(call: Promise<T>): Promise<T> {
    try {
      return await call;
    } catch (error) {
      if (error instanceof ApiError && error.status === 401) this.refused();
      throw error;
    }
  }

  async signOut(): Promise<void> {
    await calls.signOut();
    this.end(null);
  }

  private open(): void {
    this.live?.stop();
    this.live = new LiveConnection('/api/v1/events', this);
    this.live.start();
  }

  private end(because: string | null): void {
    this.round += 1;
    this.live?.stop();
    this.live = null;
    this.store.dispatch({ type: 'signed_out', because });
  }

  // --- the live stream
  opened(): void {
    void this.load();
  }

  lost(heardAtMs: number): void {
    this.round += 1;
    this.waiting = null;
    this.store.dispatch({ type: 'lost', at: heardAtMs });
  }

  refused(): void {
    this.end('The session is over. Sign in again.');
  }

  event(event: ServerEvent): void {
    if (this.waiting) this.waiting.push(event);
    else this.apply(event);
  }

  private apply(event: ServerEvent): void {
    const meaning = meaningOf(event, Date.now());
    if (meaning.reload) void this.load();
    if (meaning.action) this.store.dispatch(meaning.action);
    if (meaning.refreshMachine !== null) void this.refreshMachine(meaning.refreshMachine);
    if (meaning.action?.type === 'progress') this.followBlock(meaning.action.progress.machine);
    if (meaning.action?.type === 'job') this.completeNames();
  }

  // --- loading
  private async load(): Promise<void> {
    const round = ++this.round;
    this.waiting ??= [];
    try {
      const [machines, newest, queued, programs, releases] = await Promise.all([
        calls.machines(),
        calls.jobs({ limit: 50 }),
        calls.jobs({ state: 'queued', limit: 200 }),
        calls.programs(),
        calls.releases(),
      ]);
      if (round !== this.round) return;
      const jobs = [...queued.items, ...newest.items];
      this.askedJobs.clear();
      this.askedPrograms.clear();
      this.store.dispatch({ type: 'loaded', machines, jobs, olderJobs: newest.next, programs, releases });
      this.store.dispatch({ type: 'live' });
      const waiting = this.waiting;
      this.waiting = null;
      for (const event of waiting ?? []) this.event(event);
      this.completeNames();
    } catch (error) {
      if (round !== this.round) return;
      if (error instanceof ApiError && error.status === 401) return this.refused();
      this.store.dispatch({ type: 'load_failed', text: textOf(error) });
      this.live?.breakOff();
    }
  }

  async loadOlderJobs(): Promise<void> {
    const after = this.store.get().olderJobs;
    if (after === null) return;
    const page = await calls.jobs({ after });
    this.store.dispatch({ type: 'older_jobs', jobs: page.items, olderJobs: page.next });
    this.completeNames();
  }

  async loadReleases(): Promise<void> {
    this.store.dispatch({ type: 'releases', releases: await calls.releases() });
    this.completeNames();
  }

  async loadJob(id: number): Promise<void> {
    this.store.dispatch({ type: 'job', job: await calls.job(id) });
    this.completeNames();
  }

  // At most one request a machine at a time; one more when something happened meanwhile.
  private async refreshMachine(name: string): Promise<void> {
    if (this.refreshing.has(name)) {
      this.dirty.add(name);
      return;
    }
    this.refreshing.add(name);
    const round = this.round;
    do {
      this.dirty.delete(name);
      this.blockAt.set(name, Date.now());
      const reportsBefore = this.store.get().machines.get(name)?.reports ?? 0;
      try {
        const item = await calls.machine(name);
        if (round === this.round) this.store.dispatch({ type: 'machine', item, reportsBefore });
      } catch {
        // A machine that cannot be read must not look alive: load everything, or find that the server is gone.
        if (round === this.round) this.live?.breakOff();
      }
    } while (round === this.round && this.dirty.has(name));
    this.refreshing.delete(name);
    this.completeNames();
  }

  // At most once a second, and once more after the last report.
  private followBlock(name: string): void {
    const status = this.store.get().machines.get(name)?.item.status;
    if (document.hidden || !status?.job || status.handed === 0 || this.blockDue.has(name)) return;
    const wait = Math.max(0, (this.blockAt.get(name) ?? 0) + kBlockEveryMs - Date.now());
    const due = setTimeout(() => {
      this.blockDue.delete(name);
      if (this.live) void this.refreshMachine(name);
    }, wait);
    this.blockDue.set(name, due);
  }

  // Jobs on a line and programs of jobs and releases that no list had.
  private completeNames(): void {
    const state = this.store.get();
    for (const { item } of state.machines.values()) {
      const id = item.status.job;
      if (id === null || state.jobs.has(id) || this.askedJobs.has(id)) continue;
      this.askedJobs.add(id);
      void this.loadJob(id).catch(() => undefined); // shown by its number then
    }
    const wanted = [...state.jobs.values(), ...state.releases].map((one) => one.program);
    for (const id of new Set(wanted)) {
      if (state.programs.has(id) || this.askedPrograms.has(id)) continue;
      this.askedPrograms.add(id);
      const found = calls.program(id).then((program) => this.store.dispatch({ type: 'programs', programs: [program] }));
      void found.catch(() => undefined);
    }
  }
}

export const textOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));
