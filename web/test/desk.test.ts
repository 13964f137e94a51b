// What the desk knows by itself: files, line ends and columns, values of parts, findings of a verdict, pieces of a line.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { DialectWords, Parameter, Verdict } from '../src/api/types';
import { tokensOf } from '../src/editor/tokens';
import { Words } from '../src/editor/words';
import { boundsOf, givenValues, grouped, parameterOf } from '../src/rules/part_values';
import { columnOffset, decodeProgram, lineEndOf, linesOf, nameOfFile, tagsOf } from '../src/rules/program_files';
import { lineFrom, originOf, sideOf } from '../src/rules/translations';
import { findingsOf } from '../src/rules/verdicts';
import { hrefs, routeOf } from '../src/router';

test('a file gives its program the name without an ending that says nothing', () => {
  assert.equal(nameOfFile('O0700.nc'), 'O0700');
  assert.equal(nameOfFile('housing rev 2.TXT'), 'housing rev 2');
  assert.equal(nameOfFile('WELLE.MPF'), 'WELLE.MPF');
  assert.equal(nameOfFile('O1234'), 'O1234');
});

test('bytes are UTF-8, or else Latin-1', () => {
  const bytes = (...all: number[]) => new Uint8Array(all).buffer;
  assert.deepEqual(decodeProgram(bytes(0x28, 0xc3, 0xa4, 0x29)), { text: '(ä)', encoding: 'utf-8' });
  assert.deepEqual(decodeProgram(bytes(0x28, 0xe4, 0x29)), { text: '(ä)', encoding: 'latin-1' });
  const long = new Uint8Array(20_000).fill(0xe4);
  assert.equal(decodeProgram(long.buffer).text.length, 20_000);
});

test('lines end as controls end them, and go back the same', () => {
  for (const end of ['\n', '\r\n', '\r', '\n\r\r']) {
    const text = ['%', 'O1', '', 'M30', '%'].join(end);
    assert.equal(lineEndOf(text), end);
    assert.deepEqual(linesOf(text), ['%', 'O1', '', 'M30', '%']);
    assert.equal(linesOf(text).join(lineEndOf(text) ?? ''), text);
  }
  assert.equal(lineEndOf('a\nb\r\nc'), null);
  assert.equal(lineEndOf('M30'), '\n');
});

test('a column in characters is an offset in UTF-16', () => {
  assert.equal(columnOffset('G1 X', 1), 0);
  assert.equal(columnOffset('G1 X', 4), 3);
  assert.equal(columnOffset('(😀) x', 4), 4);
  assert.equal(columnOffset('G1', 99), 2);
});

test('tags as a person writes them', () => assert.deepEqual(tagsOf(' pump, acme ,, pump'), ['acme', 'pump']));

const parameter = (of: Partial<Parameter>): Parameter => ({
  name: 'depth',
  kind: 'length',
  unit: 'mm',
  default: '5 mm',
  low: 1,
  high: 10,
  step: 0,
  choices: [],
  fewest: 0,
  most: 0,
  text: '',
  group: '',
  ...of,
});

test('what is empty has the default, and a plain number the unit of its field', () => {
  const all = [parameter({}), parameter({ name: 'count', unit: '' }), parameter({ name: 'list', most: 3, fewest: 1 }), parameter({ name: 'free' })];
  assert.deepEqual(givenValues(all, { depth: ' 2,5 ', count: '3', list: '1', free: '', other: '9' }), { depth: '2.5 mm', count: '3', list: '1' });
  assert.deepEqual(givenValues([parameter({})], { depth: '2 in' }), { depth: '2 in' });
});

test('bounds, and headings in their order', () => {
  assert.equal(boundsOf(parameter({})), '1 … 10 mm');
  assert.equal(boundsOf(parameter({ high: null, unit: '' })), '≥ 1');
  assert.equal(boundsOf(parameter({ low: null, high: null })), null);
  const groups = grouped([parameter({ group: 'a' }), parameter({ group: 'a' }), parameter({ group: 'b' })]);
  assert.deepEqual(groups.map(({ group, parameters }) => [group, parameters.length]), [
    ['a', 2],
    ['b', 1],
  ]);
});

test('a fault goes to the one field that it names', () => {
  const all = [{ name: 'depth' }, { name: 'step' }];
  assert.equal(parameterOf({ pointer: '/values/step', text: 'x' }, all), 'step');
  assert.equal(parameterOf({ text: 'depth = 99 mm lies outside 1 .. 10 mm' }, all), 'depth');
  assert.equal(parameterOf({ text: 'depth is less than step' }, all), null);
  assert.equal(parameterOf({ text: 'the number is missing' }, all), null);
});

