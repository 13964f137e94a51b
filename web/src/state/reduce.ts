// How the state changes. Pure: the same state and action give the same state.
import type { Alarm, Job, MachineItem, Program, Progress, Release, Session } from '../api/types';
import { kStart, type BlockText, type MachineEntry, type State } from './state';

export type Action =
  | { type: 'signed_in'; session: Session }
  | { type: 'signed_out'; because: string | null }
  | { type: 'loaded'; machines: MachineItem[]; jobs: Job[]; olderJobs: string | null; programs: Program[]; releases: Release[] }
  | { type: 'load_failed'; text: string }
  | { type: 'live' }
  | { type: 'lost'; at: number }
  | { type: 'machine'; item: MachineItem; reportsBefore: number }
  | { type: 'progress'; progress: Progress }
  | { type: 'job'; job: Job }
  | { type: 'older_jobs'; jobs: Job[]; olderJobs: string | null }
  | { type: 'programs'; programs: Program[] }
  | { type: 'releases'; releases: Release[] }
  | { type: 'alarm'; alarm: Alarm; at: number }
  | { type: 'alarm_seen'; key: number };

const kMostAlarms = 20;

export function reduce(state: State, action: Action): State {
  switch (action.type) {
    case 'signed_in':
      return { ...kStart, session: action.session };
    case 'signed_out':
      return { ...kStart, session: 'none', signedOutBecause: action.because };
    case 'loaded':
      return loaded(state, action);
    case 'load_failed':
      return { ...state, loadError: action.text };
    case 'live':
      return { ...state, connection: { phase: 'live' }, loadError: null };
    case 'lost':
      if (state.connection.phase === 'lost') return state;
      return { ...state, connection: { phase: 'lost', since: action.at } };
    case 'machine':
      return machine(state, action.item, action.reportsBefore);
    case 'progress':
      return progress(state, action.progress);
    case 'job':
      return { ...state, jobs: new Map(state.jobs).set(action.job.id, action.job) };
    case 'older_jobs':
      return { ...state, jobs: withJobs(state.jobs, action.jobs), olderJobs: action.olderJobs };
    case 'programs':
      return { ...state, programs: withPrograms(state.programs, action.programs) };
    case 'releases':
      return { ...state, releases: action.releases };
    case 'alarm': {
      const key = (state.alarms[0]?.key ?? 0) + 1;
      return { ...state, alarms: [{ ...action.alarm, key, at: action.at }, ...state.alarms].slice(0, kMostAlarms) };
    }
    case 'alarm_seen':
      return { ...state, alarms: state.alarms.filter((alarm) => alarm.key !== action.key) };
  }
}

function loaded(state: State, action: Extract<Action, { type: 'loaded' }>): State {
  const machines = new Map<string, MachineEntry>();
  for (const item of action.machines) machines.set(item.name, { item, reports: 0, block: blockOf(item) });
  return {
    ...state,
    loaded: true,
    loadError: null,
    machines,
    jobs: withJobs(new Map(), action.jobs),
    olderJobs: action.olderJobs,
    programs: withPrograms(new Map(), action.programs),
    releases: action.releases,
  };
}

const blockOf = ({ status }: MachineItem): BlockText | null =>
  status.block_text === '' ? null : { line: status.block, text: status.block_text };

// An answer that was asked for before the newest report keeps that report's figures; what no report carries (program,
// block, torn block) is the answer's.
function machine(state: State, item: MachineItem, reportsBefore: number): State {
  const known = state.machines.get(item.name);
  const entry: MachineEntry = { item, reports: known?.reports ?? 0, block: blockOf(item) };
  if (known && known.reports > reportsBefore) {
    const { program, block_text, needs_confirmation, job } = item.status;
    const newest = known.item.status;
    const sameJob = job === newest.job;
    const own = sameJob ? { program, block_text } : {};
    entry.item = { ...item, status: { ...newest, ...own, needs_confirmation } };
    if (!sameJob) entry.block = null;
  }
  return { ...state, machines: new Map(state.machines).set(item.name, entry) };
}

function progress(state: State, given: Progress): State {
  const known = state.machines.get(given.machine);
  if (!known) return state;
  const { machine: name, ...report } = given;
  const { job, program, block_text, needs_confirmation } = known.item.status;
  const own = job === report.job ? { program, block_text } : { program: '', block_text: '' };
  const entry: MachineEntry = {
    item: { ...known.item, status: { ...report, ...own, needs_confirmation } },
    reports: known.reports + 1,
    block: job === report.job ? known.block : null,
  };
  return { ...state, machines: new Map(state.machines).set(name, entry) };
}

function withJobs(known: ReadonlyMap<number, Job>, jobs: Job[]): Map<number, Job> {
  const all = new Map(known);
  for (const job of jobs) all.set(job.id, job);
  return all;
}

function withPrograms(known: ReadonlyMap<number, string>, programs: Program[]): Map<number, string> {
  const all = new Map(known);
  for (const program of programs) all.set(program.id, program.name);
  return all;
}
