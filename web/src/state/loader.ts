// Keeps what the page knows like the server's: loads everything when the live stream opens, applies the news that came
// meanwhile on top, and asks again for what no news carries. After each loss it loads everything again, because a server
// that was restarted counts its events from the beginning. News is applied once a frame, whatever came.
import { calls, summaryOf } from '../api/calls';
import { ApiError, setShownUser } from '../api/client';
import type { Alarm, Job, NewSession, Progress, ProviderAnswer, Session } from '../api/types';
import { t } from '../i18n/i18n';
import type { Heard } from '../live/distributor';
import { openLive, type LiveLink, type LiveListener } from '../live/hub';
import { setAlarms, setMachines, takeAlarms, takeJobs, takeMachine, takeProgress, takePrograms, together } from './changes';
import * as shop from './shop';

const kNewestJobs = 50;
const kJobsOnLines = ['queued', 'armed', 'feeding', 'held', 'draining'];
const kRetryMs = 3_000;
const kAskAll = 10; // names that are missing: from here on the list is asked for

export class Loader implements LiveListener {
  private live: LiveLink | null = null;
  private round = 0; // of loading; what belongs to an older one is dropped
  private loading = false;
  private isOpen = false; // the stream: without it nothing that is loaded is live
  private heards: Heard[] = []; // not applied yet
  private frame = 0;
  private retry: ReturnType<typeof setTimeout> | undefined;
  private readonly refreshing = new Set<string>();
  private readonly dirty = new Set<string>();
  private readonly asked = new Set<string>();
  private readonly tabs = new BroadcastChannel('dripfeed session');

  constructor() {
    // Another tab signed in or out: the cookie is one for all tabs.
    this.tabs.onmessage = () => void this.begin();
  }

  // At the start of the page, or when another tab changed the session: is there one?
  async begin(): Promise<void> {
    try {
      this.enter(await calls.session());
    } catch (error) {
      const noSession = error instanceof ApiError && error.status === 401;
      this.end(noSession ? null : shop.textOf(error));
    }
  }

  async signIn(who: NewSession): Promise<void> {
    await this.signInBy(calls.signIn(who));
  }

  async signInByProvider(answer: ProviderAnswer): Promise<void> {
    await this.signInBy(calls.signInByProvider(answer));
  }

  private async signInBy(opened: Promise<null>): Promise<void> {
    await opened;
    this.enter(await calls.session());
    this.tabs.postMessage('in');
  }

  async signOut(): Promise<void> {
    await calls.signOut();
    this.end(null);
    this.tabs.postMessage('out');
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

  private enter(found: Session): void {
    const before = shop.session.peek();
    setShownUser(found.name);
    shop.session.value = found;
    if (this.live) {
      if (typeof before === 'object' && before.name !== found.name) this.live.reopen();
      return;
    }
    this.live = openLive(this);
    void this.load(); // what can be shown before the stream is open
  }

  private end(because: string | null): void {
    this.round += 1;
    clearTimeout(this.retry);
    this.live?.stop();
    this.live = null;
    this.isOpen = false;
    this.heards = [];
    setShownUser('');
    together(() => {
      shop.clearShop();
      shop.signedOutBecause.value = because;
      shop.session.value = 'none';
    });
  }

  // --- the live stream
  opened(): void {
    this.isOpen = true;
    void this.load();
  }

  lost(heardAtMs: number): void {
    this.round += 1;
    this.isOpen = false;
    this.loading = false;
    this.heards = [];
    if (shop.connection.peek().phase !== 'lost') shop.connection.value = { phase: 'lost', heardAt: heardAtMs };
  }

  refused(): void {
    this.end(t('session.over'));
  }

  heard(heard: Heard): void {
    this.heards.push(heard);
    if (!this.loading) this.soon();
  }

  // A hidden page has no frames, and what it hears is seldom.
  private soon(): void {
    if (document.hidden) return this.applyAll();
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.applyAll());
  }

  private applyAll(): void {
    this.frame = 0;
    const heards = this.heards;
    this.heards = [];
    together(() => {
      for (const heard of heards) this.apply(heard);
    });
  }

