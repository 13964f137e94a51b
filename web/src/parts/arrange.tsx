// The parts of a view in a person's own arrangement, which the browser keeps, and the list by which it is changed.
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { t } from '../i18n/i18n';
import { arranged, moved, toggled, type Arrangement, type PartOfView } from '../rules/arrangement';
import { keepAs, keptAs } from '../state/kept';
import { Icon } from './icon';

export interface DrawnPart extends PartOfView {
  title: string;
  draw: () => ComponentChildren;
}

const keptName = (name: string): string => `arrangement.${name}`;

interface Props {
  name: string; // under which the arrangement is kept
  class: string;
  parts: readonly DrawnPart[];
  isBound: boolean; // nothing is rearranged here
}

export function Arranged({ name, class: look, parts, isBound }: Props) {
  const [wish, setWish] = useState(() => keptAs(keptName(name)));
  const now = arranged(parts, wish);
  const set = (next: Arrangement | null) => {
    setWish(next);
    keepAs(keptName(name), next);
  };
  const partOf = (id: string) => parts.find((part) => part.id === id);
  return (
    <>
      <div class={look}>
        {now.columns.map((ids, column) => (
          <div key={column}>{ids.map((id) => !now.hidden.includes(id) && <div key={id} class="part" data-part={id}>{partOf(id)?.draw()}</div>)}</div>
        ))}
      </div>
      {!isBound && <ArrangeList parts={parts} now={now} set={set} />}
    </>
  );
}

function ArrangeList({ parts, now, set }: { parts: readonly DrawnPart[]; now: Arrangement; set: (next: Arrangement | null) => void }) {
  return (
    <details class="arrange">
      <summary>{t('arrange.title')}</summary>
      <p class="hint">{t('arrange.hint')}</p>
      <div class="arrange-columns">
        {now.columns.map((ids, column) => (
          <ol key={column} aria-label={t(column === 0 ? 'arrange.left' : 'arrange.right')}>
            {ids.map((id) => {
              const part = parts.find((one) => one.id === id);
              return part && <ArrangeRow key={id} part={part} isHidden={now.hidden.includes(id)} move={(how) => set(moved(now, id, how))} toggle={() => set(toggled(now, id))} />;
            })}
          </ol>
        ))}
      </div>
      <button type="button" class="button button-small" onClick={() => set(null)}>
        {t('arrange.reset')}
      </button>
    </details>
  );
}

interface RowProps {
  part: DrawnPart;
  isHidden: boolean;
  move: (how: 'up' | 'down' | 'across') => void;
  toggle: () => void;
}

const ArrangeRow = ({ part, isHidden, move, toggle }: RowProps) => (
  <li>
    <label class="choice">
      <input type="checkbox" checked={!isHidden} disabled={part.isFixed} onChange={toggle} />
      {part.title}
    </label>
    <span class="queue-buttons">
      <button type="button" class="button button-small" onClick={() => move('up')} aria-label={t('arrange.up', { part: part.title })}>
        <Icon shape="up" />
      </button>
      <button type="button" class="button button-small" onClick={() => move('down')} aria-label={t('arrange.down', { part: part.title })}>
        <Icon shape="down" />
      </button>
      <button type="button" class="button button-small" onClick={() => move('across')}>
        {t('arrange.across')} <span class="unseen">{part.title}</span>
      </button>
    </span>
  </li>
);
