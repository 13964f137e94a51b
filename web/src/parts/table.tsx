// The one table of the page: columns as data, so that heads, cells and the labels of a narrow screen agree.
import type { ComponentChildren } from 'preact';

export interface Column<Row> {
  id: string;
  head: string;
  cell: (row: Row) => ComponentChildren;
  class?: string;
}

interface Props<Row> {
  label: string;
  columns: readonly (Column<Row> | false)[];
  rows: readonly Row[];
  keyOf: (row: Row) => string | number;
  marks?: (row: Row) => Record<string, string>; // data attributes of a row
  numbers?: boolean;
}

export function Table<Row>({ label, columns, rows, keyOf, marks, numbers = false }: Props<Row>) {
  const shown = columns.filter((column) => column !== false);
  return (
    <table class={numbers ? 'table table-numbers' : 'table'} aria-label={label}>
      <thead>
        <tr>
          {shown.map((column) => (
            <th key={column.id} scope="col">
              {column.head}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => (
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
  );
}
