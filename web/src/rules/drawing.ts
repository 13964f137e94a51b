// A family's drawing as lines of a picture: where each dimension stands so that it covers no other. Lengths along an axis
// stand outside of the part, the shorter ones nearer; the rest where the family's text has them.
import type { Preview } from '../api/types';

export type View = Preview['drawing'][number];
export type Dimension = View['dimensions'][number];
export type Point = readonly [number, number]; // pixels, y down

type Side = 'top' | 'bottom' | 'left' | 'right';

export interface PlacedDimension {
  parameter: string;
  text: string;
  lines: Point[][]; // the dimension's line and its extension lines
  arrows: Point[][]; // filled
  at: Point; // middle of the text
  turned: boolean; // the text reads upwards
}

export interface Picture {
  width: number;
  height: number;
  lines: { of: string; d: string }[];
  circles: { of: string; at: Point; radius: number }[];
  dimensions: PlacedDimension[];
}

const kLane = 24; // from a dimension's line to the next one
const kEdge = 12;
const kLetter = 7.3; // width of one, of 12 px
const kTextHeight = 15;
const kArrow = 7;
const kMost = 340; // height of the part
const kLeast = 90;
const kGap = 4; // between the part and an extension line

const kSigns: Record<Dimension['kind'], string> = { length: '', diameter: '⌀', radius: 'R', angle: '∠' };

export const textOf = ({ parameter, kind, value }: Pick<Dimension, 'parameter' | 'kind' | 'value'>): string => `${parameter} ${kSigns[kind]}${value}`;

const widthOf = (text: string): number => text.length * kLetter;

interface Box {
  low: [number, number];
  high: [number, number];
}

function boxOf(view: View): Box {
  const all: number[][] = [...view.lines.flatMap(({ points }) => points), ...view.dimensions.flatMap(({ from, to }) => [from, to])];
  for (const { center, diameter_mm } of view.circles)
    for (const side of [-0.5, 0.5]) all.push([(center[0] ?? 0) + side * diameter_mm, (center[1] ?? 0) + side * diameter_mm]);
  const along = (index: number, pick: (...values: number[]) => number) => all.reduce((found, point) => pick(found, point[index] ?? 0), all[0]?.[index] ?? 0);
  return { low: [along(0, Math.min), along(1, Math.min)], high: [along(0, Math.max), along(1, Math.max)] };
}

// Where a dimension's line is drawn outside; null: where it is.
function sideOf(view: View, dimension: Dimension, box: Box): Side | null {
  const { kind, from, to } = dimension;
  if (kind === 'angle' || kind === 'radius' || (kind === 'diameter' && view.axes === 'xy')) return null;
  const [across, up] = [Math.abs((to[0] ?? 0) - (from[0] ?? 0)), Math.abs((to[1] ?? 0) - (from[1] ?? 0))];
  const hair = 1e-6 * Math.max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  const middle = (index: 0 | 1) => ((from[index] ?? 0) + (to[index] ?? 0)) / 2 - (box.low[index] + box.high[index]) / 2;
  if (up <= hair) return middle(1) > hair ? 'top' : 'bottom';
  if (across <= hair) return middle(0) < -hair ? 'left' : 'right';
  return null;
}

interface Lane {
  dimension: Dimension;
  side: Side;
  lane: number;
}

// The shortest first: a longer one never crosses the extension lines of a shorter one that is nearer.
function lanesOf(view: View, box: Box, scale: number): Lane[] {
  const span = ({ from, to }: Dimension, index: number) => [Math.min(from[index] ?? 0, to[index] ?? 0), Math.max(from[index] ?? 0, to[index] ?? 0)] as const;
  const taken = new Map<Side, (readonly [number, number])[][]>();
  const found: Lane[] = [];
  const outside = view.dimensions.flatMap((dimension) => {
    const side = sideOf(view, dimension, box);
    return side === null ? [] : [{ dimension, side, index: side === 'top' || side === 'bottom' ? 0 : 1 }];
  });
  const length = ({ dimension, index }: (typeof outside)[number]) => span(dimension, index)[1] - span(dimension, index)[0];
  for (const one of outside.sort((a, b) => length(a) - length(b))) {
    const [low, high] = span(one.dimension, one.index);
    const half = Math.max(((high - low) * scale) / 2, widthOf(textOf(one.dimension)) / 2 + 6);
    const middle = ((low + high) / 2) * scale;
    const lanes = taken.get(one.side) ?? [];
    taken.set(one.side, lanes);
    const isFree = (lane: (readonly [number, number])[]) => lane.every(([from, to]) => middle + half <= from || middle - half >= to);
    const free = lanes.findIndex(isFree);
    const lane = free < 0 ? lanes.length : free;
    (lanes[lane] ??= []).push([middle - half, middle + half]);
    found.push({ dimension: one.dimension, side: one.side, lane });
  }
  return found;
}

