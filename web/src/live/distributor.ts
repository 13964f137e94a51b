// Gathers what the stream says for one reader: the newest progress of each machine, and everything else in its order. A
// reader that is looked at hears five times a second, a hidden one every two seconds; news other than progress comes at
// once.
import type { ServerEvent } from './event_stream';

export interface Heard {
  news: { name: string; data: unknown }[]; // in order, all but progress
  progress: Record<string, unknown>[]; // at most one a machine
}

const kVisibleMs = 100;
const kHiddenMs = 2_000;

export class Distributor {
  private news: Heard['news'] = [];
  private readonly progress = new Map<string, Record<string, unknown>>();
  private timer: ReturnType<typeof setTimeout> | undefined;
  private visible = true;

  constructor(private readonly give: (heard: Heard) => void) {}

  take(event: ServerEvent): void {
    this.takeRead(event.name, read(event.data));
  }

  // `data` as JSON gave it; null where it was none, and then only the name counts.
  takeRead(name: string, data: Record<string, unknown> | null): void {
    if (name === 'progress') {
      if (typeof data?.machine !== 'string') return;
      this.progress.set(data.machine, data);
      this.timer ??= setTimeout(() => this.flush(), this.visible ? kVisibleMs : kHiddenMs);
      return;
    }
    this.news.push({ name, data });
    this.flush();
  }

  setVisible(visible: boolean): void {
    if (visible && !this.visible) this.flush();
    this.visible = visible;
  }

  stop(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
  }

  private flush(): void {
    this.stop();
    if (this.news.length === 0 && this.progress.size === 0) return;
    const heard = { news: this.news, progress: [...this.progress.values()] };
    this.news = [];
    this.progress.clear();
    this.give(heard);
  }
}

export function read(text: string): Record<string, unknown> | null {
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === 'object' && value !== null ? (value as Record<string, unknown>) : null;
  } catch {
    return null;
  }
}
