// The one table of the page: columns as data, so that heads, cells and the labels of a narrow screen agree. Columns that
// say what they are sorted by have a button in their head; on a narrow screen, where there are no heads, a field. A table
// with a name lets a person choose its columns, and the browser keeps the choice.
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { t } from '../i18n/i18n';
import { sorted, type Order } from '../rules/sorting';
import { ColumnChoice, useColumns } from './columns';
import { Icon } from './icon';

export interface Column<Row> {
  id: string;
  head: string;
  cell: (row: Row) => ComponentChildren;
  class?: string;
  by?: (row: Row) => string | number | null; // rows may be sorted by it
  isExtra?: boolean; // shown when a person asks for it
  isFixed?: boolean; // shown always
}

interface Props<Row> {
  label: string;
  columns: readonly (Column<Row> | false)[];
  rows: readonly Row[];
  keyOf: (row: Row) => string | number;
  marks?: (row: Row) => Record<string, string>; // data attributes of a row
  numbers?: boolean;
  name?: string; // under which the choice of columns is kept
}

export function Table<Row>({ label, columns, rows, keyOf, marks, numbers = false, name }: Props<Row>) {
  const offered = columns.filter((column) => column !== false);
  const [shown, choose] = useColumns(name, offered);
  const [order, setOrder] = useState<Order | null>(null); // null: as they come
  const by = shown.find(({ id }) => id === order?.id)?.by;
  const press = (id: string) => setOrder((before) => (before?.id !== id ? { id, down: false } : before.down ? null : { id, down: true }));
  return (
    <>
      {name && <ColumnChoice columns={offered} shown={shown} choose={choose} />}
      <SortField columns={shown} order={order} set={setOrder} />
      <table class={numbers ? 'table table-numbers' : 'table'} aria-label={label}>
        <thead>
          <tr>
            {shown.map((column) => (
              <th key={column.id} scope="col" aria-sort={order?.id === column.id ? (order.down ? 'descending' : 'ascending') : undefined}>
                {column.by ? (
                  <button type="button" class="sort" onClick={() => press(column.id)}>
                    {column.head} {order?.id === column.id && <Icon shape={order.down ? 'down' : 'up'} />}
                  </button>
                ) : (
                  column.head
                )}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {(by && order ? sorted(rows, by, order.down) : rows).map((row) => (
            <tr key={keyOf(row)} {...marks?.(row)}>
              {shown.map((column) => (
                <td key={column.id} data-label={column.head} class={column.class}>
                  {column.cell(row)}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </>
  );
}

interface SortProps<Row> {
  columns: readonly Column<Row>[];
  order: Order | null;
  set: (order: Order | null) => void;
}

function SortField<Row>({ columns, order, set }: SortProps<Row>) {
  const sortable = columns.filter(({ by }) => by !== undefined);
  if (sortable.length === 0) return null;
  return (
    <label class="choice sort-field">
      <span>{t('list.sort')}</span>
      <select
        value={order ? `${order.id} ${order.down}` : ''}
        onChange={(event) => {
          const [id = '', down] = event.currentTarget.value.split(' ');
          set(id === '' ? null : { id, down: down === 'true' });
        }}
      >
        <option value="">{t('list.as_it_comes')}</option>
        {sortable.flatMap(({ id, head }) =>
          [false, true].map((down) => (
            <option key={`${id} ${down}`} value={`${id} ${down}`}>
              {t(down ? 'list.down' : 'list.up', { column: head })}
            </option>
          )),
        )}
      </select>
    </label>
  );
}
