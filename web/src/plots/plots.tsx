// Feed, buffer and deviation over time, one plot below the other with one axis of time: zoomed by drag and by keys, linked
// to the place on the path. Loaded when a person asks for it.
import uPlot from 'uplot';
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { duration } from '../format/times';
import { t } from '../i18n/i18n';
import type { Clock } from '../path/clock';
import type { PathData } from '../path/data';
import { moved, seriesNamesOf, stepsOf, zoomed, type SeriesName, type Span } from './series';

export interface PlotsProps {
  data: PathData;
  clock: Clock;
  time_s: number; // of the place on the path
  goTo: (time_s: number) => void;
}

const kHeight_px = 150;
const kBuckets = 900;
const kZoom = 2;
const kMove = 0.25;
const kTokens: Record<SeriesName, string> = { speed: '--path-cut', buffer: '--path-rapid', deviation: '--path-thread' };

export function Plots({ data, clock, time_s, goTo }: PlotsProps) {
  const names = useMemo(() => seriesNamesOf(data), [data]);
  const whole = { from_s: 0, to_s: clock.end_s };
  const [span, setSpan] = useState<Span>(whole);
  useEffect(() => setSpan(whole), [data]);
  const isWhole = span.from_s <= 0 && span.to_s >= clock.end_s;
  const keys: Record<string, () => Span | null> = {
    '+': () => zoomed(span, kZoom, time_s, clock.end_s),
    '-': () => zoomed(span, 1 / kZoom, time_s, clock.end_s),
    ArrowLeft: () => moved(span, -kMove, clock.end_s),
    ArrowRight: () => moved(span, kMove, clock.end_s),
    '0': () => whole,
  };
  const press = (event: KeyboardEvent) => {
    const next = event.ctrlKey || event.metaKey || event.altKey ? null : keys[event.key]?.();
    if (!next) return;
    event.preventDefault();
    setSpan(next);
  };
  return (
    <section class="plots" aria-label={t('plots.title')}>
      <div class="plots-bar">
        <span class="path-clock">{t('plots.span', { from: duration(span.from_s), to: duration(span.to_s) })}</span>
        <button type="button" class="button button-small" aria-disabled={isWhole} onClick={() => setSpan(whole)}>
          {t('plots.whole')}
        </button>
      </div>
      <div class="plots-host" role="application" tabIndex={0} aria-label={t('plots.title')} aria-describedby="plots-keys" onKeyDown={press}>
        {names.map((name) => (
          <Plot key={name} name={name} data={data} span={span} time_s={time_s} goTo={goTo} zoom={setSpan} />
        ))}
      </div>
      <p id="plots-keys" class="hint">
        {t('plots.keys')}
      </p>
    </section>
  );
}

interface PlotProps {
  name: SeriesName;
  data: PathData;
  span: Span;
  time_s: number;
  goTo: (time_s: number) => void;
  zoom: (span: Span) => void;
}

const token = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

function Plot({ name, data, span, time_s, goTo, zoom }: PlotProps) {
  const host = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const latest = useRef({ time_s, goTo, zoom });
  latest.current = { time_s, goTo, zoom };
  useEffect(() => {
    if (!host.current) return;
    const box = host.current;
    const open = () => {
      plot.current?.destroy();
      plot.current = new uPlot(optionsOf(name, box, latest), [[], []], box);
      fill(plot.current, data, name, span);
    };
    open();
    const sizes = new ResizeObserver(() => plot.current?.setSize({ width: box.clientWidth, height: kHeight_px }));
    sizes.observe(box);
    const dark = matchMedia('(prefers-color-scheme: dark)');
    dark.addEventListener('change', open);
    return () => {
      dark.removeEventListener('change', open);
      sizes.disconnect();
      plot.current?.destroy();
      plot.current = null;
    };
  }, [name]);
  useEffect(() => {
    if (plot.current) fill(plot.current, data, name, span);
  }, [data, name, span.from_s, span.to_s]);
  useEffect(() => plot.current?.redraw(false), [time_s]);
  return (
    <figure class="plot">
      <figcaption>{t(`plots.${name}`)}</figcaption>
      <div ref={host} />
    </figure>
  );
}

function fill(plot: uPlot, data: PathData, name: SeriesName, span: Span): void {
  const { times, values, top } = stepsOf(data, name, span.from_s, span.to_s, kBuckets);
  plot.setData([times, values], false);
  plot.setScale('x', { min: span.from_s, max: span.to_s });
  // Rapids are so much faster than cuts that they are left to run off the top.
  if (name === 'speed' && top > 0) plot.setScale('y', { min: 0, max: 1.25 * top });
}

type Latest = { current: { time_s: number; goTo: (time_s: number) => void; zoom: (span: Span) => void } };

const kShortestDrag_px = 6;

function optionsOf(name: SeriesName, box: HTMLElement, latest: Latest): uPlot.Options {
  const ink = token('--ink-quiet');
  const grid = { stroke: token('--line'), width: 1 };
  const axis = { stroke: ink, grid, ticks: grid, font: `12px ${getComputedStyle(box).fontFamily}` };
  const stepped = uPlot.paths.stepped?.({ align: -1 });
  return {
    width: box.clientWidth,
    height: kHeight_px,
    legend: { show: false },
    scales: { x: { time: false }, y: name === 'speed' ? { auto: false, range: (_, low, high) => [low, high > 0 ? high : 1] } : { range: (_, low, high) => (name === 'deviation' ? around(low, high) : [0, high > 0 ? 1.08 * high : 1]) } },
    axes: [{ ...axis, values: (_, ticks) => ticks.map((one) => `${Number(one.toPrecision(6))} s`) }, { ...axis, size: 64 }],
    cursor: { drag: { x: true, y: false, setScale: false }, points: { show: false } },
    series: [{}, { stroke: token(kTokens[name]), width: 1.5, ...(stepped ? { paths: stepped } : {}), points: { show: false } }],
    hooks: {
      setSelect: [
        (plot) => {
          const { left, width } = plot.select;
          if (width < kShortestDrag_px) return;
          latest.current.zoom({ from_s: plot.posToVal(left, 'x'), to_s: plot.posToVal(left + width, 'x') });
          plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
        },
      ],
      ready: [
        (plot) => {
          plot.over.addEventListener('click', () => {
            if (plot.cursor.left !== undefined && plot.cursor.left >= 0) latest.current.goTo(plot.posToVal(plot.cursor.left, 'x'));
          });
        },
      ],
      draw: [(plot) => markPlace(plot, latest.current.time_s)],
    },
  };
}

function around(low: number, high: number): [number, number] {
  const most = Math.max(Math.abs(low), Math.abs(high), 1e-3);
  return [-1.08 * most, 1.08 * most];
}

// A line at the place on the path.
function markPlace(plot: uPlot, time_s: number): void {
  const x = Math.round(plot.valToPos(time_s, 'x', true));
  const { left, top, width, height } = plot.bbox;
  if (x < left || x > left + width) return;
  plot.ctx.fillStyle = token('--path-mark');
  plot.ctx.fillRect(x - 1, top, 2, height);
}
