// What a card, a tile and the machine's view say of a machine: each as a signal of its own, made once a machine, so that
// a text is rewritten only when it changes.
import { computed, type ReadonlySignal } from '@preact/signals';
import type { Job } from '../../api/types';
import { wholePercent } from '../../format/numbers';
import { aboutRange, countdown } from '../../format/times';
import { localText } from '../../format/local_text';
import { jobReason, reasonText, stallText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { minutes, seconds } from '../../parts/clock';
import { asksForPerson } from '../../rules/alarms';
import { hasJob } from '../../rules/lines';
import { kNeedsPerson, standingOf, type Standing } from '../../rules/standing';
import { timeLeftOf } from '../../state/forecasts';
import { linesOf } from '../../state/program_lines';
import { alarms, endedOf, isLive, jobs, nextOf, programName, queueOf, type Machine } from '../../state/shop';

export interface Words {
  job: ReadonlySignal<Job | null>; // the one on the line, or the last
  onLine: ReadonlySignal<boolean>; // it is on the line now
  standing: ReadonlySignal<Standing>;
  alarms: ReadonlySignal<number>; // that ask for a person
  need: ReadonlySignal<number>; // the urgency, alarms included
  sentence: ReadonlySignal<string>; // what the machine does, in everyday words
  line: ReadonlySignal<string>; // where the feed is in the program's text
  block: ReadonlySignal<string>;
  remark: ReadonlySignal<string>; // the one thing that is worth saying beside the state
  program: ReadonlySignal<string>;
  share: ReadonlySignal<string>;
}

const made = new WeakMap<Machine, Words>();

export function wordsOf(machine: Machine): Words {
  const known = made.get(machine);
  if (known) return known;
  const { core, status } = machine;
  const job = computed(() => (core.value.job === null ? null : (jobs.value.get(core.value.job) ?? null)));
  const onLine = computed(() => hasJob(core.value) && core.value.job !== null);
  const queued = computed(() => queueOf(machine.name));
  const standing = computed(() => standingOf(core.value, job.value, queued.value.filter(mayBeArmed).length, endedOf(machine.name)));
  const count = computed(() => alarmsOf(machine.name));
  const words: Words = {
    job,
    onLine,
    standing,
    alarms: count,
    need: computed(() => (count.value > 0 ? Math.max(standing.value.urgency, kNeedsPerson + 1) : standing.value.urgency)),
    sentence: computed(() => sentence(machine, standing.value, job.value)),
    line: computed(() => (onLine.value ? lineText(status.value.block, job.value) : '')),
    block: computed(() => (onLine.value ? status.value.block_text : '')),
    remark: computed(() => remark(machine, job.value)),
    program: computed(() => status.value.program || (job.value ? (programName(job.value.program) ?? t('program.number', { id: job.value.program })) : '')),
    share: computed(() => wholePercent(status.value.clocked, status.value.total)),
  };
  made.set(machine, words);
  return words;
}

function alarmsOf(machine: string): number {
  let count = 0;
  for (const alarm of alarms.value.values()) if (alarm.machine === machine && asksForPerson(alarm, minutes.value)) ++count;
  return count;
}

const mayBeArmed = ({ on_hold }: Job): boolean => on_hold === null;

// What one standing alone does not state.
const kSentences: Partial<Record<Standing['key'], (machine: Machine, queue: readonly Job[], job: Job | null) => string>> = {
  feeding: (machine, _, job) => feedingText(machine, job),
  armed: (_machine, _queue, job) => armedText(job),
  waiting: (machine) => t('sentence.waiting', { why: stallText(machine.core.value.stall ?? '') }),
  asks: (machine, queue) => t(queue.length > 0 ? 'sentence.asks_queued' : 'sentence.asks', { job: nextOf(machine.name)?.id ?? 0 }),
  end_unconfirmed: ({ name }) => t('sentence.end_unconfirmed', { job: endedOf(name)?.id ?? 0, check: endedOf(name)?.end_check ?? '' }),
  machine_alarm: (machine) => t('sentence.machine_alarm', { alarm: machine.core.value.plc_alarm }),
  queued: (_, queue) => t('sentence.queued', { count: queue.filter(mayBeArmed).length }),
  idle: (_, queue) => t(queue.length > 0 ? 'sentence.on_hold' : 'sentence.idle', { count: queue.length }),
};

const sentence = (machine: Machine, { key }: Standing, job: Job | null): string =>
  kSentences[key]?.(machine, queueOf(machine.name), job) ?? t(`sentence.${key}`);

function feedingText(machine: Machine, job: Job | null): string {
  const status = machine.status.value;
  const sent = t('sentence.sent', { share: wholePercent(status.clocked, status.total) });
  const left = isLive.value ? timeLeftOf(machine.name, status, job, seconds.value) : null;
  if (left === null) return sent;
  return t(left.by === 'checked' ? 'sentence.sent_left_checked' : 'sentence.sent_left', { sent, left: aboutRange(left.low_ms, left.high_ms) });
}

function armedText(job: Job | null): string {
  if (!job || job.expires_at_ms === null) return t('sentence.armed');
  return t('sentence.armed_until', { left: countdown(job.expires_at_ms - seconds.value) });
}

function lineText(block: number, job: Job | null): string {
  if (block <= 0) return '';
  const all = job ? linesOf(job.program, job.revision) : null;
  return all === null ? t('line.at', { line: block }) : t('line.of', { line: block, all });
}

function remark(machine: Machine, job: Job | null): string {
  const { core, status } = machine;
  const { needs_confirmation, link_error, link_error_said, link_note, wrong } = core.value;
  if (needs_confirmation) return localText(needs_confirmation.said, reasonText(needs_confirmation.text));
  if (link_error) return t('remark.link', { text: localText(link_error_said, link_error) });
  if (link_note) return t('remark.link', { text: link_note });
  if (wrong > 0) return t('remark.received_wrongly', { count: wrong });
  if (hasJob(core.value)) return status.value.holds > 0 ? t('remark.buffer_full', { count: status.value.holds }) : '';
  if (job?.state === 'queued' && job.reason !== '') return t('remark.back_in_queue', { job: job.id, because: jobReason(job) });
  return job && job.ended_at_ms !== null ? lastJobText(job) : '';
}

function lastJobText(job: Job): string {
  const state = t(`job_state.${job.state}`);
  const because = job.reason !== '' && job.reason !== job.state && job.state !== 'done' ? jobReason(job) : '';
  return because === '' ? t('remark.last_job', { job: job.id, state }) : t('remark.last_job_because', { job: job.id, state, because });
}
