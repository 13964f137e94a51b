// Places and lengths of a path in words. X of a lathe is shown as the program writes it: as a diameter.
import type { ToolPath } from '../../api/types';
import { count } from '../../format/numbers';
import { t } from '../../i18n/i18n';
import { at, kBegin, kRapid, type PathData } from '../../path/data';

export const kAxes = ['X', 'Y', 'Z'] as const;

export const isLathe = (path: Pick<ToolPath, 'control'>): boolean => path.control.kind !== 'mill';

// At most three decimals, no more than are there.
export const mm = (value: number): string => String(Number(value.toFixed(3)));

export const axisName = (path: Pick<ToolPath, 'x_is_diameter'>, axis: number): string => `${kAxes[axis]}${axis === 0 && path.x_is_diameter ? ' ⌀' : ''}`;

export const axisFactor = (path: Pick<ToolPath, 'x_is_diameter'>, axis: number): number => (axis === 0 && path.x_is_diameter ? 2 : 1);

// An axis along which the path has no extent and that stands at 0 is not spoken of.
export const axesOf = (path: Pick<ToolPath, 'low_mm' | 'high_mm'>): number[] => [0, 1, 2].filter((axis) => path.low_mm[axis] !== 0 || path.high_mm[axis] !== 0);

export const lengthText = (length_mm: number): string => (length_mm >= 10_000 ? `${count(length_mm / 1000)} m` : `${count(length_mm)} mm`);

const kFeedUnits: Record<string, string> = { cut_per_min: 'mm/min', cut_per_rev: 'mm/rev', cut_inverse_time: '1/min', thread: 'mm/rev' };

export const feedUnit = (kindName: string): string => kFeedUnits[kindName] ?? '';

// "Line 12: cut, X ⌀ 80 Z −12.5 mm, 0.2 mm/rev".
export function placeText(path: ToolPath, data: PathData, point: number): string {
  const kind = data.kinds[point] ?? kBegin;
  const name = data.kindNames[kind] ?? 'begin';
  const place = axesOf(path)
    .map((axis) => `${axisName(path, axis)} ${mm(axisFactor(path, axis) * at(data.points, 3 * point + axis))}`)
    .join('  ');
  const line = data.lines[point] ?? 0;
  const where = line > 0 ? t('fault.line', { line }) : t('path.called');
  const feed = data.feeds[point] ?? 0;
  const how = kind > kRapid && feed > 0 ? `, ${mm(feed)} ${feedUnit(name)}` : '';
  return `${where}: ${t(`path_kind.${name}`)}, ${place} mm${how}`;
}
