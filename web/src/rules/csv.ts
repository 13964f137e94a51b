// Rows as CSV (RFC 4180), for a spreadsheet: a first row of heads, UTF-8 with its mark. A text that a spreadsheet would
// take for a formula begins with an apostrophe.
export interface CsvColumn<Row> {
  head: string;
  of: (row: Row) => string | number | null;
}

const kFormula = /^[=+\-@\t\r]/;

function cell(value: string | number | null): string {
  if (value === null) return '';
  if (typeof value === 'number') return String(value);
  const text = kFormula.test(value) ? `'${value}` : value;
  return /[",\r\n;]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
}

export function csvOf<Row>(columns: readonly CsvColumn<Row>[], rows: readonly Row[]): string {
  const lines = [columns.map(({ head }) => cell(head)), ...rows.map((row) => columns.map(({ of }) => cell(of(row))))];
  return `\uFEFF${lines.map((line) => `${line.join(',')}\r\n`).join('')}`;
}

// "2026-11-26T06:12:00Z"; null: it has not happened.
export const isoTime = (ms: number | null): string | null => (ms === null ? null : new Date(ms).toISOString().replace(/\.\d+Z$/, 'Z'));
