// A form from a schema: kinds of fields, a document changed by pointers, what was typed, faults at their fields.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { faultsAt, fieldPointers, kindOf, typedValue, unitOf, valueAt, withValue, type SchemaNode } from '../src/rules/profile_form';

const kSchema: SchemaNode = {
  type: 'object',
  required: ['name'],
  properties: {
    name: { type: 'string' },
    kind: { type: 'string', enum: ['mill', 'lathe'] },
    notes: { type: ['array', 'null'], items: { type: 'string' } },
    buffer: { type: ['object', 'null'], properties: { bytes: { type: ['integer', 'null'], minimum: 0, maximum: 9 } } },
    tools: { type: ['array', 'null'], items: { type: 'object', properties: { number: { type: 'integer' }, diameter_mm: { type: ['number', 'null'] }, tapered: { type: ['boolean', 'null'] } } } },
  },
};

test('each kind of member has its field', () => {
  const kinds = Object.fromEntries(Object.entries(kSchema.properties ?? {}).map(([name, node]) => [name, kindOf(node)]));
  assert.deepEqual(kinds, { name: 'text', kind: 'choice', notes: 'texts', buffer: 'group', tools: 'rows' });
  const tool = kSchema.properties?.['tools']?.items?.properties ?? {};
  assert.deepEqual(Object.values(tool).map(kindOf), ['integer', 'number', 'flag']);
  assert.equal(unitOf('acceleration_mm_s2'), 'mm/s²');
  assert.equal(unitOf('rapid_mm_min'), 'mm/min');
  assert.equal(unitOf('number'), '');
});

test('a change leaves the rest of the document as it was', () => {
  const before = { name: 'a', tools: [{ number: 1 }, { number: 2, diameter_mm: 4 }] };
  const after = withValue(before, '/tools/1/diameter_mm', 5);
  assert.deepEqual(after, { name: 'a', tools: [{ number: 1 }, { number: 2, diameter_mm: 5 }] });
  assert.deepEqual(before.tools[1], { number: 2, diameter_mm: 4 });
  assert.deepEqual(withValue(before, '/buffer/bytes', 7), { ...before, buffer: { bytes: 7 } });
});

test('what is empty is not in the document, and a row keeps its place', () => {
  assert.deepEqual(withValue({ name: 'a', buffer: { bytes: 7 } }, '/buffer/bytes', undefined), { name: 'a' });
  assert.deepEqual(withValue({ tools: [{ number: 1 }, { number: 2 }] }, '/tools/0/number', undefined), { tools: [{}, { number: 2 }] });
  assert.equal(valueAt({ 'a/b': { '~': 1 } }, '/a~1b/~0'), 1);
});

test('what is typed is the value that it stands for, or stays as it was typed', () => {
  assert.equal(typedValue('number', ' 8,5 '), 8.5);
  assert.equal(typedValue('integer', '12'), 12);
  assert.equal(typedValue('number', '8.5mm'), '8.5mm');
  assert.equal(typedValue('text', '  '), undefined);
  assert.deepEqual(typedValue('texts', 'one\n\n two '), ['one', 'two']);
});

test('a fault stands at its field, or at the list that it is about; what has no field is kept', () => {
  const document = { name: 'a', tools: [{ number: 1 }] };
  const pointers = fieldPointers(kSchema, document);
  assert.deepEqual(pointers, ['/name', '/kind', '/notes', '/buffer/bytes', '/tools', '/tools/0/number', '/tools/0/diameter_mm', '/tools/0/tapered']);
  const { at, rest } = faultsAt(
    [
      { pointer: '/tools/0/number', text: 'is given twice' },
      { pointer: '/notes/1', text: 'must be a text' },
      { pointer: '/tools/0/number', text: 'a second one' },
      { pointer: '/colour', text: 'is not known' },
      { text: 'of the whole' },
    ],
    pointers,
  );
  assert.deepEqual([...at], [['/tools/0/number', 'is given twice'], ['/notes', 'must be a text']]);
  assert.deepEqual(rest, ['/tools/0/number: a second one', '/colour: is not known', 'of the whole']);
});