  private apply({ news, progress }: Heard): void {
    for (const report of progress) takeProgress(report as unknown as Progress);
    for (const { name, data } of news) this.applyNews(name, data as Record<string, unknown> | null);
  }

  // News that this page does not know, or cannot read, changes nothing.
  private applyNews(name: string, data: Record<string, unknown> | null): void {
    if (name === 'reset') void this.load();
    if (!data) return;
    if (name === 'job' && typeof data.id === 'number') {
      const job = data as unknown as Job;
      takeJobs([job]);
      void this.refreshMachine(job.machine);
      this.completeNames();
    }
    if (name === 'machine' && typeof data.name === 'string') void this.refreshMachine(data.name);
    if (name === 'alarm' && typeof data.id === 'number') takeAlarms([data as unknown as Alarm]);
    if (name === 'receipt') shop.receiptNews.value += 1;
  }

  // --- loading
  async load(): Promise<void> {
    const round = ++this.round;
    this.loading = true;
    this.heards = [];
    clearTimeout(this.retry);
    try {
      const [machines, newest, onLines, alarms] = await Promise.all([
        calls.machines(),
        calls.jobs({ limit: kNewestJobs }),
        Promise.all(kJobsOnLines.map((state) => calls.jobsIn(state))),
        calls.openAlarms(),
      ]);
      if (round !== this.round) return;
      this.asked.clear();
      together(() => {
        setMachines(machines);
        shop.jobs.value = new Map();
        takeJobs([...onLines.flat(), ...newest.items]);
        shop.olderJobs.value = newest.next;
        setAlarms(alarms);
        shop.loaded.value = true;
        shop.loadError.value = null;
        if (this.isOpen) shop.connection.value = { phase: 'live' };
      });
      this.loading = false;
      this.applyAll();
      this.completeNames();
    } catch (error) {
      if (round !== this.round) return;
      if (error instanceof ApiError && error.status === 401) return this.refused();
      shop.loadError.value = shop.textOf(error);
      this.retry = setTimeout(() => void this.load(), kRetryMs);
    }
  }

  async loadOlderJobs(): Promise<void> {
    const after = shop.olderJobs.peek();
    if (after === null) return;
    const page = await calls.jobs({ after });
    takeJobs(page.items);
    shop.olderJobs.value = page.next;
    this.completeNames();
  }

  async loadReleases(): Promise<void> {
    shop.releases.value = await calls.releases();
    this.completeNames();
  }

  async loadJob(id: number): Promise<void> {
    takeJobs([await calls.job(id)]);
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
      const reportsBefore = shop.machines.peek().get(name)?.reports ?? 0;
      try {
        const item = summaryOf(await calls.machine(name));
        // What was heard before the answer and waits for a frame is older than the answer: it must not follow it.
        if (!this.loading) this.applyAll();
        if (round === this.round) takeMachine(item, reportsBefore);
      } catch (error) {
        if (round === this.round) this.unreadable(error);
      }
    } while (round === this.round && this.dirty.has(name));
    this.refreshing.delete(name);
  }

  // A machine that cannot be read must not look alive: load everything, or find that the server is gone.
  private unreadable(error: unknown): void {
    const gone = error instanceof ApiError && error.status === 404;
    if (gone) void this.load();
    else this.live?.breakOff();
  }

  // Jobs on a line and programs of jobs and releases that no list had, each asked for once.
  completeNames(): void {
    for (const machine of shop.machines.peek().values()) {
      const id = machine.status.peek().job;
      if (id !== null && !shop.jobs.peek().has(id)) this.once(`job ${id}`, () => this.loadJob(id));
    }
    const known = shop.programs.peek();
    const wanted = [...shop.jobs.peek().values(), ...shop.releases.peek()].map((one) => one.program);
    const missing = [...new Set(wanted)].filter((id) => !known.has(id));
    if (missing.length > kAskAll) return this.once('programs', async () => takePrograms(await calls.programs()));
    for (const id of missing) this.once(`program ${id}`, async () => takePrograms([await calls.program(id)]));
  }

  // What cannot be had is shown by its number.
  private once(what: string, ask: () => Promise<void>): void {
    if (this.asked.has(what)) return;
    this.asked.add(what);
    void ask().catch(() => undefined);
  }
}

export const loader = new Loader();
