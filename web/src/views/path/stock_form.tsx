// A blank that a person states: of a lathe a bar, of a mill a box. What the path spans is proposed.
import { useState } from 'preact/hooks';
import type { ToolPath } from '../../api/types';
import { t } from '../../i18n/i18n';
import { isLathe } from './words';

type Extents = Pick<ToolPath, 'low_mm' | 'high_mm' | 'control'>;

const kBar = ['diameter', 'z_low', 'z_high'] as const;
const kBox = ['x_low', 'x_high', 'y_low', 'y_high', 'z_low', 'z_high'] as const;

// Numbers of a blank in the order of the fields.
export function proposedBlank(path: Extents): number[] {
  const [x = 0, y = 0, z = 0] = path.low_mm;
  const [xHigh = 0, yHigh = 0] = path.high_mm;
  const round = (value: number): number => Math.round(value * 100) / 100;
  if (isLathe(path)) return [2 * Math.max(xHigh, 1), z, Math.max(0, z + 1)].map(round);
  return [x, Math.max(xHigh, x + 1), y, Math.max(yHigh, y + 1), z, Math.max(0, z + 1)].map(round);
}

export const blankText = (path: Extents, numbers: readonly number[]): string => `${isLathe(path) ? 'cylinder' : 'box'} ${numbers.join(' ')}`;

export function StockForm({ path, state }: { path: Extents; state: (stock: string) => void }) {
  const [numbers, setNumbers] = useState(() => proposedBlank(path));
  const fields = isLathe(path) ? kBar : kBox;
  return (
    <form
      class="path-blank"
      onSubmit={(event) => {
        event.preventDefault();
        state(blankText(path, numbers));
      }}
    >
      {fields.map((name, i) => (
        <label key={name} class="field">
          <span>{t(`path_blank.${name}`)}</span>
          <input
            type="number"
            step="any"
            required
            value={numbers[i]}
            onInput={(event) => setNumbers(numbers.map((one, k) => (k === i ? Number(event.currentTarget.value) : one)))}
          />
        </label>
      ))}
      <button type="submit" class="button">
        {t('path_blank.state')}
      </button>
    </form>
  );
}
