// The shared worker: one stream, and every tab of this browser hears it. A tab that closes without a word is forgotten
// when it was silent for longer than a browser lets a hidden page's timer sleep.
import { LiveConnection } from './connection';
import { Distributor, read } from './distributor';
import type { FromTab, ToTab } from './hub';

const kForgottenMs = 150_000;

class Tab {
  heardAt = Date.now();
  private readonly distributor: Distributor;

  constructor(readonly port: MessagePort) {
    this.distributor = new Distributor((heard) => this.send({ say: 'heard', heard }));
  }

  send(message: ToTab): void {
    this.port.postMessage(message);
  }

  take(name: string, data: Record<string, unknown> | null): void {
    this.distributor.takeRead(name, data);
  }

  setVisible(visible: boolean): void {
    this.distributor.setVisible(visible);
  }

  close(): void {
    this.distributor.stop();
  }
}

const tabs = new Map<MessagePort, Tab>();
let phase: 'shut' | 'connecting' | 'open' | 'lost' = 'shut';
let lostAt = 0;

const sendAll = (message: ToTab) => {
  for (const tab of tabs.values()) tab.send(message);
};

const connection = new LiveConnection('/api/v1/events', {
  opened: () => {
    phase = 'open';
    sendAll({ say: 'opened' });
  },
  event: (event) => {
    const data = read(event.data);
    for (const tab of tabs.values()) tab.take(event.name, data);
  },
  lost: (heardAt) => {
    phase = 'lost';
    lostAt = heardAt;
    sendAll({ say: 'lost', heardAt });
  },
  refused: () => {
    phase = 'shut';
    sendAll({ say: 'refused' });
  },
});

function forgetSilent(): void {
  for (const [port, tab] of tabs) {
    if (Date.now() - tab.heardAt > kForgottenMs) leave(port);
  }
}

function leave(port: MessagePort): void {
  tabs.get(port)?.close();
  tabs.delete(port);
  if (tabs.size > 0 || phase === 'shut') return;
  phase = 'shut';
  connection.stop();
}

function join(port: MessagePort): void {
  const tab = tabs.get(port) ?? new Tab(port);
  tabs.set(port, tab);
  if (phase === 'open') return tab.send({ say: 'opened' });
  if (phase === 'lost') tab.send({ say: 'lost', heardAt: lostAt });
  if (phase !== 'shut') return;
  phase = 'connecting';
  connection.start();
}

function take(port: MessagePort, { say }: FromTab): void {
  if (say === 'hello') join(port);
  if (say === 'bye') return leave(port);
  const tab = tabs.get(port);
  if (!tab) return join(port); // it was forgotten, and is there
  tab.heardAt = Date.now();
  if (say === 'visible' || say === 'hidden') tab.setVisible(say === 'visible');
  if (say === 'visible') connection.look();
  if (say === 'break_off') connection.breakOff();
  if (say === 'reopen') connection.reopen();
}

(globalThis as unknown as { onconnect: (event: MessageEvent) => void }).onconnect = (event) => {
  const port = event.ports[0];
  if (!port) return;
  port.onmessage = ({ data }: MessageEvent<FromTab>) => {
    forgetSilent();
    take(port, data);
  };
};