function arrow(tip: Point, toward: Point): Point[] {
  const [dx, dy] = [toward[0] - tip[0], toward[1] - tip[1]];
  const length = Math.hypot(dx, dy) || 1;
  const [ux, uy] = [dx / length, dy / length];
  const foot: Point = [tip[0] + ux * kArrow, tip[1] + uy * kArrow];
  return [tip, [foot[0] - uy * 2.4, foot[1] + ux * 2.4], [foot[0] + uy * 2.4, foot[1] - ux * 2.4]];
}

// Outside of the line where there is no room within.
function arrows(from: Point, to: Point): { arrows: Point[][]; more: Point[][] } {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (length > 3 * kArrow) return { arrows: [arrow(from, to), arrow(to, from)], more: [] };
  const [ux, uy] = length > 0.01 ? [(to[0] - from[0]) / length, (to[1] - from[1]) / length] : [1, 0];
  const before: Point = [from[0] - ux * 2 * kArrow, from[1] - uy * 2 * kArrow];
  const after: Point = [to[0] + ux * 2 * kArrow, to[1] + uy * 2 * kArrow];
  return { arrows: [arrow(from, before), arrow(to, after)], more: [[before, from], [to, after]] };
}

const clamp = (value: number, low: number, high: number): number => Math.max(low, Math.min(value, Math.max(low, high)));

export function pictureOf(view: View, width: number): Picture {
  const box = boxOf(view);
  const [wide, high] = [Math.max(box.high[0] - box.low[0], 1e-3), Math.max(box.high[1] - box.low[1], 1e-3)];
  const most = Math.min(kMost, width * 0.8);
  let scale = Math.min((width - 4 * kLane) / wide, most / high);
  let lanes: Lane[] = [];
  const depth = (side: Side) => kEdge + kLane * Math.max(0, ...lanes.filter((one) => one.side === side).map(({ lane }) => lane + 1));
  // Lanes need room, which makes the part smaller, which may need more lanes.
  for (let round = 0; round < 3; ++round) {
    lanes = lanesOf(view, box, scale);
    scale = Math.max(Math.min((width - depth('left') - depth('right')) / wide, most / high), 20 / wide);
  }
  // A text that is read upwards has its room, too.
  const upwards = lanes.filter(({ side }) => side === 'left' || side === 'right').map(({ dimension }) => widthOf(textOf(dimension)) + kTextHeight);
  const tall = Math.max(high * scale, kLeast, ...upwards);
  const left = depth('left') + (width - depth('left') - depth('right') - wide * scale) / 2;
  const top = depth('top') + (tall - high * scale) / 2;
  const height = depth('top') + tall + depth('bottom');
  const at = (point: readonly number[]): Point => [left + ((point[0] ?? 0) - box.low[0]) * scale, top + (box.high[1] - (point[1] ?? 0)) * scale];
  const edge: Record<Side, number> = { left, right: left + wide * scale, top, bottom: top + high * scale };
  const covered: Covered[] = [];
  // Where two sides meet, a level text moves aside along its own line: it has more room.
  const isUpwards = ({ side }: Lane) => side === 'left' || side === 'right';
  const placed: PlacedDimension[] = [...lanes.filter(isUpwards), ...lanes.filter((one) => !isUpwards(one))].map((one) => {
    const wished = outside(one, at, edge, width, height);
    const half = widthOf(wished.text) / 2;
    return { ...wished, at: free(wished.at, half, height, covered, wished.turned ? 'turned' : 'level') };
  });
  for (const dimension of view.dimensions) {
    if (lanes.some((one) => one.dimension === dimension)) continue;
    placed.push(dimension.kind === 'angle' ? angle(dimension, at, width, height, covered) : inside(dimension, at, width, height, covered));
  }
  return {
    width,
    height,
    lines: view.lines.map(({ of, points }) => ({ of, d: pathOf(points.map(at)) })),
    circles: view.circles.map(({ of, center, diameter_mm }) => ({ of, at: at(center), radius: Math.max((diameter_mm * scale) / 2, 0) })),
    dimensions: placed,
  };
}

export const pathOf = (points: readonly Point[]): string => points.map(([x, y], index) => `${index === 0 ? 'M' : 'L'}${x.toFixed(1)} ${y.toFixed(1)}`).join('');

