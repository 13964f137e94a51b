// The page's side of the live stream. One stream serves all tabs of a browser: a shared worker holds it, because a
// browser opens six connections to a server and no more. Where there is no shared worker, a tab has its own.
import { LiveConnection } from './connection';
import { Distributor, type Heard } from './distributor';

export interface LiveListener {
  opened(): void; // the stream is up: all must be loaded, and what follows is newer
  heard(heard: Heard): void;
  lost(heardAtMs: number): void; // 0: never heard
  refused(): void; // the session is no longer valid
}

// What a tab and the worker say to each other.
export type FromTab = { say: 'hello' | 'visible' | 'hidden' | 'still_here' | 'break_off' | 'reopen' | 'bye' };
export type ToTab =
  | { say: 'opened' }
  | { say: 'heard'; heard: Heard }
  | { say: 'lost'; heardAt: number }
  | { say: 'refused' };

const kUrl = '/api/v1/events';
const kStillHereMs = 20_000;

export interface LiveLink {
  breakOff(): void; // the stream ends and is opened again
  reopen(): void; // as another person: the session has changed
  stop(): void;
}

export function openLive(listener: LiveListener): LiveLink {
  return typeof SharedWorker === 'undefined' ? ownStream(listener) : sharedStream(listener);
}

function sharedStream(listener: LiveListener): LiveLink {
  const worker = new SharedWorker(workerUrl(), { name: 'dripfeed live', type: 'module' });
  const { port } = worker;
  const say = (word: FromTab['say']) => port.postMessage({ say: word } satisfies FromTab);
  port.onmessage = ({ data }: MessageEvent<ToTab>) => {
    if (data.say === 'opened') listener.opened();
    else if (data.say === 'heard') listener.heard(data.heard);
    else if (data.say === 'lost') listener.lost(data.heardAt);
    else listener.refused();
  };
  const look = () => say(document.hidden ? 'hidden' : 'visible');
  const bye = () => say('bye');
  // A page that comes back from the browser's cache asks again.
  const again = (event: PageTransitionEvent) => event.persisted && say('hello');
  document.addEventListener('visibilitychange', look);
  addEventListener('pagehide', bye);
  addEventListener('pageshow', again);
  const timer = setInterval(() => say('still_here'), kStillHereMs);
  say('hello');
  look();
  return {
    breakOff: () => say('break_off'),
    reopen: () => say('reopen'),
    stop: () => {
      clearInterval(timer);
      document.removeEventListener('visibilitychange', look);
      removeEventListener('pagehide', bye);
      removeEventListener('pageshow', again);
      say('bye');
      port.close();
    },
  };
}

// The worker's file lies beside this script, and its name changes with its content.
const workerUrl = (): string => document.querySelector<HTMLLinkElement>('link[data-live-worker]')?.href ?? '/assets/live.js';

function ownStream(listener: LiveListener): LiveLink {
  const distributor = new Distributor((heard) => listener.heard(heard));
  const connection = new LiveConnection(kUrl, {
    opened: () => listener.opened(),
    event: (event) => distributor.take(event),
    lost: (heardAt) => listener.lost(heardAt),
    refused: () => listener.refused(),
  });
  const look = () => {
    distributor.setVisible(!document.hidden);
    if (!document.hidden) connection.look();
  };
  document.addEventListener('visibilitychange', look);
  look();
  connection.start();
  return {
    breakOff: () => connection.breakOff(),
    reopen: () => connection.reopen(),
    stop: () => {
      document.removeEventListener('visibilitychange', look);
      distributor.stop();
      connection.stop();
    },
  };
}
