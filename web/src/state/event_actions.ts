// A live event as what it means here: an action on the state, and what must be asked for anew.
import type { Alarm, Job, Progress } from '../api/types';
import type { ServerEvent } from '../live/event_stream';
import type { Action } from './reduce';

export interface Meaning {
  action: Action | null;
  refreshMachine: string | null;
  reload: boolean;
}

const nothing: Meaning = { action: null, refreshMachine: null, reload: false };

// An event that this page does not know, or cannot read, changes nothing.
export function meaningOf(event: ServerEvent, nowMs: number): Meaning {
  if (event.name === 'reset') return { ...nothing, reload: true };
  const data = read(event.data);
  if (!data) return nothing;
  if (event.name === 'progress' && typeof data.machine === 'string')
    return { ...nothing, action: { type: 'progress', progress: data as unknown as Progress } };
  if (event.name === 'job' && typeof data.id === 'number') {
    const job = data as unknown as Job;
    return { ...nothing, action: { type: 'job', job }, refreshMachine: job.machine };
  }
  if (event.name === 'machine' && typeof data.name === 'string') return { ...nothing, refreshMachine: data.name };
  if (event.name === 'alarm' && typeof data.text === 'string')
    return { ...nothing, action: { type: 'alarm', alarm: data as unknown as Alarm, at: nowMs } };
  return nothing;
}

function read(text: string): Record<string, unknown> | null {
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === 'object' && value !== null ? (value as Record<string, unknown>) : null;
  } catch {
    return null;
  }
}
