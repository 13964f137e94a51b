// What a list shows, as a file for a spreadsheet.
import { t } from '../i18n/i18n';
import { csvOf, type CsvColumn } from '../rules/csv';

interface Props<Row> {
  name: string; // of the file, without its ending
  columns: readonly CsvColumn<Row>[];
  rows: readonly Row[];
}

export const CsvButton = <Row,>({ name, columns, rows }: Props<Row>) => (
  <button type="button" class="button" aria-disabled={rows.length === 0} onClick={() => rows.length > 0 && save(`${name}.csv`, csvOf(columns, rows))}>
    {t('list.csv')}
  </button>
);

function save(name: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type: 'text/csv;charset=utf-8' }));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
