// Requests to the server: JSON out and in, and every failure as one ApiError that has a sentence for a person. It knows
// no route; those are in calls.ts.
import type { Problem } from './types';

const kBase = '/api/v1';
const kTimeoutMs = 20_000;

export class ApiError extends Error {
  readonly status: number; // 0: no answer came
  readonly details: string[];

  constructor(status: number, text: string, details: string[] = []) {
    super(text);
    this.name = 'ApiError';
    this.status = status;
    this.details = details;
  }
}

// One sentence, and one for each place that the server names.
export function errorOfProblem(status: number, problem: Partial<Problem> | null): ApiError {
  const text = problem?.detail || problem?.title || `the server answered ${status}`;
  const details = (problem?.errors ?? []).map((place) => {
    if (place.line) return `line ${place.line}, column ${place.column ?? 1}: ${place.text}`;
    return place.pointer ? `${place.pointer}: ${place.text}` : place.text;
  });
  return new ApiError(status, text, details);
}

// Identifies one order of a person, so that a repeated request cannot act twice. randomUUID would need https.
export function newOrderKey(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

interface Options {
  body?: unknown;
  key?: string;
}

export async function request<T>(method: 'GET' | 'POST' | 'DELETE', path: string, options: Options = {}): Promise<T> {
  const headers: Record<string, string> = { Accept: 'application/json' };
  const init: RequestInit = { method, headers, cache: 'no-store', credentials: 'same-origin' };
  if (options.body !== undefined) {
    headers['Content-Type'] = 'application/json';
    init.body = JSON.stringify(options.body);
  }
  if (options.key) headers['Idempotency-Key'] = options.key;
  const abort = new AbortController();
  const timer = setTimeout(() => abort.abort(), kTimeoutMs);
  try {
    const response = await fetch(kBase + path, { ...init, signal: abort.signal });
    const text = await response.text();
    if (!response.ok) throw errorOfProblem(response.status, parse(text) as Partial<Problem> | null);
    return parse(text) as T;
  } catch (error) {
    if (error instanceof ApiError) throw error;
    throw new ApiError(0, noAnswer(method));
  } finally {
    clearTimeout(timer);
  }
}

function parse(text: string): unknown {
  try {
    return text === '' ? null : JSON.parse(text);
  } catch {
    return null;
  }
}

function noAnswer(method: string): string {
  if (method === 'GET') return 'The server does not answer.';
  return 'The server does not answer. Whether the order took effect is not known: look at the state before you repeat it.';
}