function outside({ dimension, side, lane }: Lane, at: (point: readonly number[]) => Point, edge: Record<Side, number>, width: number, height: number): PlacedDimension {
  const text = textOf(dimension);
  const isLevel = side === 'top' || side === 'bottom';
  const sign = side === 'top' || side === 'left' ? -1 : 1;
  const line = edge[side] + sign * (kLane * (lane + 1) - 4);
  const ends = [at(dimension.from), at(dimension.to)].map((end): { foot: Point; end: Point } => ({
    foot: isLevel ? [end[0], end[1] + sign * kGap] : [end[0] + sign * kGap, end[1]],
    end: isLevel ? [end[0], line] : [line, end[1]],
  }));
  const [a, b] = ends.map(({ end }) => end) as [Point, Point];
  const tips = arrows(a, b);
  const beyond = (end: Point): Point => (isLevel ? [end[0], end[1] + sign * 3] : [end[0] + sign * 3, end[1]]);
  const half = widthOf(text) / 2 + 2;
  const middle: Point = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  return {
    parameter: dimension.parameter,
    text,
    lines: [[a, b], ...ends.map(({ foot, end }) => [foot, beyond(end)]), ...tips.more],
    arrows: tips.arrows,
    at: isLevel ? [clamp(middle[0], half, width - half), line - 8] : [line - 8, clamp(middle[1], half, height - half)],
    turned: !isLevel,
  };
}

// What a text covers: its middle, and how far it goes from there.
interface Covered {
  x: number;
  y: number;
  across: number;
  up: number;
}

// The nearest place that no other text covers: of a text in the part above or below, within the picture; of one at an outer line along that line.
function free(at: Point, half: number, height: number, covered: Covered[], outer?: 'level' | 'turned'): Point {
  const [across, up] = outer === 'turned' ? [kTextHeight / 2, half] : [half, kTextHeight / 2];
  const isFree = ([x, y]: Point) => (outer === 'level' || (y >= up && y <= height - up)) && covered.every((one) => Math.abs(one.x - x) >= one.across + across || Math.abs(one.y - y) >= one.up + up);
  for (let step = 0; step < 60; ++step) {
    const by = (step % 2 === 0 ? 1 : -1) * Math.ceil(step / 2) * (kTextHeight / 3);
    const place: Point = outer === 'level' ? [at[0] + by, at[1]] : [at[0], at[1] + by];
    if (!isFree(place)) continue;
    covered.push({ x: place[0], y: place[1], across, up });
    return place;
  }
  return at;
}

function inside(dimension: Dimension, at: (point: readonly number[]) => Point, width: number, height: number, covered: Covered[]): PlacedDimension {
  const text = textOf(dimension);
  const [from, to] = [at(dimension.from), at(dimension.to)];
  const tips = arrows(from, to);
  const half = widthOf(text) / 2 + 4;
  const outward = to[0] >= from[0] ? 1 : -1;
  const isLong = Math.hypot(to[0] - from[0], to[1] - from[1]) > 60;
  const beside: Point = [from[0] + 0.75 * (to[0] - from[0]) + half + 6, from[1] + 0.75 * (to[1] - from[1])];
  const wished: Point = isLong ? beside : [to[0] + outward * (half + 10), to[1] - 6];
  const place = free([clamp(wished[0], half, width - half), clamp(wished[1], kTextHeight, height - kTextHeight)], half, height, covered);
  const isRadius = dimension.kind === 'radius';
  return {
    parameter: dimension.parameter,
    text,
    lines: isLong ? [[from, to]] : [[from, to], ...tips.more, [to, [place[0] - outward * Math.min(half, Math.abs(place[0] - to[0])), place[1] + 5]]],
    arrows: isRadius ? tips.arrows.slice(1) : tips.arrows,
    at: place,
    turned: false,
  };
}

function angle(dimension: Dimension, at: (point: readonly number[]) => Point, width: number, height: number, covered: Covered[]): PlacedDimension {
  const text = textOf(dimension);
  const [corner, from, to] = [at(dimension.at ?? [0, 0]), at(dimension.from), at(dimension.to)];
  const reach = ([x, y]: Point) => Math.hypot(x - corner[0], y - corner[1]);
  const radius = 0.62 * Math.min(reach(from), reach(to));
  const direction = ([x, y]: Point) => Math.atan2(y - corner[1], x - corner[0]);
  const begin = direction(from);
  // Counterclockwise as a person reads it, which is falling where y is down; the short side of it.
  let sweep = direction(to) - begin;
  if (sweep > Math.PI) sweep -= 2 * Math.PI;
  if (sweep < -Math.PI) sweep += 2 * Math.PI;
  const on = (share: number, by = radius): Point => [corner[0] + by * Math.cos(begin + share * sweep), corner[1] + by * Math.sin(begin + share * sweep)];
  const arc = Array.from({ length: 25 }, (_, index) => on(index / 24));
  const half = widthOf(text) / 2 + 4;
  const wished = on(0.5, radius + 14);
  const isLong = Math.abs(sweep) * radius > 3 * kArrow;
  return {
    parameter: dimension.parameter,
    text,
    lines: [arc, [corner, from], [corner, to]],
    arrows: isLong ? [arrow(on(0), on(0.1)), arrow(on(1), on(0.9))] : [],
    at: free([clamp(wished[0] + half * Math.sign(wished[0] - corner[0]) * 0.8, half, width - half), clamp(wished[1], kTextHeight, height - kTextHeight)], half, height, covered),
    turned: false,
  };
}
