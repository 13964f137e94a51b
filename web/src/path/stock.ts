// The stock along a program, as the server's bytes have it: what stands before the first cut, and what each cut takes
// away. No browser and no words here, so that plain tests run it.
export interface StockHead {
  kind: 'map' | 'bar'; // heights over x and y, or radii along z
  columns: number;
  rows: number;
  low_mm: number; // of x, of a bar the z of its first place
  y_low_mm: number;
  step_mm: number;
  bottom_mm: number;
  span: number;
  is_cut_off: boolean;
  ran: boolean;
  notes: string[];
}

export interface Stock extends StockHead {
  start: Float32Array; // -Infinity: no material
  nominal: Float32Array; // NaN: none there; empty: none is known
  tolerances: Float32Array;
  // Removals, in the order of their moments: places of the path's points, between which one may lie.
  places: Uint32Array;
  heights: Float32Array;
  moments: Float32Array;
}

type Column = [name: string, type: 'f32' | 'u32', count: number];

export function stockOf(bytes: ArrayBuffer): Stock {
  const view = new DataView(bytes);
  const magic = String.fromCharCode(...new Uint8Array(bytes, 0, 4));
  if (magic !== 'DFS1') throw new Error('these bytes are no stock');
  const length = view.getUint32(4, true);
  const { arrays, ...head } = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 8, length))) as StockHead & { arrays: Column[] };
  const columns: Record<string, Float32Array | Uint32Array> = {};
  let at = 8 + length;
  for (const [name, type, count] of arrays) {
    columns[name] = type === 'f32' ? new Float32Array(bytes, at, count) : new Uint32Array(bytes, at, count);
    at += 4 * count;
  }
  return { ...head, ...columns } as Stock;
}

type Corner = [x: number, y: number, z: number];

// The stock as it stands at a moment; it goes forth and back.
export interface StockState {
  heights: Float32Array;
  goTo: (moment: number) => boolean; // whether anything is another one than before
}

export function stateOf(stock: Stock): StockState {
  const heights = stock.start.slice();
  let done = 0; // removals so far
  return {
    heights,
    goTo: (moment) => {
      const wanted = removalsUntil(stock, moment);
      if (wanted === done) return false;
      if (wanted < done) {
        heights.set(stock.start);
        done = 0;
      }
      for (; done < wanted; done += 1) heights[stock.places[done] ?? 0] = stock.heights[done] ?? 0;
      return true;
    },
  };
}

// How many have a moment at or before this one.
export function removalsUntil({ moments }: Pick<Stock, 'moments'>, moment: number): number {
  let low = 0;
  let high = moments.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((moments[middle] ?? 0) <= moment) low = middle + 1;
    else high = middle;
  }
  return low;
}

// How far a place stands above its nominal, in tolerances' sign: 0 within; positive, material is left; NaN: no nominal
// there, or no material.
export function overNominal({ nominal, tolerances }: Pick<Stock, 'nominal' | 'tolerances'>, place: number, height: number): number {
  const over = height - (nominal[place] ?? NaN);
  if (!Number.isFinite(over)) return height === -Infinity && Number.isFinite(nominal[place] ?? NaN) ? -Infinity : NaN;
  return Math.abs(over) <= (tolerances[place] ?? 0) ? 0 : over;
}

// The deepest place below and the highest above the nominal; null: none is known.
export function againstNominal(stock: Stock, heights: Float32Array): { under_mm: number; over_mm: number } | null {
  if (stock.nominal.length === 0) return null;
  let under = 0;
  let over = 0;
  for (let place = 0; place < heights.length; place += 1) {
    const value = overNominal(stock, place, heights[place] ?? 0);
    if (value < under) under = value;
    if (value > over) over = value;
  }
  return { under_mm: -under, over_mm: over };
}

// Of what stands before the first cut.
export function stockBounds(stock: Stock): { low: Corner; high: Corner } {
  const most = stock.start.reduce((high, one) => Math.max(high, one), -Infinity);
  if (stock.kind === 'bar') return { low: [-most, -most, stock.low_mm], high: [most, most, stock.low_mm + (stock.columns - 1) * stock.step_mm] };
  const { low_mm, y_low_mm, columns, rows, step_mm, bottom_mm } = stock;
  return { low: [low_mm, y_low_mm, bottom_mm], high: [low_mm + columns * step_mm, y_low_mm + rows * step_mm, most] };
}
