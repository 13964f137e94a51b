// The part as the values make it, with the parameters as dimensions: what the server draws of the family. A parameter and
// its dimension light each other; a click on a dimension goes to its field.
import { useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { t } from '../../i18n/i18n';
import { pathOf, pictureOf, textOf, type View } from '../../rules/drawing';

interface Props {
  views: readonly View[];
  lit: string | null; // a parameter
  light: (parameter: string | null) => void;
  chosen: (parameter: string) => void;
}

export function Drawing({ views, lit, light, chosen }: Props) {
  const frame = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(0);
  useLayoutEffect(() => {
    const { current } = frame;
    if (!current) return;
    const watch = new ResizeObserver(([entry]) => entry && setWidth(Math.floor(entry.contentRect.width)));
    watch.observe(current);
    return () => watch.disconnect();
  }, []);
  if (views.length === 0) return null;
  return (
    <div ref={frame} class="drawing">
      {width > 0 && views.map((view) => <ViewOf key={view.axes} view={view} width={width} lit={lit} light={light} chosen={chosen} />)}
    </div>
  );
}

// Attributes, because the page's first style sheet is the one of all views.
const kLooks: Record<string, Record<string, string>> = {
  stock: { stroke: 'var(--line-strong)', 'stroke-width': '1', 'stroke-dasharray': '7 4' },
  nominal: { stroke: 'var(--accent)', 'stroke-width': '1.8' },
  outline: { stroke: 'var(--ink)', 'stroke-width': '1.4' },
};
const kText = { 'font-family': 'var(--mono)', 'font-size': '12', 'text-anchor': 'middle', 'dominant-baseline': 'central', 'paint-order': 'stroke', stroke: 'var(--card)', 'stroke-width': '4' } as const;
const kPointer = { cursor: 'pointer' } as const;

function ViewOf({ view, width, lit, light, chosen }: { view: View; width: number } & Omit<Props, 'views'>) {
  const picture = useMemo(() => pictureOf(view, width), [view, width]);
  const [across = '', up = ''] = view.axes;
  const name = t('drawing.view', { across, up });
  return (
    <figure>
      <svg
        viewBox={`0 0 ${picture.width} ${picture.height.toFixed(0)}`}
        width={picture.width}
        height={picture.height.toFixed(0)}
        role="img"
        aria-label={`${name}: ${view.dimensions.map(textOf).join(', ')}`}
      >
        {picture.lines.map(({ of, d }, index) => (
          <path key={index} fill="none" {...kLooks[of]} d={d} />
        ))}
        {picture.circles.map(({ of, at, radius }, index) => (
          <circle key={index} fill="none" {...kLooks[of]} cx={at[0]} cy={at[1]} r={radius} />
        ))}
        {picture.dimensions.map(({ parameter, text, lines, arrows, at, turned }) => {
          const isLit = parameter === lit;
          const color = isLit ? 'var(--accent)' : 'var(--ink-quiet)';
          return (
          <g
            key={parameter}
            {...kPointer}
            data-dimension={parameter}
            data-lit={isLit}
            fill={color}
            onPointerEnter={() => light(parameter)}
            onPointerLeave={() => light(null)}
            onClick={() => chosen(parameter)}
          >
            <path fill="none" stroke={color} stroke-width={isLit ? 2 : 1} d={lines.map(pathOf).join('')} />
            <path d={arrows.map((one) => `${pathOf(one)}Z`).join('')} />
            <text {...kText} font-weight={isLit ? 700 : 400} x={at[0].toFixed(1)} y={at[1].toFixed(1)} transform={turned ? `rotate(-90 ${at[0].toFixed(1)} ${at[1].toFixed(1)})` : undefined}>
              {text}
            </text>
          </g>
          );
        })}
      </svg>
      <figcaption class="hint">{name}</figcaption>
    </figure>
  );
}
