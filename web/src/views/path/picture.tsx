// The picture of a path with its buttons, keys and legend. Loaded when a path is shown first.
import { useEffect, useRef, useState } from 'preact/hooks';
import { t } from '../../i18n/i18n';
import { feedRanges } from '../../path/data';
import { openScene, type PathScene, type ViewName } from '../../path/scene';
import type { Colors } from '../../path/look';
import type { PictureProps } from './path_view';
import { axisName, feedUnit, isLathe, lengthText, mm } from './words';

const kMillViews: readonly ViewName[] = ['top', 'front', 'side', 'iso'];
const kLatheViews: readonly ViewName[] = ['turning', 'top', 'side', 'iso'];

const kKindTokens = ['--path-cut', '--path-rapid', '--path-cut', '--path-cut', '--path-cut', '--path-thread'];

function colorsNow(): Colors {
  const style = getComputedStyle(document.documentElement);
  const token = (name: string) => style.getPropertyValue(name).trim();
  return {
    ground: token('--card'),
    kinds: kKindTokens.map(token),
    slow: token('--path-slow'),
    fast: token('--path-fast'),
    mark: token('--path-mark'),
    axis: token('--line-strong'),
  };
}

export function Picture(props: PictureProps) {
  const { path, data, at, line } = props;
  const host = useRef<HTMLDivElement>(null);
  const labels = useRef<HTMLDivElement>(null);
  const bar = useRef<HTMLDivElement>(null);
  const scene = useRef<PathScene | null>(null);
  const latest = useRef(props);
  latest.current = props;
  const [scale, setScale] = useState(0);
  const [byFeed, setByFeed] = useState(false);
  const [failed, setFailed] = useState(false);
  const lathe = isLathe(path);
  const views = lathe ? kLatheViews : kMillViews;
  useEffect(() => {
    const [x, y, z] = labels.current?.children ?? [];
    if (!host.current || !bar.current || !x || !y || !z) return;
    try {
      scene.current = openScene({
        host: host.current,
        axisLabels: [x as HTMLElement, y as HTMLElement, z as HTMLElement],
        scaleBar: bar.current,
        scaled: setScale,
        picked: (point) => latest.current.picked(point),
      });
    } catch {
      return setFailed(true); // this browser draws no 3D
    }
    const recolor = () => scene.current?.color(colorsNow());
    recolor();
    const dark = matchMedia('(prefers-color-scheme: dark)');
    dark.addEventListener('change', recolor);
    return () => {
      dark.removeEventListener('change', recolor);
      scene.current?.close();
      scene.current = null;
    };
  }, []);
  useEffect(() => scene.current?.show(data, lathe), [data, lathe]);
  useEffect(() => scene.current?.colorByFeed(byFeed), [byFeed, data]);
  useEffect(() => scene.current?.place(at), [at, data]);
  useEffect(() => scene.current?.mark(line), [line, data]);
  if (failed) return <p class="notice tone-waiting">{t('path.no_webgl')}</p>;
  const press = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !pressedIn(scene.current, views, event)) return;
    event.preventDefault();
  };
  return (
    <>
      <div class="path-tools">
        <div class="segments" role="group" aria-label={t('path.views')}>
          {views.map((view) => (
            <button key={view} type="button" onClick={() => scene.current?.look(view)}>
              {t(`path_view.${view}`)}
            </button>
          ))}
        </div>
        <div class="segments" role="group" aria-label={t('path.color')}>
          {[false, true].map((feed) => (
            <button key={String(feed)} type="button" aria-pressed={feed === byFeed} onClick={() => setByFeed(feed)}>
              {t(feed ? 'path.by_feed' : 'path.by_kind')}
            </button>
          ))}
        </div>
      </div>
      <div class="path-box">
        {/* Keys move the picture; what it shows stands in words below. */}
        <div ref={host} class="path-host" role="application" tabIndex={0} aria-label={t('path.picture')} aria-describedby="path-keys" onKeyDown={press} />
        <div ref={labels} class="path-labels" aria-hidden="true">
          {[0, 1, 2].map((axis) => (
            <span key={axis}>{axisName(path, axis)}</span>
          ))}
        </div>
        <div class="path-scale" aria-hidden="true">
          <div ref={bar} class="path-scale-bar" />
          {scale > 0 && (scale < 1 ? `${mm(scale)} mm` : lengthText(scale))}
        </div>
      </div>
      <Legend data={data} byFeed={byFeed} />
      <p id="path-keys" class="hint">
        {t('path.keys')}
      </p>
    </>
  );
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

function Legend({ data, byFeed }: { data: PictureProps['data']; byFeed: boolean }) {
  const ranges = feedRanges(data);
  const has = (name: string) => data.kinds.includes(data.kindNames.indexOf(name));
  return (
    <ul class="path-legend" aria-label={t('path.legend')}>
      {has('rapid') && (
        <li>
          <span class="path-line path-line-rapid" /> {t('path_kind.rapid')}
        </li>
      )}
      {!byFeed && (
        <li>
          <span class="path-line path-line-cut" /> {t('path_kind.cut')}
        </li>
      )}
      {!byFeed && has('thread') && (
        <li>
          <span class="path-line path-line-thread" /> {t('path_kind.thread')}
        </li>
      )}
      {byFeed &&
        [...ranges].map(([kind, [low, high]]) => (
          <li key={kind}>
            {low < high && mm(low)} <span class={low < high ? 'path-ramp' : 'path-line path-line-fast'} /> {mm(high)} {feedUnit(data.kindNames[kind] ?? '')}
          </li>
        ))}
    </ul>
  );
}
