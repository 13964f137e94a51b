// What the text amounts to, and what is written compared with the stored revision: figures, tool by tool, and the lines that
// differ.
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Comparison, Program, Statistics } from '../../api/types';
import { bytes, count } from '../../format/numbers';
import { duration } from '../../format/times';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { Older } from '../../parts/older';
import { Table, type Column } from '../../parts/table';
import { useAsked } from '../../parts/use_asked';
import { useLoaded } from '../../parts/use_loaded';
import { useNumberOf } from '../../parts/use_number_of';
import { extentText } from '../path/path_facts';
import { PathGaps, PathNotes } from '../path/path_gaps';
import { axesOf, axisName, lengthText } from '../path/words';
import { ComparedView } from './compare';

interface Props {
  program: Program;
  base: number; // the revision that is stored
  stored: string;
  written: string | null; // a text that differs from it; null: it does not
  machine: string;
  chosen: (line: number) => void;
}

const kPause_ms = 1_200;

export function FiguresPanel({ program, base, stored, written, machine, chosen }: Props) {
  const ofWhom = { dialect: program.dialect, ...(machine ? { machine } : {}) };
  const before = useLoaded(`${program.id} ${machine} ${base}`, () => deskCalls.statistics({ text: stored, ...ofWhom }));
  const { text, isOlder, askNow } = useAsked(written, kPause_ms);
  const number = useNumberOf(text);
  const now = useLoaded(text === null ? null : `${program.id} ${machine} ${number}`, () => deskCalls.statistics({ text: text ?? '', ...ofWhom }));
  const shown = text === null ? before.value : now.value;
  const isRunning = before.loading || now.loading;
  return (
    <section class="figures" aria-label={t('figures.title')} aria-busy={isRunning}>
      <h2>{t('figures.title')}</h2>
      <Failure error={before.error ?? now.error} />
      {isOlder && <Older what={t('figures.older')} askNow={askNow} />}
      {isRunning && (
        <p class="hint" role="status">
          {t('path.running')}
        </p>
      )}
      {shown && <Figures of={shown} before={text === null ? null : before.value} base={base} chosen={chosen} />}
      {text !== null && <Differences key={base} program={program} base={base} text={text} number={number} machine={machine} chosen={chosen} />}
    </section>
  );
}

interface FiguresProps {
  of: Statistics;
  before: Statistics | null; // of the stored revision, where another text is written
  base: number;
  chosen: (line: number) => void;
}

interface Figure {
  name: string;
  text: (of: Statistics) => string;
}

const timeText = (time_s: number | null): string => (time_s === null ? '–' : duration(time_s));

function figuresOf(all: readonly Statistics[]): Figure[] {
  const axes = [...new Set(all.flatMap((one) => axesOf(one)))].sort();
  const [first] = all;
  return [
    { name: t('figures.time'), text: ({ time_s }) => timeText(time_s) },
    { name: t('path.cut_length'), text: ({ cut_mm }) => lengthText(cut_mm) },
    { name: t('path.rapid_length'), text: ({ rapid_mm }) => lengthText(rapid_mm) },
    ...axes.map((axis) => ({ name: first ? axisName(first, axis) : '', text: (of: Statistics) => extentText(of, axis) })),
    { name: t('figures.blocks'), text: ({ blocks }) => count(blocks) },
    { name: t('figures.lines'), text: ({ lines }) => count(lines) },
    { name: t('figures.size'), text: (of) => bytes(of.bytes) },
  ];
}

function Figures({ of, before, base, chosen }: FiguresProps) {
  const rows = figuresOf(before ? [before, of] : [of]);
  return (
    <>
      <PathGaps path={of} title={t('figures.not_whole')} />
      <Table
        label={t('figures.title')}
        rows={rows}
        keyOf={({ name }) => name}
        columns={[
          { id: 'name', head: t('figures.figure'), cell: ({ name }) => name },
          before !== null && { id: 'before', head: t('job.revision', { revision: base }), cell: ({ text }) => text(before) },
          { id: 'now', head: before === null ? t('job.revision', { revision: base }) : t('compare.written'), cell: ({ text }) => marked(text(of), before && text(before)) },
        ]}
      />
      {of.why_no_time !== null && <p class="hint">{t('figures.no_time')}</p>}
      {of.time_s !== null && <p class="hint">{t('figures.time_of')}</p>}
      {of.tools.length > 0 && <Table label={t('figures.tools')} rows={of.tools} keyOf={({ tool }) => tool ?? ''} columns={toolColumns(chosen)} />}
      <PathNotes path={of} />
    </>
  );
}

const marked = (text: string, before: string | null): ComponentChildren => (before === null || before === text ? text : <strong>{text}</strong>);

type Tool = Statistics['tools'][number];

const toolColumns = (chosen: (line: number) => void): Column<Tool>[] => [
  { id: 'tool', head: t('figures.tool'), cell: ({ tool }) => tool ?? t('figures.no_tool') },
  {
    id: 'line',
    head: t('figures.taken'),
    cell: ({ first_line }) =>
      first_line === null ? (
        '–'
      ) : (
        <button type="button" class="line-go" onClick={() => chosen(first_line)}>
          {t('fault.line', { line: first_line })}
        </button>
      ),
  },
  { id: 'time', head: t('figures.time'), cell: ({ time_s }) => timeText(time_s), by: ({ time_s }) => time_s },
  { id: 'cut', head: t('path.cut_length'), cell: ({ cut_mm }) => lengthText(cut_mm), by: ({ cut_mm }) => cut_mm },
  { id: 'rapid', head: t('path.rapid_length'), cell: ({ rapid_mm }) => lengthText(rapid_mm), by: ({ rapid_mm }) => rapid_mm },
];

interface DifferencesProps {
  program: Program;
  base: number;
  text: string;
  number: number; // of that text
  machine: string;
  chosen: (line: number) => void;
}

// Asked for by a person: both texts are run for it.
function Differences({ program, base, text, number, machine, chosen }: DifferencesProps) {
  const [asked, setAsked] = useState<string | null>(null);
  const key = `${number} ${machine}`;
  const { value, error, loading } = useLoaded<Comparison>(asked, () => deskCalls.compareText(program.id, { text, revision: base, ...(machine ? { machine } : {}) }));
  return (
    <>
      <Failure error={error} />
      {asked !== key && (
        <button type="button" class="button" onClick={() => setAsked(key)}>
          {t('figures.compare', { revision: base })}
        </button>
      )}
      {loading && (
        <p class="hint" role="status">
          {t('compare.running')}
        </p>
      )}
      {value && asked === key && <ComparedView of={value} chosen={chosen} />}
    </>
  );
}
