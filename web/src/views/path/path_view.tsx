// The toolpath of a program: the picture, what it consists of in words, and what is not known of it.
import { useEffect, useMemo, useState } from 'preact/hooks';
import type { ToolPath } from '../../api/types';
import { count } from '../../format/numbers';
import { t } from '../../i18n/i18n';
import { lazyView } from '../../parts/lazy';
import { dataOf, kBegin, type PathData } from '../../path/data';
import { PathFacts } from './path_facts';
import { PathGaps, PathNotes } from './path_gaps';
import { placeText } from './words';

export interface PathProps {
  path: ToolPath;
  line: number; // that is looked at in the text; 0: none
  chosen: (line: number) => void; // by a person, in the picture or along the program
}

export interface PictureProps {
  path: ToolPath;
  data: PathData;
  at: number | null;
  line: number;
  picked: (point: number) => void;
}

const Picture = lazyView<PictureProps>(() => import('./picture').then((file) => file.Picture));

export function PathView({ path, line, chosen }: PathProps) {
  const data = useMemo(() => dataOf(path), [path]);
  const [at, setAt] = useState<number | null>(null);
  useEffect(() => setAt(null), [data]);
  // The cursor in the text leads the tool to the end of its line.
  useEffect(() => {
    setAt((before) => {
      if (before !== null && data.lines[before] === line) return before;
      const there = lastOfLine(data, line);
      return there ?? before;
    });
  }, [data, line]);
  const goTo = (point: number) => {
    setAt(point);
    const of = data.lines[point] ?? 0;
    if (of > 0) chosen(of);
  };
  const last = data.count - 1;
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
      <Picture path={path} data={data} at={at === last ? null : at} line={at === null ? line : (data.lines[at] ?? 0)} picked={goTo} />
      <label class="path-slider">
        <span>{t('path.along')}</span>
        <input
          type="range"
          min={0}
          max={last}
          value={at ?? last}
          aria-valuetext={placeText(path, data, at ?? last)}
          onInput={(event) => goTo(Number(event.currentTarget.value))}
        />
      </label>
      <p class="path-place">{placeText(path, data, at ?? last)}</p>
      <PathNotes path={path} />
      <PathFacts path={path} />
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
