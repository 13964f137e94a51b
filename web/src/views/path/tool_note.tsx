// Which tool moves, and what of it is drawn: what is in no profile is not drawn, and that is stated.
import type { ToolPath } from '../../api/types';
import { t } from '../../i18n/i18n';
import { insertSides, isDrawn, kDiametersShown, type ToolShape } from '../../path/tool_shape';
import { isLathe, mm } from './words';

// Of path.tools; 0: none is taken.
export function toolAt({ tool_changes }: Pick<ToolPath, 'tool_changes'>, point: number): number {
  let low = 0;
  let high = tool_changes.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((tool_changes[middle]?.point ?? 0) <= point) low = middle + 1;
    else high = middle;
  }
  return tool_changes[low - 1]?.tool ?? 0;
}

export function shapeOf(path: ToolPath, tool: number): ToolShape | null {
  const shape = path.tools[tool]?.shape;
  return shape ? { ...shape, isLathe: isLathe(path) } : null;
}

export function ToolNote({ path, tool }: { path: ToolPath; tool: number }) {
  const name = path.tools[tool]?.tool;
  return <p class="path-tool hint">{name ? textOf(name, shapeOf(path, tool)) : t('path_tool.none')}</p>;
}

function textOf(tool: string, shape: ToolShape | null): string {
  if (!shape || !isDrawn(shape)) return t('path_tool.unknown', { tool });
  if (shape.isLathe) return t(insertSides(shape).length > 0 ? 'path_tool.insert' : 'path_tool.nose', { tool, radius: mm(shape.nose_radius_mm) });
  const diameter = mm(shape.diameter_mm ?? 0);
  const holder = holderText(shape);
  if (shape.length_mm !== null) return `${t('path_tool.mill', { tool, diameter, length: mm(shape.length_mm) })} ${holder}`;
  if (shape.holder.length > 0) return `${t('path_tool.mill_above', { tool, diameter })} ${holder}`;
  return `${t('path_tool.mill_no_length', { tool, diameter, count: kDiametersShown })} ${holder}`;
}

function holderText({ holder }: ToolShape): string {
  const [lowest] = holder;
  return lowest ? t('path_tool.holder', { from: mm(lowest.from_mm), diameter: mm(Math.max(...holder.map(({ diameter_mm }) => diameter_mm))) }) : t('path_tool.no_holder');
}
