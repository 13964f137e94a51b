// Requests to the server: JSON out and in, and every failure as one ApiError that has a sentence for a person. It knows
// no route; those are in calls.ts.
import { localText } from '../format/local_text';
import { t } from '../i18n/i18n';
import type { Problem } from './types';

const kBase = '/api/v1';
const kTimeoutMs = 20_000;

export type Place = NonNullable<Problem['errors']>[number];

export class ApiError extends Error {
  readonly status: number; // 0: no answer came
  readonly details: string[];
  readonly places: readonly Place[]; // the members of the request that are at fault

  constructor(status: number, text: string, details: string[] = [], places: readonly Place[] = []) {
    super(text);
    this.places = places;
    this.name = 'ApiError';
    this.status = status;
    this.details = details;
  }
}

// One sentence, and one for each place that the server names.
export function errorOfProblem(status: number, problem: Partial<Problem> | null): ApiError {
  const text = localText(problem?.said, problem?.detail || problem?.title || t('error.status', { status }));
  const details = (problem?.errors ?? []).map((place) => {
    if (place.line) return t('error.place', { line: place.line, column: place.column ?? 1, text: place.text });
    return place.pointer ? `${place.pointer}: ${place.text}` : place.text;
  });
  return new ApiError(status, text, details, problem?.errors ?? []);
}

// Identifies one order of a person, so that a repeated request cannot act twice. randomUUID would need https.
export function newOrderKey(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

// Whom the page shows as signed in. Each order carries the name, so that the server refuses one that would bear another.
let shownUser = '';
export const setShownUser = (name: string): void => {
  shownUser = name;
};

const whoAsks = (): Record<string, string> => (shownUser === '' ? {} : { 'X-Dripfeed-User': encodeURIComponent(shownUser) });

type Method = 'GET' | 'POST' | 'PUT' | 'PATCH' | 'DELETE';

interface Options {
  body?: unknown;
  key?: string;
  ifMatch?: number; // the revision that is changed
  timeoutMs?: number; // of work that takes longer than an answer should
  signal?: AbortSignal | undefined; // once aborted, the server ends the work, too
}

export async function request<T>(method: Method, path: string, options: Options = {}): Promise<T> {
  return parse(await answerOf(method, path, options)) as T;
}

// Outside of the API's version: its description.
export async function requestRoot<T>(path: string): Promise<T> {
  const response = await fetch(path, { credentials: 'same-origin' }).catch(() => null);
  if (!response?.ok) throw new ApiError(response?.status ?? 0, noAnswer('GET'));
  return (await response.json()) as T;
}

// An answer that is not JSON.
export const requestText = (path: string, { method = 'GET', ...options }: Options & { method?: Method } = {}): Promise<string> => answerOf(method, path, options);

// An answer as it came: a program may be in any encoding.
export async function requestBytes(path: string, body?: unknown): Promise<ArrayBuffer> {
  const init: RequestInit = { cache: 'no-store', credentials: 'same-origin' };
  const posted: RequestInit = body === undefined ? {} : { method: 'POST', body: JSON.stringify(body), headers: { 'Content-Type': 'application/json', ...whoAsks() } };
  const response = await fetch(kBase + path, { ...init, ...posted }).catch(() => null);
  if (!response) throw new ApiError(0, noAnswer('GET'));
  if (!response.ok) throw errorOfProblem(response.status, parse(await response.text()) as Partial<Problem> | null);
  return response.arrayBuffer();
}

// A file as the body of a request.
export async function sendFile<T>(path: string, file: File, key: string): Promise<T> {
  const headers = { 'Content-Type': file.type || 'application/octet-stream', 'Idempotency-Key': key, ...whoAsks() };
  const response = await fetch(kBase + path, { method: 'POST', cache: 'no-store', credentials: 'same-origin', headers, body: file }).catch(() => null);
  if (!response) throw new ApiError(0, noAnswer('POST'));
  const answer = parse(await response.text());
  if (!response.ok) throw errorOfProblem(response.status, answer as Partial<Problem> | null);
  return answer as T;
}

async function answerOf(method: Method, path: string, options: Options): Promise<string> {
  const headers: Record<string, string> = { Accept: 'application/json, text/plain, image/svg+xml' };
  const init: RequestInit = { method, headers, cache: 'no-store', credentials: 'same-origin' };
  if (options.body !== undefined) {
    headers['Content-Type'] = 'application/json';
    init.body = JSON.stringify(options.body);
  }
  if (options.ifMatch !== undefined) headers['If-Match'] = `"${options.ifMatch}"`;
  if (options.key) headers['Idempotency-Key'] = options.key;
  if (method !== 'GET') Object.assign(headers, whoAsks());
  const abort = new AbortController();
  options.signal?.addEventListener('abort', () => abort.abort());
  const timer = setTimeout(() => abort.abort(), options.timeoutMs ?? kTimeoutMs);
  try {
    const response = await fetch(kBase + path, { ...init, signal: abort.signal });
    const text = await response.text();
    if (!response.ok) throw errorOfProblem(response.status, parse(text) as Partial<Problem> | null);
    return text;
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

const noAnswer = (method: Method): string => t(method === 'GET' ? 'error.no_answer' : 'error.effect_not_known');
