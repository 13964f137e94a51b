// What the reference reads of an OpenAPI document: the parts that dripfeed writes, no more.

export interface Schema {
  $ref?: string;
  type?: string | string[];
  description?: string;
  enum?: (string | null)[];
  'x-enumDescriptions'?: Record<string, string>;
  minimum?: number;
  maximum?: number;
  items?: Schema;
  properties?: Record<string, Schema>;
  required?: string[];
  additionalProperties?: Schema | boolean;
  anyOf?: Schema[];
  examples?: unknown[];
}

export interface Parameter {
  name: string;
  in: string;
  required: boolean;
  description: string;
  schema: Schema;
}

export interface Answer {
  $ref?: string;
  description?: string;
  content?: Record<string, { schema: Schema }>;
}

export interface Operation {
  operationId: string;
  summary: string;
  description: string;
  tags: string[];
  parameters?: Parameter[];
  requestBody?: { required: boolean; content: Record<string, { schema: Schema }> };
  responses: Record<string, Answer>;
}

export interface OpenApi {
  info: { version: string; description: string };
  tags: { name: string; description: string }[];
  paths: Record<string, Record<string, Operation>>;
  components: { schemas: Record<string, Schema>; responses: Record<string, Answer> };
}

export interface Route {
  method: string;
  path: string;
  operation: Operation;
}

export const nameOf = (reference: string): string => reference.slice(reference.lastIndexOf('/') + 1);

export function routesOf(document: OpenApi, tag: string): Route[] {
  return Object.entries(document.paths).flatMap(([path, item]) =>
    Object.entries(item)
      .filter(([, operation]) => operation.tags.includes(tag))
      .map(([method, operation]) => ({ method: method.toUpperCase(), path, operation })),
  );
}

// A type in words, without what it names: "integer, 1 to 60, or null".
export function wordsOf(schema: Schema): string {
  if (schema.enum) return schema.enum.map(String).join(', ');
  const kinds = [schema.type ?? 'any'].flat().filter((kind) => kind !== 'null');
  const { minimum, maximum } = schema;
  const isBounded = maximum !== undefined && maximum < Number.MAX_SAFE_INTEGER;
  const range = minimum !== undefined && isBounded ? `, ${minimum} to ${maximum}` : minimum !== undefined ? `, from ${minimum}` : '';
  const inner = schema.items ? ` of ${schema.items.$ref ? nameOf(schema.items.$ref) : wordsOf(schema.items)}` : '';
  return `${kinds.join(' or ')}${inner}${range}${[schema.type].flat().includes('null') ? ', or null' : ''}`;
}

// The schema that one names, itself or in a list: to link it.
export function namedBy(schema: Schema): string | null {
  const reference = schema.$ref ?? schema.items?.$ref ?? schema.anyOf?.find((one) => one.$ref)?.$ref;
  return reference ? nameOf(reference) : null;
}
