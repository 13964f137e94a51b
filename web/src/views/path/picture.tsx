// The picture of a path with its buttons, keys and legend. Loaded when a path is shown first.
import { useEffect, useMemo, useState } from 'preact/hooks';
import { t } from '../../i18n/i18n';
import { coloringsOf, type ColorBy } from '../../path/color';
import type { ViewName } from '../../path/eye';
import type { PathScene } from '../../path/scene';
import { boundsOf } from '../../path/data';
import { stockBounds, type Stock } from '../../path/stock';
import type { Section } from '../../path/stock_view';
import { MeasureText } from './measure_text';
import { kWholeStock, StockLegend, StockTools, type StockLook } from './stock_tools';
import { Legend } from './legend';
import type { PictureProps } from './path_view';
import { shapeOf } from './tool_note';
import { useScene } from './use_scene';
import { axisName, isLathe, lengthText, mm } from './words';

const kMillViews: readonly ViewName[] = ['top', 'front', 'side', 'iso'];
const kLatheViews: readonly ViewName[] = ['turning', 'top', 'side', 'iso'];

export function Picture(props: PictureProps) {
  const { path, data, at, tool, line, stock } = props;
  const [chosen, setChosen] = useState<ColorBy>('kind');
  const [look, setLook] = useState<StockLook>(kWholeStock);
  const [isMeasuring, setMeasuring] = useState(false);
  const views = isLathe(path) ? kLatheViews : kMillViews;
  const colorings = useMemo(() => coloringsOf(data), [data]);
  const by = colorings.includes(chosen) ? chosen : 'kind';
  const extent = useMemo(() => extentOf(data, stock), [data, stock]);
  const { scene, parts, scale, spots, failed } = useScene(props);
  useEffect(() => scene.current?.colorBy(by), [by, data]);
  useEffect(() => scene.current?.tool(shapeOf(path, tool)), [path, tool]);
  useEffect(() => scene.current?.place(at), [at, data]);
  useEffect(() => scene.current?.mark(line), [line, data]);
  useEffect(() => scene.current?.stock(stock), [stock]);
  useEffect(() => scene.current?.compare(look.compares), [look.compares, stock]);
  useEffect(() => scene.current?.section(sectionOf(look, extent)), [look, extent]);
  useEffect(() => scene.current?.measuring(isMeasuring), [isMeasuring, data]);
  if (failed) return <p class="notice tone-waiting">{t('path.no_webgl')}</p>;
  const press = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !pressedIn(scene.current, views, event)) return;
    event.preventDefault();
  };
  return (
    <>
      <div class="path-tools">
        <Segments label={t('path.views')} names={views} text={(view) => t(`path_view.${view}`)} choose={(view) => scene.current?.look(view)} />
        <Segments label={t('path.color')} names={colorings} text={(one) => t(`path_color.${one}`)} chosen={by} choose={setChosen} />
        <button type="button" class="button button-small" aria-pressed={isMeasuring} onClick={() => setMeasuring(!isMeasuring)}>
          {t('path_measure.measure')}
        </button>
        {isMeasuring && (
          <button type="button" class="button button-small" onClick={() => scene.current?.measureTool()}>
            {t('path_measure.tool')}
          </button>
        )}
      </div>
      {stock && <StockTools stock={stock} look={look} extent={extent} change={setLook} />}
      <div class="path-box">
        {/* Keys move the picture; what it shows stands in words below. */}
        <div ref={parts.host} class="path-host" role="application" tabIndex={0} aria-label={t('path.picture')} aria-describedby="path-keys" onKeyDown={press} />
        <div ref={parts.labels} class="path-labels" aria-hidden="true">
          {[0, 1, 2].map((axis) => (
            <span key={axis}>{axisName(path, axis)}</span>
          ))}
        </div>
        <p ref={parts.detail} class="path-detail" aria-hidden="true" />
        <div class="path-scale" aria-hidden="true">
          <div ref={parts.bar} class="path-scale-bar" />
          {scale > 0 && (scale < 1 ? `${mm(scale)} mm` : lengthText(scale))}
        </div>
      </div>
      {isMeasuring && <MeasureText path={path} spots={spots} />}
      {stock && look.compares && stock.nominal.length > 0 && <StockLegend stock={stock} />}
      <Legend data={data} by={by} />
      <p id="path-keys" class="hint">
        {t('path.keys')}
      </p>
    </>
  );
}

interface SegmentsProps<Name extends string> {
  label: string;
  names: readonly Name[];
  text: (name: Name) => string;
  chosen?: Name; // without it they are no choice, but acts
  choose: (name: Name) => void;
}

const Segments = <Name extends string>({ label, names, text, chosen, choose }: SegmentsProps<Name>) => (
  <div class="segments" role="group" aria-label={label}>
    {names.map((one) => (
      <button key={one} type="button" aria-pressed={chosen === undefined ? undefined : one === chosen} onClick={() => choose(one)}>
        {text(one)}
      </button>
    ))}
  </div>
);

type Extent = (axis: number) => readonly [low: number, high: number];

// Along which a section may lie: of the stock where there is one.
function extentOf(data: PictureProps['data'], stock: Stock | null): Extent {
  const { low, high } = stock ? stockBounds(stock) : boundsOf(data);
  return (axis) => [low[axis] ?? 0, high[axis] ?? 0];
}

function sectionOf({ axis, share }: StockLook, extent: Extent): Section | null {
  if (axis === null) return null;
  const [low, high] = extent(axis);
  return { axis, at_mm: low + share * (high - low) };
}

const kTurn = Math.PI / 24;
const kMove = 0.08;
const kZoom = 1.25;

type Keys = Record<string, (scene: PathScene) => void>;
const kKeys: Keys = {
  ArrowLeft: (scene) => scene.turn(-kTurn, 0),
  ArrowRight: (scene) => scene.turn(kTurn, 0),
  ArrowUp: (scene) => scene.turn(0, kTurn),
  ArrowDown: (scene) => scene.turn(0, -kTurn),
  '+': (scene) => scene.zoom(kZoom),
  '-': (scene) => scene.zoom(1 / kZoom),
};
const kShiftKeys: Keys = {
  ArrowLeft: (scene) => scene.move(-kMove, 0),
  ArrowRight: (scene) => scene.move(kMove, 0),
  ArrowUp: (scene) => scene.move(0, kMove),
  ArrowDown: (scene) => scene.move(0, -kMove),
};

// Whether the key means something here.
function pressedIn(scene: PathScene | null, views: readonly ViewName[], event: KeyboardEvent): boolean {
  if (!scene) return false;
  const view = views[Number(event.key) - 1];
  const action = (event.shiftKey && kShiftKeys[event.key]) || kKeys[event.key];
  if (view) scene.look(view);
  else if (action) action(scene);
  return Boolean(view ?? action);
}
