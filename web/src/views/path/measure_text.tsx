// What two places of the picture are apart. X of a lathe is shown as the program writes it: as a diameter.
import type { ToolPath } from '../../api/types';
import { t } from '../../i18n/i18n';
import type { Spot } from '../../path/measure';
import { axisFactor, axisName, mm } from './words';

const spotText = (path: ToolPath, spot: Spot): string => spot.map((value, axis) => `${axisName(path, axis)} ${mm(axisFactor(path, axis) * value)}`).join('  ');

export function MeasureText({ path, spots }: { path: ToolPath; spots: readonly Spot[] }) {
  return (
    <p class="path-place" role="status">
      {textOf(path, spots)}
    </p>
  );
}

function textOf(path: ToolPath, [first, second]: readonly Spot[]): string {
  if (!first) return t('path_measure.first');
  if (!second) return t('path_measure.second', { place: spotText(path, first) });
  const by = second.map((value, axis) => value - (first[axis] ?? 0)) as unknown as Spot;
  return t('path_measure.distance', { distance: mm(Math.hypot(...by)), by: spotText(path, by) });
}
