// Which columns of a table a person wants to see: kept in the browser, by the table's name.
import { useState } from 'preact/hooks';
import { t } from '../i18n/i18n';
import { keepAs, keptAs } from '../state/kept';

interface Choosable {
  id: string;
  head: string;
  isExtra?: boolean;
  isFixed?: boolean;
}
type Chosen = Record<string, boolean>; // by the id of a column; without a row: as the table has it

const keptName = (name: string): string => `columns.${name}`;

function chosenBefore(name: string | undefined): Chosen {
  const kept = name === undefined ? null : keptAs(keptName(name));
  return Object.fromEntries(Object.entries(kept ?? {}).filter((one): one is [string, boolean] => typeof one[1] === 'boolean'));
}

export function useColumns<Column extends Choosable>(name: string | undefined, columns: readonly Column[]): [Column[], (id: string, isShown: boolean) => void] {
  const [chosen, setChosen] = useState(() => chosenBefore(name));
  const choose = (id: string, isShown: boolean) => {
    const now = { ...chosen, [id]: isShown };
    setChosen(now);
    if (name !== undefined) keepAs(keptName(name), now);
  };
  return [columns.filter(({ id, isExtra, isFixed }) => isFixed || (chosen[id] ?? !isExtra)), choose];
}

interface Props {
  columns: readonly Choosable[];
  shown: readonly Choosable[];
  choose: (id: string, isShown: boolean) => void;
}

export const ColumnChoice = ({ columns, shown, choose }: Props) => (
  <details class="column-choice">
    <summary>{t('list.columns')}</summary>
    {columns.map(
      ({ id, head, isFixed }) =>
        !isFixed && (
          <label key={id} class="choice">
            <input type="checkbox" checked={shown.some((one) => one.id === id)} onChange={(event) => choose(id, event.currentTarget.checked)} />
            {head}
          </label>
        ),
    )}
  </details>
);
