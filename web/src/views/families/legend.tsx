// What the variables of a macro mean: whoever stands at the control reads the same numbers there.
import type { LegendEntry } from '../../api/types';
import { t } from '../../i18n/i18n';

// None: the program is plain blocks.
export function Legend({ rows }: { rows: readonly LegendEntry[] }) {
  if (rows.length === 0) return null;
  return (
    <details class="judged">
      <summary>{t('legend.title', { count: rows.length })}</summary>
      <div class="profile-rows" role="region" aria-label={t('legend.label')} tabIndex={0}>
        <table>
          <thead>
            <tr>
              {(['variable', 'name', 'value', 'kind', 'meaning'] as const).map((head) => (
                <th key={head} scope="col">
                  {t(`legend.${head}`)}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row) => (
              <tr key={row.variable}>
                <td>
                  <code>{row.variable}</code> {row.count > 1 && t('legend.in_a_row', { count: row.count })}
                </td>
                <td>
                  <code>{row.name}</code>
                </td>
                <td>{row.value !== null && `${Number(row.value.toFixed(6))} ${row.unit ?? ''}`}</td>
                <td>{t(`legend_kind.${row.kind}`)}</td>
                <td>{row.meaning}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </details>
  );
}
