// The calls of whoever plans: orders, their jobs, parts that were made.
import { everything } from './calls';
import { request } from './client';
import { queryOf } from './query';
import type { HistorySums, Job, JobChoice, NewChoice, NewJob, NewOrder, Order, OrderPlan, OrderState, Release, StopReason, StopReasonCounts } from './types';

export const orderCalls = {
  orders: (state: OrderState | '') => everything<Order>('/orders', state === '' ? {} : { state }),
  order: (id: number) => request<Order>('GET', `/orders/${id}`),
  addOrder: (order: NewOrder, key: string) => request<Order>('POST', '/orders', { body: order, key }),
  changeOrder: (order: Order, plan: OrderPlan, key: string) =>
    request<Order>('PUT', `/orders/${order.id}`, { body: plan, ifMatch: order.revision, key }),
  moveOrder: (id: number, to: OrderState, reason: string, key: string) =>
    request<Order>('POST', `/orders/${id}/move`, { body: { to, ...(reason === '' ? {} : { reason }) }, key }),
  reportParts: (id: number, good: number, scrap: number, note: string, key: string) =>
    request<Order>('POST', `/orders/${id}/parts`, { body: { good, scrap, ...(note === '' ? {} : { note }) }, key }),
  jobsOf: (order: number) => everything<Job>('/jobs', { order: String(order) }),
  addJob: (order: number, release: number, key: string) => request<Job>('POST', '/jobs', { body: { release, order }, key }),
  historySums: (by: HistorySums['by'], filter: { state: string; machine: string; from_ms: number | null }) =>
    request<HistorySums>('GET', `/history/sums${queryOf({ by, ...filter })}`),
  planJob: (job: NewJob, key: string) => request<Job>('POST', '/jobs', { body: job, key }),
  planChoice: (group: string, choice: NewChoice, key: string) => request<JobChoice>('POST', `/groups/${encodeURIComponent(group)}/jobs`, { body: choice, key }),
  schedule: (job: number, not_before_ms: number | null, key: string) => request<Job>('POST', `/jobs/${job}/schedule`, { body: { not_before_ms }, key }),
  hold: (job: number, reason: string, key: string) => request<Job>('POST', `/jobs/${job}/hold`, { body: { reason }, key }),
  endHold: (job: number, key: string) => request<Job>('POST', `/jobs/${job}/end-hold`, { key }),
  retry: (job: number, key: string) => request<Job>('POST', `/jobs/${job}/retry`, { key }),
  armEarly: (job: number, minutes: number, early_reason: string, key: string) => request<Job>('POST', `/jobs/${job}/arm`, { body: { minutes, early_reason }, key }),
  confirmEnd: (job: number, note: string, key: string) => request<Job>('POST', `/jobs/${job}/confirm-end`, { body: note === '' ? {} : { note }, key }),
  stopReasons: (filter: { machine: string; from_ms: number | null }) => request<StopReasonCounts>('GET', `/stop-reasons${queryOf(filter)}`),
  jobStopReasons: (job: number) => request<{ reasons: StopReason[] }>('GET', `/jobs/${job}/stop-reasons`).then(({ reasons }) => reasons),
  stateStopReason: (job: number, reason: string, note: string, key: string) =>
    request<StopReason>('POST', `/jobs/${job}/stop-reasons`, { body: { reason, ...(note === '' ? {} : { note }) }, key }),
  releases: () => everything<Release>('/releases'),
};
