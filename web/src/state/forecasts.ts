// What the checks predicted of a job's program, asked for once a job, when something shows it; and the pace that each
// machine's feed is seen to have.
import { signal } from '@preact/signals';
import { calls } from '../api/calls';
import type { Job, JobForecast, MachineStatus } from '../api/types';
import { paceOf, predictedS, timeLeft, type Pace, type TimeLeft } from '../rules/forecast';
import { linesOf } from './program_lines';

const forecasts = signal<ReadonlyMap<number, JobForecast>>(new Map());
const asked = new Set<number>();
const paces = new Map<string, Pace>();

// Null while it is not known.
export function forecastOf(job: number): JobForecast | null {
  const known = forecasts.value.get(job);
  if (known) return known;
  if (!asked.has(job)) {
    asked.add(job);
    void calls.jobForecast(job).then(
      (found) => {
        forecasts.value = new Map(forecasts.peek()).set(job, found);
      },
      () => undefined, // then the rate of bytes is what is known
    );
  }
  return null;
}

// Called while a feed is shown, about once a second.
export function timeLeftOf(machine: string, status: MachineStatus, job: Job | null, nowMs: number): TimeLeft | null {
  const forecast = job && forecastOf(job.id);
  const lines = job && linesOf(job.program, job.revision);
  const pace = paceOf(paces.get(machine) ?? null, status, job, forecast && predictedS(forecast, status.block, lines), nowMs);
  if (pace) paces.set(machine, pace);
  else paces.delete(machine);
  return timeLeft({ status, job, forecast, lines, pace, nowMs });
}
