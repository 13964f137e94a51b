// What stands in the picture beside the path: the axes at the program's zero, the line that is looked at, the tool.
import { BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments, Points, PointsMaterial } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Colors } from './look';

export interface Marks {
  axes: LineSegments<BufferGeometry, LineBasicMaterial>;
  line: LineSegments2;
  tool: Points<BufferGeometry, PointsMaterial>;
}

const kTool_px = 11;
const kLine_px = 4;

// One millimeter long each.
export function axisLines(): Marks['axes'] {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1]), 3));
  const lines = new LineSegments(geometry, new LineBasicMaterial({ depthTest: false }));
  lines.frustumCulled = false;
  lines.renderOrder = 1;
  return lines;
}

// Ends of segments in pairs, three numbers each.
export function markedLines(ends: readonly number[] = [0, 0, 0, 0, 0, 0]): LineSegments2 {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions([...ends]);
  const lines = new LineSegments2(geometry, new LineMaterial({ linewidth: kLine_px, depthTest: false }));
  lines.frustumCulled = false;
  lines.renderOrder = 2;
  return lines;
}

export function toolMark(): Marks['tool'] {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(3), 3));
  const mark = new Points(geometry, new PointsMaterial({ size: kTool_px * Math.min(devicePixelRatio, 2), sizeAttenuation: false, depthTest: false }));
  mark.frustumCulled = false;
  mark.renderOrder = 3;
  return mark;
}

export function colorMarks(marks: Marks, colors: Colors): void {
  marks.axes.material.color = new Color(colors.axis);
  marks.line.material.color = new Color(colors.mark);
  marks.tool.material.color = new Color(colors.mark);
}
