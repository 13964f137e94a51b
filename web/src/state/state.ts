// All that the page knows, as one value. It changes by reduce() only.
import type { Alarm, Job, MachineItem, Release, Session } from '../api/types';

// 'lost': what is shown was true at `heardAt` and may be false now.
export type Connection = { phase: 'connecting' } | { phase: 'live' } | { phase: 'lost'; since: number };

export interface BlockText {
  line: number;
  text: string;
}

export interface MachineEntry {
  item: MachineItem;
  reports: number; // progress reports taken so far: tells an older answer from a newer one
  block: BlockText | null; // the newest that is known; the figures may be a second ahead of it
}

export interface AlarmEntry extends Alarm {
  key: number;
  at: number;
}

export interface State {
  session: 'unknown' | 'none' | Session;
  signedOutBecause: string | null;
  connection: Connection;
  loaded: boolean;
  loadError: string | null;
  machines: ReadonlyMap<string, MachineEntry>;
  jobs: ReadonlyMap<number, Job>;
  olderJobs: string | null; // where the next page of jobs begins
  programs: ReadonlyMap<number, string>; // names
  releases: readonly Release[];
  alarms: readonly AlarmEntry[];
}

export const kStart: State = {
  session: 'unknown',
  signedOutBecause: null,
  connection: { phase: 'connecting' },
  loaded: false,
  loadError: null,
  machines: new Map(),
  jobs: new Map(),
  olderJobs: null,
  programs: new Map(),
  releases: [],
  alarms: [],
};
