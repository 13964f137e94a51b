// The one open stream of live events: it connects, hears, notices silence, and connects again with the last id. It is
// read by fetch and not by EventSource, because EventSource hides the server's comments: with them, a connection that
// died without a word is noticed in seconds, and what is on the screen is never taken for live. It runs in a page or in
// a shared worker.
import { EventParser, type ServerEvent } from './event_stream';

const kSilenceMs = 25_000; // the server says something at least every 15 s
const kFirstWaitMs = 500;
const kLongestWaitMs = 5_000;

export interface StreamListener {
  opened(): void;
  event(event: ServerEvent): void;
  lost(heardAtMs: number): void; // after opened, or instead of it; 0: never heard
  refused(): void; // the session is no longer valid
}

export class LiveConnection {
  private abort: AbortController | null = null;
  private lastId = '';
  private wait = kFirstWaitMs;
  private retry: ReturnType<typeof setTimeout> | undefined;
  private silence: ReturnType<typeof setTimeout> | undefined;
  private heardAt = 0;

  constructor(
    private readonly url: string,
    private readonly listener: StreamListener,
  ) {}

  start(): void {
    addEventListener('offline', this.breakOff);
    addEventListener('online', this.hurry);
    this.lastId = '';
    this.wait = kFirstWaitMs;
    void this.connect();
  }

  stop(): void {
    removeEventListener('offline', this.breakOff);
    removeEventListener('online', this.hurry);
    clearTimeout(this.retry);
    this.close();
  }

  // Ends this stream as if it had been lost; a new one follows.
  readonly breakOff = (): void => {
    if (!this.abort) return;
    this.close();
    this.again();
  };

  // The next stream begins at once and knows nothing of this one.
  reopen(): void {
    this.stop();
    this.start();
  }

  private readonly hurry = (): void => {
    if (this.abort) return;
    clearTimeout(this.retry);
    void this.connect();
  };

  // A page that slept may have a dead stream and a timer that did not run.
  look(): void {
    if (!this.abort) return;
    if (Date.now() - this.heardAt > kSilenceMs) this.breakOff();
  }

  private close(): void {
    clearTimeout(this.silence);
    this.abort?.abort();
    this.abort = null;
  }

  private again(): void {
    this.listener.lost(this.heardAt);
    clearTimeout(this.retry);
    this.retry = setTimeout(() => void this.connect(), this.wait);
    this.wait = Math.min(this.wait * 2, kLongestWaitMs);
  }

  private watch(): void {
    clearTimeout(this.silence);
    this.silence = setTimeout(this.breakOff, kSilenceMs);
  }

  private async connect(): Promise<void> {
    const abort = new AbortController();
    this.abort = abort;
    this.watch();
    try {
      const response = await fetch(this.url, { headers: this.headers(), signal: abort.signal, cache: 'no-store' });
      if (response.status === 401) {
        this.stop();
        this.listener.refused();
        return;
      }
      if (response.status === 422) this.lastId = '';
      if (!response.ok || !response.body) throw new Error(`status ${response.status}`);
      this.wait = kFirstWaitMs;
      this.heardAt = Date.now();
      this.listener.opened();
      await this.read(response.body, abort);
    } catch {
      // Every failure means the same here: the stream is lost.
    }
    if (this.abort !== abort) return; // closed by us meanwhile
    this.close();
    this.again();
  }

  private headers(): Record<string, string> {
    const headers: Record<string, string> = { Accept: 'text/event-stream' };
    if (this.lastId !== '') headers['Last-Event-ID'] = this.lastId;
    return headers;
  }

  private async read(body: ReadableStream<Uint8Array>, abort: AbortController): Promise<void> {
    const parser = new EventParser();
    parser.lastId = this.lastId;
    const decoder = new TextDecoder();
    const reader = body.getReader();
    for (;;) {
      const { value, done } = await reader.read();
      if (done || this.abort !== abort) return;
      this.heardAt = Date.now();
      this.watch();
      for (const event of parser.push(decoder.decode(value, { stream: true }))) {
        this.listener.event(event);
        if (this.abort !== abort) return;
      }
      this.lastId = parser.lastId;
    }
  }
}
