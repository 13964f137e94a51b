// The calls of the desk: the library, a program's text, its revisions and checks, families and parts.
import { everything } from './calls';
import { request, requestBytes, requestText, sendFile } from './client';
import { queryOf } from './query';
import type {
  Attachment,
  AuditRow,
  Comparison,
  ConvertOrder,
  Converted,
  Delivery,
  Diagnosed,
  DialectWords,
  Family,
  FamilySummary,
  ImportReport,
  NewWaiver,
  Page,
  Part,
  PathPicture,
  Preview,
  PreviewVerdict,
  Program,
  ProgramRevision,
  ProgramUses,
  ReceivedValues,
  Release,
  ReleaseMove,
  Rendered,
  Rewriting,
  Rewritten,
  RestartPreview,
  SearchResult,
  SplitProgram,
  Statistics,
  SweepFigures,
  ToolPath,
  Verdict,
  VerdictSummary,
} from './types';

const enc = encodeURIComponent;
const kWorkMs = 120_000; // a check may wait for others
const kSweepMs = 10 * kWorkMs; // as many checks as the server lets it make
const kTextMs = 300_000;

export interface LibraryFilter {
  folder?: string;
  tag?: string;
  part?: string;
  name?: string;
  shelf?: string;
}

// A picture of a check: which route draws it.
export interface CheckPicture {
  route: 'timing' | 'gouge' | 'accuracy';
  plot: 'feed' | 'buffer' | 'stock' | 'deviation';
}
export type PictureOf = Pick<Verdict, 'program' | 'revision' | 'machine' | 'delivery'>;

export interface ImportPlan {
  folder: string; // of the library; '': none
  known: 'revise' | 'skip'; // a name that is in use with another text
  onlyLook: boolean;
}
export interface FileToImport extends ImportPlan {
  path: string;
  keepsEnding: boolean;
}

// Whose an attached file is.
export type FileOwner = { program: number } | { family: string } | { part: string } | { order: number };

export interface DiagnoseOrder {
  text: string;
  dialect?: string;
  machine?: string;
}

// A blank: "box X0 X1 Y0 Y1 Z0 Z1" or "cylinder DIAMETER Z0 Z1", mm.
export interface PathOrder extends DiagnoseOrder {
  stock?: string;
  delivery?: Delivery;
  nominal?: { family: string; values: Record<string, string> };
}

