// The toolpath of a program: the picture, what it consists of in words, and what is not known of it.
import { useEffect, useMemo, useState } from 'preact/hooks';
import type { ToolPath } from '../../api/types';
import { count } from '../../format/numbers';
import { t } from '../../i18n/i18n';
import { lazyView } from '../../parts/lazy';
import type { PlotsProps } from '../../plots/plots';
import { clockOf, type PathPlace } from '../../path/clock';
import { dataOf, kBegin, type PathData } from '../../path/data';
import type { Stock } from '../../path/stock';
import { PathFacts } from './path_facts';
import { PathGaps, PathNotes } from './path_gaps';
import { StockPanel, type StockSource } from './stock_panel';
import { TimeBar } from './time_bar';
import { TimeNotes } from './time_notes';
import { toolAt, ToolNote } from './tool_note';
import { placeText } from './words';

export interface PathProps {
  path: ToolPath;
  isOfMachine: boolean;
  stock: StockSource | null; // null: none can be asked for
  line: number; // that is looked at in the text; 0: none
  chosen: (line: number) => void; // by a person, in the picture or along the program
}

export interface PictureProps {
  path: ToolPath;
  data: PathData;
  at: PathPlace | null;
  tool: number; // of path.tools
  line: number;
  stock: Stock | null;
  picked: (point: number) => void;
}

const Plots = lazyView<PlotsProps>(() => import('../../plots/plots').then((file) => file.Plots));
const Picture = lazyView<PictureProps>(() => import('./picture').then((file) => file.Picture));

export function PathView({ path, isOfMachine, stock: source, line, chosen }: PathProps) {
  const data = useMemo(() => dataOf(path), [path]);
  const [at, setAt] = useState<PathPlace | null>(null);
  const [running, setRunning] = useState(false);
  const [stock, setStock] = useState<Stock | null>(null);
  useEffect(() => setAt(null), [data]);
  // The cursor in the text leads the tool to the end of its line.
  useEffect(() => {
    if (running) return; // the tool leads the cursor
    setAt((before) => {
      if (before !== null && data.lines[before.point] === line) return before;
      const there = lastOfLine(data, line);
      return there === null ? before : { point: there, share: 1 };
    });
  }, [data, line]);
  const goTo = (place: PathPlace) => {
    setAt(place);
    const of = data.lines[place.point] ?? 0;
    if (of > 0 && of !== line) chosen(of);
  };
  const last = data.count - 1;
  const here = at?.point ?? last;
  const tool = toolAt(path, here);
  if (path.segments === 0)
    return (
      <>
        <p class="notice tone-waiting">{t('path.nothing')}</p>
        <PathGaps path={path} title={t(path.is_cut_off ? 'path.cut_off' : 'path.not_whole', { points: count(path.points) })} />
        <PathNotes path={path} />
      </>
    );
  return (
    <>
      <PathGaps path={path} title={t(path.is_cut_off ? 'path.cut_off' : 'path.not_whole', { points: count(path.points) })} />
      {source && <StockPanel path={path} source={source} show={setStock} />}
      <Picture path={path} data={data} at={at?.point === last && at.share === 1 ? null : at} tool={tool} line={at === null ? line : (data.lines[here] ?? 0)} stock={stock} picked={(point) => goTo({ point, share: 1 })} />
      <Along path={path} data={data} place={at ?? { point: last, share: 1 }} goTo={goTo} running={running} run={setRunning} />
      <ToolNote path={path} tool={tool} />
      <TimeNotes path={path} isOfMachine={isOfMachine} />
      <PathNotes path={path} />
      <PathFacts path={path} />
    </>
  );
}

interface AlongProps {
  path: ToolPath;
  data: PathData;
  place: PathPlace;
  goTo: (place: PathPlace) => void;
  running: boolean;
  run: (is: boolean) => void;
}

// Along the program, and along time where that is known.
function Along({ path, data, place, goTo, running, run }: AlongProps) {
  const clock = useMemo(() => clockOf(data), [data]);
  const [isPlotted, setPlotted] = useState(false);
  const text = placeText(path, data, place.point);
  return (
    <>
      <label class="path-slider">
        <span>{t('path.along')}</span>
        <input
          type="range"
          min={0}
          max={data.count - 1}
          value={place.point}
          aria-valuetext={text}
          onInput={(event) => goTo({ point: Number(event.currentTarget.value), share: 1 })}
        />
      </label>
      {clock && <TimeBar clock={clock} place={place} text={text} goTo={goTo} running={running} run={run} />}
      <p class="path-place">{text}</p>
      {clock && (
        <button type="button" class="button button-small path-more" aria-pressed={isPlotted} onClick={() => setPlotted(!isPlotted)}>
          {t('plots.show')}
        </button>
      )}
      {clock && isPlotted && <Plots data={data} clock={clock} time_s={clock.timeAt(place)} goTo={(time_s) => goTo(clock.placeAt(time_s))} />}
    </>
  );
}

// Of the first visit of a line.
function lastOfLine(data: PathData, line: number): number | null {
  if (line <= 0) return null;
  let i = data.lines.findIndex((one, point) => one === line && data.kinds[point] !== kBegin);
  if (i < 0) return null;
  while (i + 1 < data.count && data.lines[i + 1] === line && data.kinds[i + 1] !== kBegin) i += 1;
  return i;
}
