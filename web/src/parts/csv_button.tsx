// What a list shows, as a file for a spreadsheet.
import { t } from '../i18n/i18n';
import { csvOf, type CsvColumn } from '../rules/csv';
import { saveFile } from './save_file';

interface Props<Row> {
  name: string; // of the file, without its ending
  columns: readonly CsvColumn<Row>[];
  rows: readonly Row[];
}

export const CsvButton = <Row,>({ name, columns, rows }: Props<Row>) => (
  <button type="button" class="button" aria-disabled={rows.length === 0} onClick={() => rows.length > 0 && saveFile(`${name}.csv`, 'text/csv;charset=utf-8', csvOf(columns, rows))}>
    {t('list.csv')}
  </button>
);
