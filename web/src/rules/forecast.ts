// How long a transfer still takes, and how much of it lies in the control's buffer. The checks predicted when each line
// begins; what is seen of the feed corrects that: how much longer, or shorter, the lines took that went out. What the
// control executes is not seen, only what left and what its buffer holds at most, so the answer is a range. Without a
// prediction the rate of bytes is what is left. A feed that a person stopped has no forecast.
import type { Job, JobForecast, MachineStatus } from '../api/types';
import { stallKind } from './lines';

// By what it is known: `pace`: the prediction, corrected by what is seen; `checked`: the prediction alone; `bytes`: the
// rate of bytes so far.
export interface TimeLeft {
  low_ms: number;
  high_ms: number;
  by: 'pace' | 'checked' | 'bytes';
}

export interface Range {
  low: number;
  high: number;
}

const kEnoughShare = 0.02;
const kEnoughMs = 5_000;

// What was seen of a feed while this page looked: it begins again when a person stops it.
export interface Pace {
  job: number;
  from_ms: number;
  from_s: number; // of the predicted course
}
const kWatched_ms = 30_000;
const kBelievable = 3; // a whole run that took so many times as long did not machine all the time

const isFed = (status: MachineStatus, job: Job | null): job is Job =>
  job !== null && status.job === job.id && status.total > 0 && (status.line === 'feeding' || status.line === 'held') && stallKind(status.stall) !== 'person';

// When a line begins by the prediction, in seconds; null where nothing is known of it. `lines`: of the text; null: not
// known.
export function predictedS({ course, cycle_s }: JobForecast, line: number, lines: number | null): number | null {
  const last = course.at(-1);
  if (cycle_s === null || !last || line <= 0) return null;
  const all: [number, number][] = [...(course as [number, number][]), [Math.max(lines ?? 0, last[0]! + 1), cycle_s]];
  let low = 0;
  let high = all.length - 1;
  if (line <= all[0]![0]) return all[0]![1];
  if (line >= all[high]![0]) return cycle_s;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (all[middle]![0] <= line) low = middle;
    else high = middle;
  }
  const [from, from_s] = all[low]!;
  const [to, to_s] = all[high]!;
  return from_s + ((to_s - from_s) * (line - from)) / (to - from);
}

// Blocks that lie in the control, from `low` to `high`; null where not even the most is known. Where its PLC reports the
// block that is executed, what is sent beyond it; else from none to what the buffer holds.
export function bufferedBlocks(status: MachineStatus, forecast: JobForecast | null, lines: number | null): Range | null {
  const { block, block_from, plc } = status;
  if (block <= 0) return null;
  if (plc && plc.line > 0) return { low: Math.max(0, block_from - plc.line), high: Math.max(0, block - plc.line) };
  const holds = blocksHeld(status, forecast, lines);
  return holds === null ? null : { low: 0, high: Math.min(block, holds) };
}

// How many blocks the control's buffer holds, by its blocks or by bytes of average blocks; null: the profile has none.
function blocksHeld({ total }: MachineStatus, forecast: JobForecast | null, lines: number | null): number | null {
  if (!forecast) return null;
  const byBytes = forecast.buffer_bytes !== null && lines !== null && total > 0 ? Math.ceil((forecast.buffer_bytes * lines) / total) : null;
  if (forecast.buffer_blocks === null) return byBytes;
  return byBytes === null ? forecast.buffer_blocks : Math.min(byBytes, forecast.buffer_blocks);
}

// The pace that goes on, or a new one; null where nothing is fed.
export function paceOf(before: Pace | null, status: MachineStatus, job: Job | null, sent_s: number | null, nowMs: number): Pace | null {
  if (!isFed(status, job) || sent_s === null) return null;
  return before && before.job === job.id && before.from_s <= sent_s ? before : { job: job.id, from_ms: nowMs, from_s: sent_s };
}

export interface Seen {
  status: MachineStatus;
  job: Job | null;
  forecast: JobForecast | null;
  lines: number | null;
  pace: Pace | null;
  nowMs: number;
}

// Null where nothing can be said.
export function timeLeft(seen: Seen): TimeLeft | null {
  const { status, job, forecast, lines } = seen;
  if (!isFed(status, job)) return null;
  const sent_s = forecast && predictedS(forecast, status.block, lines);
  if (!forecast || forecast.cycle_s === null || sent_s === null) return byBytes(status, job, seen.nowMs);
  // What was executed lies between the buffer's most and nothing after what was sent.
  const buffered = bufferedBlocks(status, forecast, lines) ?? { low: 0, high: 0 };
  const done: Range = {
    low: predictedS(forecast, Math.max(1, status.block - buffered.high), lines) ?? 0,
    high: predictedS(forecast, Math.max(1, status.block_from - buffered.low), lines) ?? sent_s,
  };
  if (done.low > done.high) done.low = done.high;
  const { ratio, by } = ratioOf(seen, sent_s, done, job);
  return { low_ms: Math.max(0, forecast.cycle_s - done.high) * ratio.low * 1000, high_ms: Math.max(0, forecast.cycle_s - done.low) * ratio.high * 1000, by };
}

// Machine time that was seen, for a second of the prediction.
function ratioOf({ pace, nowMs }: Seen, sent_s: number, done: Range, job: Job): { ratio: Range; by: TimeLeft['by'] } {
  // What goes out in a long look is what was executed in it, but for what the buffer took or gave.
  if (pace && nowMs - pace.from_ms >= kWatched_ms && sent_s > pace.from_s) {
    const watched_s = (nowMs - pace.from_ms) / 1000;
    const passed_s = sent_s - pace.from_s;
    const slack_s = Math.min(sent_s - done.low, 0.5 * passed_s);
    return { ratio: { low: watched_s / (passed_s + slack_s), high: watched_s / (passed_s - slack_s) }, by: 'pace' };
  }
  const took_s = (nowMs - (job.started_at_ms ?? nowMs)) / 1000;
  const isEnough = took_s * 1000 >= kWatched_ms && done.low > 0 && took_s < kBelievable * sent_s;
  return isEnough ? { ratio: { low: took_s / done.high, high: took_s / done.low }, by: 'pace' } : { ratio: { low: 1, high: 1 }, by: 'checked' };
}

function byBytes(status: MachineStatus, job: Job, nowMs: number): TimeLeft | null {
  if (job.started_at_ms === null) return null;
  const seen = status.clocked / status.total;
  const took = nowMs - job.started_at_ms;
  if (seen < kEnoughShare || took < kEnoughMs) return null;
  const left = (took * (1 - seen)) / seen;
  return { low_ms: left, high_ms: left, by: 'bytes' };
}
