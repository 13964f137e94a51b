// The scene of a picture with the elements that it draws on. It lives as long as the picture.
import type { RefObject } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { count } from '../../format/numbers';
import { t } from '../../i18n/i18n';
import type { Colors } from '../../path/look';
import type { Spot } from '../../path/measure';
import { openScene, type PathScene } from '../../path/scene';
import type { PictureProps } from './path_view';
import { isLathe } from './words';

const kKindTokens = ['--path-cut', '--path-rapid', '--path-cut', '--path-cut', '--path-cut', '--path-thread'];

function colorsNow(): Colors {
  const style = getComputedStyle(document.documentElement);
  const token = (name: string) => style.getPropertyValue(name).trim();
  return {
    ground: token('--card'),
    kinds: kKindTokens.map(token),
    slow: token('--path-slow'),
    fast: token('--path-fast'),
    under: token('--path-under'),
    even: token('--path-even'),
    over: token('--path-over'),
    unknown: token('--line-strong'),
    tool: token('--path-tool'),
    stock: token('--path-stock'),
    inside: token('--path-inside'),
    measure: token('--ink'),
    mark: token('--path-mark'),
    axis: token('--line-strong'),
  };
}

interface Parts {
  host: RefObject<HTMLDivElement | null>;
  labels: RefObject<HTMLDivElement | null>;
  bar: RefObject<HTMLDivElement | null>;
  detail: RefObject<HTMLParagraphElement | null>;
}

export interface UsedScene {
  scene: RefObject<PathScene | null>;
  parts: Parts;
  scale: number; // of the bar, mm
  spots: readonly Spot[]; // measured
  failed: boolean; // this browser draws no 3D
}

export function useScene(props: PictureProps): UsedScene {
  const { path, data } = props;
  const parts: Parts = { host: useRef(null), labels: useRef(null), bar: useRef(null), detail: useRef(null) };
  const scene = useRef<PathScene | null>(null);
  const latest = useRef(props);
  latest.current = props;
  const [scale, setScale] = useState(0);
  const [spots, setSpots] = useState<readonly Spot[]>([]);
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    const [x, y, z] = parts.labels.current?.children ?? [];
    const [host, scaleBar] = [parts.host.current, parts.bar.current];
    if (!host || !scaleBar || !x || !y || !z) return;
    try {
      scene.current = openScene({
        host,
        axisLabels: [x as HTMLElement, y as HTMLElement, z as HTMLElement],
        scaleBar,
        scaled: setScale,
        picked: (point) => latest.current.picked(point),
        measured: setSpots,
        // Each frame: an element, no state.
        drew: (segments, all) => {
          const text = segments < all ? t('path.detail', { shown: count(segments), all: count(all) }) : '';
          const { current } = parts.detail;
          if (current && current.textContent !== text) current.textContent = text;
        },
      });
    } catch {
      return setFailed(true);
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
  useEffect(() => scene.current?.show(data, isLathe(path)), [data]);
  return { scene, parts, scale, spots, failed };
}
