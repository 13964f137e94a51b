// Values of a part in its form: what is empty has the family's default. An error goes to the field that it names.
import type { Parameter } from '../api/types';

export type Values = Record<string, string>;

export const isList = (parameter: Parameter): boolean => parameter.most > 0;

// "10 … 400 mm", "in steps of 0.5 mm"; null where there is no bound.
export function boundsOf({ low, high, unit }: Pick<Parameter, 'low' | 'high' | 'unit'>): string | null {
  if (low === null && high === null) return null;
  const suffix = unit === '' ? '' : ` ${unit}`;
  if (low === null) return `≤ ${high}${suffix}`;
  if (high === null) return `≥ ${low}${suffix}`;
  return `${low} … ${high}${suffix}`;
}

// A plain number in a field of a unit is meant in that unit: the language itself wants it written.
export function valueOf(parameter: Parameter, typed: string): string {
  const text = typed.trim();
  const isPlain = /^[-+]?(?:\d+\.?\d*|\.\d+)$/.test(text.replace(',', '.'));
  if (!isPlain || parameter.unit === '' || isList(parameter)) return text;
  return `${text.replace(',', '.')} ${parameter.unit}`;
}

export function givenValues(parameters: readonly Parameter[], typed: Values): Values {
  const given: Values = {};
  for (const parameter of parameters) {
    const value = valueOf(parameter, typed[parameter.name] ?? '');
    if (value !== '') given[parameter.name] = value;
  }
  return given;
}

export interface ValueFault {
  pointer?: string;
  text: string;
}

// The field that a fault is about: by its pointer, or because its sentence names the parameter. Null: of the whole.
export function parameterOf(fault: ValueFault, parameters: readonly Pick<Parameter, 'name'>[]): string | null {
  const [, pointed] = /^\/values\/([^/]+)$/.exec(fault.pointer ?? '') ?? [];
  if (pointed !== undefined) return pointed;
  const words = new Set(fault.text.match(/[A-Za-z_][A-Za-z_0-9]*/g) ?? []);
  const named = parameters.filter(({ name }) => words.has(name));
  return named.length === 1 ? (named[0]?.name ?? null) : null;
}

// For which machines a family is, as the head of its text and `native` state it; dialect null: of any control.
export interface WantedMachine {
  kind: string;
  dialect: string | null;
}

export function wantedBy(text: string): WantedMachine {
  const [, kind = ''] = /^[ \t]*machine[ \t]+([a-z-]+)/m.exec(text) ?? [];
  const [, dialect = null] = /^[ \t]*native[ \t]+(\S+)[ \t]*$/m.exec(text) ?? [];
  return { kind, dialect };
}

// As the server judges it: a lathe's family is made on a mill-turn, too.
export const isMadeOn = (wanted: WantedMachine, machine: { kind: string; dialect: string }): boolean =>
  (machine.kind === wanted.kind || (machine.kind === 'mill-turn' && wanted.kind === 'lathe')) && (wanted.dialect === null || wanted.dialect === machine.dialect);

// In the order of the text, by their headings.
export function grouped(parameters: readonly Parameter[]): { group: string; parameters: Parameter[] }[] {
  const groups: { group: string; parameters: Parameter[] }[] = [];
  for (const parameter of parameters) {
    const last = groups.at(-1);
    if (last && last.group === parameter.group) last.parameters.push(parameter);
    else groups.push({ group: parameter.group, parameters: [parameter] });
  }
  return groups;
}