export const deskCalls = {
  programs: (filter: LibraryFilter, after: string | null) =>
    request<Page<Program>>('GET', `/programs${queryOf({ limit: 50, ...filter, after })}`),
  programsNamed: (name: string) => everything<Program>('/programs', { name }),
  search: (words: string, all: boolean, after: string | null) =>
    request<SearchResult>('GET', `/search${queryOf({ limit: 50, q: words, shelf: all ? 'all' : '', after })}`),
  program: (id: number) => request<Program>('GET', `/programs/${id}`),
  textHref: (id: number, revision: number) => `/api/v1/programs/${id}/text?revision=${revision}`,
  programBytes: (id: number, revision: number) => requestBytes(`/programs/${id}/text?revision=${revision}`),
  addProgram: (name: string, dialect: string, text: string, key: string) =>
    request<Program>('POST', '/programs', { body: { name, dialect, text }, key, timeoutMs: kTextMs }),
  addRevision: (id: number, base: number, text: string, key: string) =>
    request<Program>('POST', `/programs/${id}/revisions`, { body: { text }, ifMatch: base, key, timeoutMs: kTextMs }),
  label: (id: number, labels: { tags?: string[]; folder?: string }) =>
    request<Program>('PATCH', `/programs/${id}`, { body: labels }),
  archive: (id: number, reason: string, key: string) => request<Program>('POST', `/programs/${id}/archive`, { body: { reason }, key }),
  fetchBack: (id: number, reason: string, key: string) =>
    request<Program>('POST', `/programs/${id}/fetch-back`, { body: { reason }, key }),
  revisions: (id: number, after: string | null) =>
    request<Page<ProgramRevision>>('GET', `/programs/${id}/revisions${queryOf({ limit: 50, after })}`),
  compare: (id: number, query: { revision?: number; with?: number; with_revision?: number; machine?: string }) =>
    request<Comparison>('GET', `/programs/${id}/compare${queryOf(query)}`, { timeoutMs: kWorkMs }),
  compareText: (id: number, of: { text: string; revision: number; machine?: string }) =>
    request<Comparison>('POST', `/programs/${id}/compare`, { body: of, timeoutMs: kWorkMs }),
  programPath: (id: number, revision: number, machine: string, delivery: Delivery | null) =>
    request<ToolPath>('GET', `/programs/${id}/path${queryOf({ revision, machine, delivery })}`, { timeoutMs: kWorkMs }),
  picture: (id: number, revision: number) => request<PathPicture>('GET', `/programs/${id}/picture?revision=${revision}`, { timeoutMs: kWorkMs }),
  pathOfText: (order: PathOrder) => request<ToolPath>('POST', '/path', { body: order, timeoutMs: kWorkMs }),
  programStock: (id: number, revision: number, machine: string, delivery: Delivery | null, stock: string) =>
    requestBytes(`/programs/${id}/stock${queryOf({ revision, machine, delivery, stock })}`),
  stockOfText: (order: PathOrder) => requestBytes('/stock', order),
  attachments: (owner: FileOwner) => everything<Attachment>('/attachments', Object.fromEntries(Object.entries(owner).map(([name, value]) => [name, String(value)]))),
  attach: (owner: FileOwner, file: File, key: string) => sendFile<Attachment>(`/attachments${queryOf({ name: file.name, ...owner })}`, file, key),
  detach: (id: number, reason: string, key: string) => request<Attachment>('POST', `/attachments/${id}/remove`, { body: { reason }, key }),
  attachmentHref: (id: number) => `/api/v1/attachments/${id}/content`,
  uses: (id: number) => request<ProgramUses>('GET', `/programs/${id}/uses`),

  diagnose: (order: DiagnoseOrder) => request<Diagnosed>('POST', '/diagnose', { body: order, timeoutMs: kWorkMs }),
  importFile: (file: File, plan: FileToImport, key: string) =>
    sendFile<ImportReport>(
      `/imports${queryOf({
        path: plan.path,
        folder: plan.folder,
        known: plan.known,
        keep_ending: plan.keepsEnding ? 'true' : null,
        only_look: plan.onlyLook ? 'true' : null,
      })}`,
      file,
      key,
    ),
  split: async (text: string) => (await request<{ programs: SplitProgram[] }>('POST', '/split', { body: { text }, timeoutMs: kTextMs })).programs,
  convert: (order: ConvertOrder) => request<Converted>('POST', '/convert', { body: order, timeoutMs: kWorkMs }),
  rewrite: (order: Rewriting) => request<Rewritten>('POST', '/rewrite', { body: order, timeoutMs: kWorkMs }),
  statistics: (order: DiagnoseOrder) => request<Statistics>('POST', '/statistics', { body: order, timeoutMs: kWorkMs }),
  words: (dialect: string, kind: string, gSystem: string) =>
    request<DialectWords>('GET', `/dialects/${enc(dialect)}/words${queryOf({ kind, g_system: gSystem })}`),

  checks: (program: number) => everything<VerdictSummary>('/checks', { program: String(program) }),
  check: (id: number) => request<Verdict>('GET', `/checks/${id}`),
  addCheck: (program: number, revision: number, machine: string, delivery: Delivery, key: string) =>
    request<Verdict>('POST', '/checks', { body: { program, revision, machine, delivery }, key, timeoutMs: kWorkMs }),

  releasesOf: (program: number) => everything<Release>('/releases', { program: String(program) }),
  addRelease: (program: number, revision: number, machine: string, delivery: Delivery, key: string) =>
    request<Release>('POST', '/releases', { body: { program, revision, machine, delivery }, key }),
  handIn: (release: number, note: string, key: string) =>
    request<Release>('POST', `/releases/${release}/transitions`, { body: { to: 'in_review', note }, key }),

  release: (id: number) => request<Release>('GET', `/releases/${id}`),
  moveRelease: (id: number, move: ReleaseMove, key: string) => request<Release>('POST', `/releases/${id}/transitions`, { body: move, key }),
  signOff: (id: number, note: string, key: string) => request<Release>('POST', `/releases/${id}/sign-off`, { body: { note }, key }),
  // Who did what with it, newest first.
  releaseHistory: (id: number) => everything<AuditRow>('/audit', { subject: `release/${id}` }),
  waive: (check: number, waiver: NewWaiver, key: string) => request<Verdict>('POST', `/checks/${check}/waivers`, { body: waiver, key }),
  checkPicture: ({ route, plot }: CheckPicture, of: PictureOf) =>
    requestText(`/${route}?plot=${plot}`, { method: 'POST', body: of, timeoutMs: kWorkMs }),
  previewRestart: (release: number, line: number) =>
    request<RestartPreview>('POST', `/releases/${release}/restart-preview`, { body: { line }, timeoutMs: kWorkMs }),
  makeRestart: (release: number, line: number, sha256: string, key: string) =>
    request<Release>('POST', `/releases/${release}/restarts`, { body: { line, shown_sha256: sha256 }, key, timeoutMs: kWorkMs }),
  releaseRestart: (release: number, sha256: string, key: string) =>
    request<Release>('POST', `/releases/${release}/transitions`, { body: { to: 'proving', transfers: 1, shown_sha256: sha256 }, key }),

  families: () => everything<FamilySummary>('/families'),
  family: (name: string) => request<Family>('GET', `/families/${enc(name)}`),
  addFamily: (text: string, key: string) => request<Family>('POST', '/families', { body: { text }, key }),
  changeFamily: (name: string, base: number, text: string, key: string) =>
    request<Family>('PUT', `/families/${enc(name)}`, { body: { text }, ifMatch: base, key }),
  parts: (family?: string) => everything<Part>('/parts', family ? { family } : {}),
  part: (number: string) => request<Part>('GET', `/parts/${enc(number)}`),
  addPart: (number: string, family: string, values: Record<string, string>, key: string) =>
    request<Part>('POST', '/parts', { body: { number, family, values }, key }),
  changePart: (number: string, base: number, values: Record<string, string>, key: string) =>
    request<Part>('PUT', `/parts/${enc(number)}`, { body: { values }, ifMatch: base, key }),
  preview: (family: string, values: Record<string, string>, machine: string, delivery: Delivery) =>
    request<Preview>('POST', '/preview', { body: { family, values, machine, delivery }, timeoutMs: kWorkMs }),
  // A check of what the preview shows: the server stores nothing.
  previewVerdict: (family: string, values: Record<string, string>, machine: string, delivery: Delivery, signal: AbortSignal) =>
    request<PreviewVerdict>('POST', '/preview/verdict', { body: { family, values, machine, delivery }, timeoutMs: kWorkMs, signal }),
  explainReceipt: (id: number) => request<ReceivedValues>('POST', `/receipts/${id}/explain`, { timeoutMs: kWorkMs }),
  sweep: (family: string, values: Record<string, string>, machine: string, delivery: Delivery) =>
    request<SweepFigures>('POST', '/sweep', { body: { family, values, machine, delivery }, timeoutMs: kSweepMs }),
  render: (part: string, machine: string, delivery: Delivery, key: string) =>
    request<Rendered>('POST', '/render', { body: { part, machine, delivery }, key, timeoutMs: kWorkMs }),
};
