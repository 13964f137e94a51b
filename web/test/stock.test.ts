// The stock along a program: bytes as the server writes them, forth and back in time, its surface and its nominal.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { againstNominal, overNominal, removalsUntil, stateOf, stockBounds, stockOf, type Stock } from '../src/path/stock';
import { kNoNominal, meshOf } from '../src/path/stock_mesh';

const kHead = { kind: 'map', columns: 2, rows: 2, low_mm: 10, y_low_mm: 20, step_mm: 5, bottom_mm: -8, span: 0, is_cut_off: false, ran: true, notes: ['a tool'] };

type Columns = Record<'start' | 'nominal' | 'tolerances' | 'heights' | 'moments', number[]> & { places: number[] };

function bytesOf(head: object, columns: Columns): ArrayBuffer {
  const names = ['start', 'nominal', 'tolerances', 'places', 'heights', 'moments'] as const;
  const arrays = names.map((name) => [name, name === 'places' ? 'u32' : 'f32', columns[name].length]);
  let text = JSON.stringify({ ...head, arrays });
  while (text.length % 4 !== 0) text += ' ';
  const parts = names.map((name) => new Uint8Array((name === 'places' ? new Uint32Array(columns[name]) : new Float32Array(columns[name])).buffer));
  const length = new Uint8Array(new Uint32Array([text.length]).buffer);
  const all = [new TextEncoder().encode('DFS1'), length, new TextEncoder().encode(text), ...parts];
  const out = new Uint8Array(all.reduce((sum, one) => sum + one.length, 0));
  let at = 0;
  for (const one of all) {
    out.set(one, at);
    at += one.length;
  }
  return out.buffer;
}

const kStock: Stock = stockOf(
  bytesOf(kHead, { start: [0, 0, 0, -Infinity], nominal: [-2, -2, NaN, NaN], tolerances: [0.1, 0.1, 0, 0], places: [0, 1, 0], heights: [-2.05, -3, -Infinity], moments: [1, 2.5, 7] }),
);

test('bytes are what they were', () => {
  assert.equal(kStock.kind, 'map');
  assert.deepEqual(kStock.notes, ['a tool']);
  assert.deepEqual([...kStock.start], [0, 0, 0, -Infinity]);
  assert.deepEqual([...kStock.places], [0, 1, 0]);
  assert.throws(() => stockOf(new Uint8Array([1, 2, 3, 4, 0, 0, 0, 0]).buffer));
});

test('it goes forth and back', () => {
  const state = stateOf(kStock);
  const at = (moment: number) => {
    state.goTo(moment);
    return [...state.heights].map((one) => Math.fround(one));
  };
  assert.deepEqual(at(0.9), [0, 0, 0, -Infinity]);
  assert.deepEqual(at(2.5), [Math.fround(-2.05), -3, 0, -Infinity]);
  assert.deepEqual(at(Infinity), [-Infinity, -3, 0, -Infinity]);
  assert.deepEqual(at(1), [Math.fround(-2.05), 0, 0, -Infinity], 'back again');
  assert.equal(state.goTo(1.2), false, 'nothing happens there');
  assert.equal(removalsUntil(kStock, 100), 3);
});

test('against the nominal', () => {
  assert.equal(overNominal(kStock, 0, -2.05), 0, 'within the tolerance');
  assert.equal(overNominal(kStock, 0, -3), -1);
  assert.equal(overNominal(kStock, 0, 0), 2);
  assert.equal(overNominal(kStock, 0, -Infinity), -Infinity, 'no material where there should be some');
  assert.ok(Number.isNaN(overNominal(kStock, 2, 0)), 'there is no nominal');
  const found = againstNominal(kStock, new Float32Array([-2.05, -3, 0, -Infinity]));
  assert.deepEqual(found, { under_mm: 1, over_mm: 0 });
  assert.equal(againstNominal({ ...kStock, nominal: new Float32Array() }, kStock.start), null);
});

// Volume by the divergence theorem: it is right only where the surface is closed and turned outwards throughout.
function volumeOf(positions: Float32Array, triangles: Uint32Array, bottom: number): number {
  let volume = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => [0, 1, 2].map((axis) => (positions[3 * (triangles[i + k] ?? 0) + axis] ?? 0) - (axis === 2 ? bottom : 0))) as [number[], number[], number[]];
    const [ax = 0, ay = 0, az = 0] = a;
    const [bx = 0, by = 0, bz = 0] = b;
    const [cx = 0, cy = 0, cz = 0] = c;
    volume += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6;
  }
  return volume;
}

test('a map is a surface that looks up, within a ring of no material', () => {
  const mesh = meshOf(kStock);
  mesh.set(kStock.start, (place, height) => overNominal(kStock, place, height));
  assert.equal(mesh.positions.length, 3 * 16);
  assert.deepEqual([...mesh.gone].filter((one) => one === 0).length, 3, 'three places have material');
  assert.ok(volumeOf(mesh.positions, mesh.triangles, -8) > 0);
  assert.ok([...mesh.over].filter((one) => one > kNoNominal).length === 2);
  const { low, high } = stockBounds(kStock);
  assert.deepEqual([low, high], [[10, 20, -8], [20, 30, 0]]);
});

test('a bar is a closed body around z', () => {
  const places = 11;
  const bar: Stock = { ...kStock, kind: 'bar', columns: places, rows: 1, low_mm: -50, step_mm: 5, start: new Float32Array(places).fill(20), nominal: new Float32Array(), tolerances: new Float32Array() };
  const mesh = meshOf(bar);
  mesh.set(bar.start, () => NaN);
  const round = Math.PI * 20 * 20 * 50;
  assert.ok(Math.abs(volumeOf(mesh.positions, mesh.triangles, 0) / round - 1) < 0.005, 'as large as the bar, of 48 sides');
  assert.deepEqual(stockBounds(bar), { low: [-20, -20, -50], high: [20, 20, 0] });
});