test('findings of all checks, worst first', () => {
  const diagnostic = { id: 'a', severity: 'warning', file: null, line: 7, column: 1, column_chars: 1, text: 'w', alarm: null };
  const found = { id: 'b', severity: 'error', line: 9, program: 1, value: 1, limit: 2, text: 'e', alarm: '500' };
  const verdict = { diagnostics: [diagnostic], envelope: { findings: [found] }, gouge: null, accuracy: null, programs: ['O1', 'O2'] };
  assert.deepEqual(findingsOf(verdict as unknown as Verdict), [
    { id: 'b', severity: 'error', line: 9, file: 'O2', text: 'e', alarm: '500' },
    { id: 'a', severity: 'warning', line: 7, file: null, text: 'w', alarm: null },
  ]);
});

const word = (name: string, sort: DialectWords['words'][number]['sort'], last: number | null = null) => ({ word: name, sort, about: name, reference: null, last });
const fanuc = new Words({
  dialect: 'fanuc',
  title: '',
  comment: { open: '(', close: ')' },
  touching: true,
  words: [word('G02', 'code'), word('G54.1', 'code'), word('IF', 'keyword'), word('GOTO', 'keyword'), word('ROUND', 'function'), word('GT', 'keyword'), word('#5001', 'variable', 5020)],
}, true);
const siemens = new Words({
  dialect: 'sinumerik-840d',
  title: '',
  comment: { open: ';', close: null },
  touching: false,
  words: [word('G500', 'code'), word('CYCLE81', 'cycle'), word('DIAMON', 'code'), word('GOTOF', 'keyword'), word('SIN', 'function'), word('$P_EP', 'variable')],
}, true);

const pieces = (line: string, words: Words): string[] => tokensOf(line, words).map(({ from, to, sort, word: of }) => `${line.slice(from, to)} ${sort}${of ? ` ${of.word}` : ''}`);

test('pieces of a line where words touch each other', () => {
  assert.deepEqual(pieces('N10G2X-1.5(G02)', fanuc), ['N10 block', 'G2 code G02', 'X address', '- sign', '1.5 number', '(G02) comment']);
  assert.deepEqual(pieces('IF[#5004GT0]GOTO20', fanuc), ['IF keyword IF', '[ sign', '#5004 variable #5001', 'GT keyword GT', '0 number', '] sign', 'GOTO keyword GOTO', '20 number']);
  assert.deepEqual(pieces('XROUND[#1]', fanuc), ['X address', 'ROUND function ROUND', '[ sign', '#1 variable', '] sign']);
  assert.deepEqual(pieces('G54.1 P2 G777', fanuc), ['G54.1 code G54.1', 'P address', '2 number', 'G777 code']);
  assert.deepEqual(pieces('(open', fanuc), ['(open comment']);
});

test('pieces of a line where words are names', () => {
  assert.deepEqual(pieces('G0 X=R5*SIN(10) ; up', siemens), ['G0 code', 'X address', '= sign', 'R5 variable', '* sign', 'SIN function SIN', '( sign', '10 number', ') sign', '; up comment']);
  assert.deepEqual(pieces('CYCLE81(10) diamon G500', siemens), ['CYCLE81 cycle CYCLE81', '( sign', '10 number', ') sign', 'diamon code DIAMON', 'G500 code G500']);
  assert.deepEqual(pieces('IFX GOTOF E1 T="MILL"', siemens), ['IFX name', 'GOTOF keyword GOTOF', 'E address', '1 number', 'T address', '= sign', '"MILL" string']);
});

test('addresses of the desk', () => {
  assert.equal(routeOf(hrefs.library).view, 'library');
  const at = routeOf(hrefs.program(7, 'compare', { revision: '1', with_revision: '2' }));
  assert.deepEqual([at.view, at.parameters, at.query.get('with_revision')], ['program', ['7', 'compare'], '2']);
  assert.deepEqual(routeOf(hrefs.program(7)).parameters, ['7', '']);
  assert.equal(routeOf('#/programs/7/nonsense').view, 'not_found');
  assert.deepEqual(routeOf(hrefs.part('R/7 ä')).parameters, ['R/7 ä']);
});

test('a line of a text and of its translation are found from each other', () => {
  const origins = [1, 0, 3, 3, 7]; // the second line comes from none
  assert.equal(originOf(origins, 1), 1);
  assert.equal(originOf(origins, 2), null);
  assert.equal(originOf(origins, 9), null);
  assert.equal(lineFrom(origins, 3), 3);
  assert.equal(lineFrom(origins, 4), 5, 'of a line that became none, what comes after it');
  assert.equal(lineFrom(origins, 8), null);
  assert.equal(lineFrom([], 4), 4, 'without a table the lines are the same');
});

test('a translation is for a machine or a language', () => {
  assert.deepEqual(sideOf('machine:mill 2'), { to_machine: 'mill 2' });
  assert.deepEqual(sideOf('mazak'), { to: 'mazak' });
  assert.equal(sideOf('?'), null);
});
