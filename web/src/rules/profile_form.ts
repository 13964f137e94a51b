// A form from a JSON schema: which kind of field a member is, reading and changing a document by JSON pointers, what was
// typed as the value that it stands for. A member that is left empty is not in the document.
export interface SchemaNode {
  type?: string | string[];
  description?: string;
  enum?: (string | null)[];
  minimum?: number;
  maximum?: number;
  properties?: Record<string, SchemaNode>;
  required?: string[];
  items?: SchemaNode;
}

export type Json = null | boolean | number | string | Json[] | { [name: string]: Json };
export type JsonObject = { [name: string]: Json };

export type FieldKind = 'text' | 'choice' | 'flag' | 'number' | 'integer' | 'texts' | 'rows' | 'group';

const typesOf = ({ type }: SchemaNode): string[] => (Array.isArray(type) ? type : type === undefined ? [] : [type]);

export function kindOf(node: SchemaNode): FieldKind {
  const types = typesOf(node);
  if (node.enum) return 'choice';
  if (types.includes('boolean')) return 'flag';
  if (types.includes('integer')) return 'integer';
  if (types.includes('number')) return 'number';
  if (types.includes('object')) return 'group';
  if (types.includes('array')) return kindOf(node.items ?? {}) === 'group' ? 'rows' : 'texts';
  return 'text';
}

export const membersOf = (node: SchemaNode): [name: string, member: SchemaNode][] => Object.entries(node.properties ?? {});

// One value, and no list or object.
export const isField = (node: SchemaNode): boolean => !['rows', 'group'].includes(kindOf(node));

// Whether a row of such objects fits a table: its members are fields, or fold in their cell.
export const isFlat = (node: SchemaNode): boolean =>
  membersOf(node).every(([, member]) => isField(member) || membersOf(member.items ?? member).every(([, one]) => isField(one)));

// Units stand at the end of a member's name, as in the whole project.
const kUnits: [ending: string, unit: string][] = [
  ['_mm_min', 'mm/min'],
  ['_mm_s2', 'mm/s²'],
  ['_mm_s3', 'mm/s³'],
  ['_mm', 'mm'],
  ['_ms', 'ms'],
  ['_s', 's'],
  ['_rpm', '1/min'],
  ['_bytes', 'bytes'],
  ['_chars', 'characters'],
];

export const unitOf = (name: string): string => kUnits.find(([ending]) => name.endsWith(ending))?.[1] ?? '';

export const boundsText = ({ minimum, maximum }: SchemaNode): string =>
  minimum === undefined || maximum === undefined ? '' : `${minimum} … ${maximum}`;

export const pointerTo = (pointer: string, member: string | number): string => `${pointer}/${String(member).replaceAll('~', '~0').replaceAll('/', '~1')}`;

const stepsOf = (pointer: string): string[] =>
  pointer === ''
    ? []
    : pointer
        .slice(1)
        .split('/')
        .map((step) => step.replaceAll('~1', '/').replaceAll('~0', '~'));

const childOf = (value: Json | undefined, step: string): Json | undefined => {
  if (Array.isArray(value)) return value[Number(step)];
  return typeof value === 'object' && value !== null ? value[step] : undefined;
};

export const valueAt = (document: Json, pointer: string): Json | undefined => stepsOf(pointer).reduce<Json | undefined>(childOf, document);

// The document with another value there; undefined takes the member away, and an object that is empty then, too. Rows
// of a list keep their places: one is taken away by its list.
export function withValue(document: Json | undefined, pointer: string, value: Json | undefined): Json | undefined {
  const [step, ...rest] = stepsOf(pointer);
  if (step === undefined) return value;
  const below = rest.reduce((path, one) => pointerTo(path, one), '');
  const next = withValue(childOf(document, step), below, value);
  if (Array.isArray(document)) return document.map((one, index) => (String(index) === step ? (next ?? {}) : one));
  const members = { ...(typeof document === 'object' && document !== null ? document : {}) } as JsonObject;
  if (next === undefined) delete members[step];
  else members[step] = next;
  return Object.keys(members).length === 0 ? undefined : members;
}

// Undefined: nothing is typed. A number that is none stays as it was typed, and the server refuses it at its field.
export function typedValue(kind: FieldKind, typed: string): Json | undefined {
  const text = typed.trim();
  if (text === '') return undefined;
  if (kind === 'number' || kind === 'integer') {
    const number = Number(text.replace(',', '.'));
    return Number.isFinite(number) ? number : text;
  }
  if (kind === 'texts')
    return typed
      .split('\n')
      .map((line) => line.trim())
      .filter((line) => line !== '');
  return text;
}

export function shownValue(value: Json | undefined): string {
  if (value === undefined || value === null) return '';
  if (Array.isArray(value)) return value.map(shownValue).join('\n');
  return typeof value === 'object' ? JSON.stringify(value) : String(value);
}

// Faults by the field that they stand at: the longest pointer of a field that the fault's begins with.
export function faultsAt(places: readonly { pointer?: string; text: string }[], pointers: readonly string[]): { at: Map<string, string>; rest: string[] } {
  const at = new Map<string, string>();
  const rest: string[] = [];
  for (const { pointer, text } of places) {
    const own = pointers.filter((one) => pointer === one || pointer?.startsWith(`${one}/`)).sort((a, b) => b.length - a.length)[0];
    if (own === undefined || at.has(own)) rest.push(pointer ? `${pointer}: ${text}` : text);
    else at.set(own, text);
  }
  return { at, rest };
}

// Every field of a document by its pointer, in the order of the form.
export function fieldPointers(node: SchemaNode, document: Json | undefined, pointer = ''): string[] {
  const kind = kindOf(node);
  if (kind === 'group') return membersOf(node).flatMap(([name, member]) => fieldPointers(member, childOf(document, name), pointerTo(pointer, name)));
  if (kind !== 'rows') return [pointer];
  const rows = Array.isArray(document) ? document : [];
  return [pointer, ...rows.flatMap((row, index) => fieldPointers(node.items ?? {}, row, pointerTo(pointer, index)))];
}
