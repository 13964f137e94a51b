// A path in words and figures: for who does not see the picture, and for everybody beside it.
import type { ToolPath } from '../../api/types';
import { count } from '../../format/numbers';
import { t } from '../../i18n/i18n';
import { Facts, type Fact } from '../../parts/facts';
import { axesOf, axisFactor, axisName, lengthText, mm } from './words';

export function PathFacts({ path }: { path: ToolPath }) {
  const extents: Fact[] = axesOf(path).map((axis) => {
    const factor = axisFactor(path, axis);
    const [low, high] = [path.low_mm, path.high_mm].map((bound) => mm(factor * (bound[axis] ?? 0)));
    return [axisName(path, axis), t('path.extent', { low: low ?? '', high: high ?? '' })];
  });
  return (
    <div class="path-facts">
      <Facts
        facts={[
          ...extents,
          [t('path.cut_length'), lengthText(path.cut_mm)],
          [t('path.rapid_length'), lengthText(path.rapid_mm)],
          [t('path.segments'), count(path.segments)],
        ]}
      />
    </div>
  );
}
