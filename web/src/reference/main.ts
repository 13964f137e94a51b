// The reference of the API at /docs/api-reference: written in the browser from the server's own description, so that it is always that of
// the server that is asked. No markup comes from the document: all of it is text.
import { namedBy, nameOf, routesOf, wordsOf, type Answer, type OpenApi, type Operation, type Route, type Schema } from './document';

type Child = Node | string;

function make(tag: string, attributes: Record<string, string>, ...children: Child[]): HTMLElement {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

// A text with `code` in it.
const words = (text: string): Child[] => text.split('`').map((part, i) => (i % 2 === 1 ? make('code', {}, part) : part));
const slugOf = (text: string): string => text.toLowerCase().replaceAll(' ', '-');
const linkTo = (schema: string): HTMLElement => make('a', { href: `#schema-${schema}` }, schema);

function table(heads: string[], rows: Child[][][]): HTMLElement {
  const row = (tag: string, cells: Child[][]) => make('tr', {}, ...cells.map((cell) => make(tag, {}, ...cell)));
  const head = make('thead', {}, row('th', heads.map((one) => [one])));
  return make('div', { class: 'wide', tabindex: '0' }, make('table', {}, head, make('tbody', {}, ...rows.map((cells) => row('td', cells)))));
}

function typeCell(schema: Schema): Child[] {
  const named = namedBy(schema);
  if (named === null) return [wordsOf(schema)];
  return [schema.items ? 'list of ' : '', linkTo(named), schema.anyOf ? ', or null' : ''];
}

// The members of an object, those of objects inside it with their path.
function memberRows(schema: Schema, above: string): Child[][][] {
  return Object.entries(schema.properties ?? {}).flatMap(([name, member]) => {
    const path = make('code', {}, above + name);
    const shown = schema.required?.includes(name) ? make('strong', {}, path) : path;
    const inner = member.items ?? member;
    return [[[shown], typeCell(member), words(member.description ?? '')], ...memberRows(inner, `${above}${name}${member.items ? '[]' : ''}.`)];
  });
}

const example = (value: unknown): HTMLElement => make('pre', { tabindex: '0' }, make('code', {}, JSON.stringify(value, null, 2)));

function aboutSchema(schema: Schema): Child[] {
  const parts: Child[] = [];
  if (schema.description) parts.push(make('p', {}, ...words(schema.description)));
  const rows = memberRows(schema, '');
  if (rows.length > 0) parts.push(table(['member', 'type', 'means'], rows));
  if (schema.$ref) parts.push(make('p', {}, 'as ', linkTo(nameOf(schema.$ref))));
  for (const one of schema.examples ?? []) parts.push(example(one));
  return parts;
}

function answerRows(api: OpenApi, responses: Record<string, Answer>): Child[][][] {
  return Object.entries(responses).map(([status, answer]) => {
    const whole = answer.$ref ? (api.components.responses[nameOf(answer.$ref)] ?? answer) : answer;
    const bodies = Object.entries(whole.content ?? {}).flatMap(([type, { schema }], i): Child[] => {
      const named = namedBy(schema);
      return [i > 0 ? ', ' : '', named ? linkTo(named) : type];
    });
    return [[make('code', {}, status)], bodies, words(whole.description ?? '')];
  });
}

function bodyOf(operation: Operation): Child[] {
  const schema = operation.requestBody?.content['application/json']?.schema;
  const named = schema && namedBy(schema);
  return named ? [make('p', {}, 'Body: ', linkTo(named), operation.requestBody?.required ? '' : ', may be left out')] : [];
}

function aboutRoute(api: OpenApi, { method, path, operation }: Route): HTMLElement {
  const parameters = (operation.parameters ?? []).map((one): Child[][] => {
    const name = make('code', {}, one.name);
    return [[one.required ? make('strong', {}, name) : name], [one.in], typeCell(one.schema), words(one.description)];
  });
  return make(
    'details',
    { id: operation.operationId, class: 'docs-route' },
    make('summary', {}, make('code', {}, `${method} ${path}`), ' ', operation.summary),
    make('p', {}, ...words(operation.description)),
    ...(parameters.length > 0 ? [table(['parameter', 'in', 'type', 'means'], parameters)] : []),
    ...bodyOf(operation),
    table(['status', 'answer', 'means'], answerRows(api, operation.responses)),
  );
}

function write(api: OpenApi, into: HTMLElement): void {
  const list = api.tags.map((tag) => make('li', {}, make('a', { href: `#${slugOf(tag.name)}` }, tag.name)));
  const groups = api.tags.flatMap((tag) => [
    make('h2', { id: slugOf(tag.name) }, tag.name),
    make('p', {}, tag.description),
    ...routesOf(api, tag.name).map((route) => aboutRoute(api, route)),
  ]);
  const schemas = Object.entries(api.components.schemas).map(([name, schema]) =>
    make('details', { id: `schema-${name}`, class: 'docs-route' }, make('summary', {}, make('code', {}, name)), ...aboutSchema(schema)),
  );
  into.replaceChildren(
    make('p', {}, `Version ${api.info.version}. ${api.info.description}`),
    make('ul', {}, ...list, make('li', {}, make('a', { href: '#documents' }, 'Documents'))),
    ...groups,
    make('h2', { id: 'documents' }, 'Documents'),
    ...schemas,
  );
}

// What an address names is opened, also where a link within the page leads.
function openNamed(): void {
  const named = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (named instanceof HTMLDetailsElement) named.open = true;
  named?.scrollIntoView();
}

async function start(): Promise<void> {
  const into = document.getElementById('reference');
  if (!into) return;
  const answer = await fetch('/api/openapi.json');
  if (!answer.ok) throw new Error(`/api/openapi.json: ${answer.status}`);
  write((await answer.json()) as OpenApi, into);
  openNamed();
  addEventListener('hashchange', openNamed);
}

start().catch((error: unknown) => {
  document.getElementById('reference')?.replaceChildren(`The description could not be read: ${String(error)}`);
});
