// A path in words and figures: for who does not see the picture, and for everybody with it.
import type { ToolPath } from '../../api/types';
import { count } from '../../format/numbers';
import { duration } from '../../format/times';
import { t } from '../../i18n/i18n';
import { Facts, type Fact } from '../../parts/facts';
import { axesOf, axisFactor, axisName, lengthText, mm } from './words';

export type Extents = Pick<ToolPath, 'low_mm' | 'high_mm' | 'x_is_diameter'>;

export const extentText = (path: Extents, axis: number): string => {
  const [low = '', high = ''] = [path.low_mm, path.high_mm].map((bound) => mm(axisFactor(path, axis) * (bound[axis] ?? 0)));
  return t('path.extent', { low, high });
};

export function PathFacts({ path }: { path: ToolPath }) {
  const extents: Fact[] = axesOf(path).map((axis) => [axisName(path, axis), extentText(path, axis)]);
  return (
    <div class="path-facts">
      <Facts
        facts={[
          ...extents,
          [t('path.cut_length'), lengthText(path.cut_mm)],
          [t('path.rapid_length'), lengthText(path.rapid_mm)],
          [t('path.segments'), count(path.segments)],
          ...(path.time ? [[t('path.cycle'), duration(path.time.cycle_s)] satisfies Fact] : []),
        ]}
      />
    </div>
  );
}
