// Names for what the server describes (schema.d.ts, which `npm run schema` writes from the binary). Times are milliseconds since
// 1970; null where something has not happened.
import type { components } from './schema';

type Schemas = components['schemas'];

export type Session = Schemas['Session'];
export type NewSession = Schemas['NewSession'];
export type SignInProvider = Schemas['SignInProvider'];
export type ProviderSignIn = Schemas['ProviderSignIn'];
export type ProviderAnswer = Schemas['ProviderAnswer'];
export type Role = Session['role'];

export type MachineStatus = Schemas['MachineStatus'];
export type MachineItem = Schemas['MachineSummary'];
export type MachineWhole = Schemas['Machine']; // the whole profile in the place of its summary
export type LineState = MachineStatus['line'];
export type Stall = Schemas['Stall'];
export type TornBlock = NonNullable<MachineStatus['needs_confirmation']>;
export type PlcReport = NonNullable<MachineStatus['plc']>;
export type Progress = Schemas['EventProgress'];

export type Job = Schemas['Job'];
export type JobState = Job['state'];
export type Delivery = Job['delivery'];
export type Ledger = Schemas['Ledger'];
export type LedgerRow = Ledger['items'][number];
export type LedgerInterval = Ledger['interval'];

export type NewJob = Schemas['NewJob'];
export type NewChoice = Schemas['NewChoice'];
export type JobChoice = Schemas['JobChoice'];
export type StopReason = Schemas['StopReason'];
export type StopReasonCounts = Schemas['StopReasonCounts'];
export type JobForecast = Schemas['JobForecast'];

export type WireReport = Schemas['EventWire'];
export type WireRun = WireReport['runs'][number];
export type LineTest = Schemas['LineTest'];
export type LineTestResult = NonNullable<LineTest['result']>;

export type Program = Schemas['Program'];
export type Release = Schemas['Release'];
export type ReleaseState = Release['state'];
export type ReleaseMove = Schemas['ReleaseMove'];

export type Order = Schemas['Order'];
export type OrderState = Order['state'];
export type NewOrder = Schemas['NewOrder'];
export type OrderPlan = Schemas['OrderPlan'];
export type RestartPreview = Schemas['RestartPreview'];

export type Receipt = Schemas['Receipt'];
export type ReceiptState = Receipt['state'];
export type StoredLikeness = NonNullable<Receipt['stored']>;

export type ReceivedValues = Schemas['ReceivedValues'];
export type PathPicture = Schemas['PathPicture'];
export type Attachment = Schemas['Attachment'];
export type SweepFigures = Schemas['SweepFigures'];

export type StoreRoom = Schemas['StoreRoom'];
export type StoreVerification = Schemas['StoreVerification'];
export type Backup = Schemas['Backup'];
export type BackupMade = Schemas['BackupMade'];
export type ServerNode = Schemas['Node'];

export type Problem = Schemas['Problem'];
export type Said = Schemas['Said'];

export interface Page<T> {
  items: T[];
  next: string | null;
}

export type Alarm = Schemas['Alarm'];
export type Severity = Alarm['severity'];

export type ProgramLines = Schemas['ProgramLines'];
export type ProgramLine = ProgramLines['lines'][number];
export type Utilisation = Schemas['Utilisation'];
export type UsedDay = Utilisation['days'][number];

export type HistorySums = Schemas['HistorySums'];
export type HistoryGroup = HistorySums['groups'][number];

export type SearchResult = Schemas['SearchResult'];
export type SearchHit = SearchResult['items'][number];
export type ProgramRevision = Schemas['ProgramRevision'];
export type ProgramUses = Schemas['ProgramUses'];
export type Comparison = Schemas['Comparison'];
export type LinesAnswer = Comparison['text'];
export type VerdictSummary = Schemas['VerdictSummary'];
export type Verdict = Schemas['Verdict'];
export type NewWaiver = Schemas['NewWaiver'];
export type Outcome = Verdict['verdict'];
export type ToolPath = Schemas['ToolPath'];
export type ImportReport = Schemas['ImportReport'];
export type ImportRow = ImportReport['items'][number];
export type SplitProgram = Schemas['SplitText']['programs'][number];
export type Converted = Schemas['Converted'];
export type ConvertOrder = Schemas['ConvertOrder'];
export type Rewriting = Schemas['RewriteOrder'];
export type Rewritten = Schemas['Rewritten'];
export type Statistics = Schemas['Statistics'];
export type ConvertMode = Converted['mode'];
export type Diagnosed = Schemas['Diagnosed'];
export type Fault = Diagnosed['faults'][number];
export type OutlineRow = Diagnosed['outline'][number];
export type DialectWords = Schemas['DialectWords'];
export type DialectWord = DialectWords['words'][number];
export type FamilySummary = Schemas['FamilySummary'];
export type Family = Schemas['Family'];
export type Parameter = Family['parameters'][number];
export type Part = Schemas['Part'];
export type Rendered = Schemas['Rendered'];
export type LegendEntry = Schemas['LegendEntry'];
export type Preview = Schemas['Preview'];
export type PreviewVerdict = Schemas['PreviewVerdict'];

export type User = Schemas['User'];
export type Token = Schemas['Token'];
export type TokenMade = Schemas['TokenMade'];
export type MachineGroup = Schemas['MachineGroup'];
export type AuditRow = Schemas['AuditRow'];
