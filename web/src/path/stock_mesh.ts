// The stock as a surface: a map as a grid of heights within a ring of no material, a bar as rings around z. Corners are
// computed here, so that plain tests run it and clicks find them; only heights change along a program.
import type { Stock } from './stock';

export interface StockMesh {
  positions: Float32Array<ArrayBuffer>; // x y z of each corner
  gone: Float32Array<ArrayBuffer>; // 1: no material there
  over: Float32Array<ArrayBuffer>; // above the nominal; kNoNominal: none is known there
  triangles: Uint32Array<ArrayBuffer>;
  // The corners of the places as they stand now.
  set: (heights: Float32Array, overOf: (place: number, height: number) => number) => void;
}

export const kNoNominal = -1e30;
const kAround = 48;

export const meshOf = (stock: Stock): StockMesh => (stock.kind === 'map' ? mapMesh(stock) : barMesh(stock));

// Two triangles a cell of a grid of corners, all of them turned in the same direction.
function gridTriangles(columns: number, rows: number): Uint32Array<ArrayBuffer> {
  const triangles = new Uint32Array(6 * (columns - 1) * (rows - 1));
  let at = 0;
  for (let row = 0; row + 1 < rows; row += 1)
    for (let column = 0; column + 1 < columns; column += 1) {
      const here = row * columns + column;
      triangles.set([here, here + 1, here + columns, here + 1, here + columns + 1, here + columns], at);
      at += 6;
    }
  return triangles;
}

const known = (value: number): number => (Number.isNaN(value) ? kNoNominal : Math.max(value, -1e9));

function mapMesh({ columns, rows, low_mm, y_low_mm, step_mm, bottom_mm }: Stock): StockMesh {
  const wide = columns + 2;
  const corners = wide * (rows + 2);
  const positions = new Float32Array(3 * corners);
  const gone = new Float32Array(corners).fill(1);
  const over = new Float32Array(corners).fill(kNoNominal);
  const along = (index: number, count: number): number => Math.min(Math.max(index - 0.5, 0), count) * step_mm;
  for (let row = 0; row < rows + 2; row += 1)
    for (let column = 0; column < wide; column += 1) {
      const p = 3 * (row * wide + column);
      positions[p] = low_mm + along(column, columns);
      positions[p + 1] = y_low_mm + along(row, rows);
      positions[p + 2] = bottom_mm;
    }
  return {
    positions,
    gone,
    over,
    triangles: gridTriangles(wide, rows + 2),
    set: (heights, overOf) => {
      for (let row = 0; row < rows; row += 1)
        for (let column = 0; column < columns; column += 1) {
          const place = row * columns + column;
          const corner = (row + 1) * wide + column + 1;
          const height = heights[place] ?? -Infinity;
          gone[corner] = height === -Infinity ? 1 : 0;
          positions[3 * corner + 2] = height === -Infinity ? bottom_mm : height;
          over[corner] = known(overOf(place, height));
        }
    },
  };
}

function barMesh({ columns, low_mm, step_mm }: Stock): StockMesh {
  const rings = columns + 2; // a middle at either end closes it
  const wide = kAround + 1;
  const positions = new Float32Array(3 * rings * wide);
  const over = new Float32Array(rings * wide).fill(kNoNominal);
  const directions = Array.from({ length: wide }, (_, i) => [Math.cos((2 * Math.PI * i) / kAround), Math.sin((2 * Math.PI * i) / kAround)] as const);
  const setRing = (ring: number, radius: number, z: number, value: number) => {
    directions.forEach(([x, y], i) => {
      const corner = ring * wide + i;
      positions.set([radius * x, radius * y, z], 3 * corner);
      over[corner] = value;
    });
  };
  return {
    positions,
    gone: new Float32Array(rings * wide),
    over,
    triangles: gridTriangles(wide, rings),
    set: (heights, overOf) => {
      setRing(0, 0, low_mm, kNoNominal);
      for (let place = 0; place < columns; place += 1) {
        const radius = Math.max(heights[place] ?? 0, 0);
        setRing(place + 1, radius, low_mm + place * step_mm, known(overOf(place, radius)));
      }
      setRing(rings - 1, 0, low_mm + (columns - 1) * step_mm, kNoNominal);
    },
  };
}
