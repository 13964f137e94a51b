// How news changes what the page knows. No requests here: the loader asks, this applies.
import { batch } from '@preact/signals';
import { isOpen } from '../rules/alarms';
import type { Alarm, Job, MachineItem, MachineStatus, Progress } from '../api/types';
import { alarms, jobs, machines, newMachine, programs, type Machine, type MachineHead } from './shop';

function headOf(item: MachineItem): MachineHead {
  const { status, ...head } = item;
  void status;
  return head;
}

// The set of machines as the server has it now; a machine that stays keeps its signals.
export function setMachines(items: MachineItem[]): void {
  const next = new Map<string, Machine>();
  for (const item of items) {
    const known = machines.peek().get(item.name);
    const machine = known ?? newMachine(headOf(item), item.status);
    machine.head.value = headOf(item);
    machine.status.value = item.status;
    next.set(item.name, machine);
  }
  machines.value = next;
}

// One machine's answer, asked for when `reportsBefore` reports had come. Newer reports keep their figures; what no
// report carries is the answer's.
export function takeMachine(item: MachineItem, reportsBefore: number): void {
  const known = machines.peek().get(item.name);
  if (!known) return setMachines([...[...machines.peek().values()].map(itemOf), item]);
  known.head.value = headOf(item);
  known.status.value =
    known.reports > reportsBefore
      ? { ...known.status.peek(), needs_confirmation: item.status.needs_confirmation }
      : item.status;
}

const itemOf = (machine: Machine): MachineItem => ({ ...machine.head.peek(), status: machine.status.peek() });

export function takeProgress(report: Progress): void {
  const known = machines.peek().get(report.machine);
  if (!known) return;
  known.reports += 1;
  const { machine: name, ...rest } = report;
  void name;
  const before = known.status.peek();
  known.status.value = { ...before, ...rest } satisfies MachineStatus;
}

export function takeJobs(list: Job[]): void {
  if (list.length === 0) return;
  const next = new Map(jobs.peek());
  for (const job of list) next.set(job.id, job);
  jobs.value = next;
}

export function takePrograms(list: { id: number; name: string }[]): void {
  if (list.length === 0) return;
  const next = new Map(programs.peek());
  for (const program of list) next.set(program.id, program.name);
  programs.value = next;
}

export function takeAlarms(list: Alarm[]): void {
  if (list.length === 0) return;
  const next = new Map(alarms.peek());
  for (const alarm of list) {
    if (isOpen(alarm)) next.set(alarm.id, alarm);
    else next.delete(alarm.id);
  }
  alarms.value = next;
}

export const setAlarms = (list: Alarm[]): void => {
  alarms.value = new Map(list.filter(isOpen).map((alarm) => [alarm.id, alarm]));
};

export const together = batch;
