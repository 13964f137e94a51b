// Addresses of the page. All of them stand after '#', so the server knows one page only. A row says which view it is
// and what its parameters are; an address that no row has is "not found", never another view.
import { signal } from '@preact/signals';

export type ViewName = 'floor' | 'machine' | 'jobs' | 'job' | 'alarms' | 'releases' | 'badge' | 'sign_in' | DeskView | 'not_found';

export const kPeoplePlaces = ['users', 'groups', 'tokens', 'machines', 'servers', 'store', 'audit'] as const;
export type PeoplePlace = (typeof kPeoplePlaces)[number];

// The half of the page for who does not stand at a machine; its code is loaded when it is asked for.
export const kDeskViews = ['received', 'orders', 'order', 'history', 'review', 'reviewed', 'library', 'program', 'families', 'family', 'part', 'people', 'profile'] as const;
export type DeskView = (typeof kDeskViews)[number];
export const deskView = (view: ViewName): DeskView | undefined => kDeskViews.find((one) => one === view);

export interface Route {
  view: ViewName;
  parameters: readonly string[];
  query: URLSearchParams;
  address: string; // what follows '#'
}

interface Row {
  view: ViewName;
  pattern: RegExp;
}

const kRows: Row[] = [
  { view: 'floor', pattern: /^\/?$/ },
  { view: 'machine', pattern: /^\/machines\/([^/]+)$/ },
  { view: 'floor', pattern: /^\/(?:floor|machines)$/ },
  { view: 'job', pattern: /^\/jobs\/([1-9]\d{0,15})$/ },
  { view: 'jobs', pattern: /^\/jobs$/ },
  { view: 'alarms', pattern: /^\/alarms$/ },
  { view: 'releases', pattern: /^\/releases$/ },
  { view: 'received', pattern: /^\/received$/ },
  { view: 'history', pattern: /^\/history$/ },
  { view: 'orders', pattern: /^\/orders$/ },
  { view: 'order', pattern: /^\/orders\/([1-9]\d{0,15})$/ },
  { view: 'review', pattern: /^\/review$/ },
  { view: 'reviewed', pattern: /^\/review\/([1-9]\d{0,15})$/ },
  { view: 'library', pattern: /^\/(?:library|programs)$/ },
  { view: 'program', pattern: /^\/programs\/([1-9]\d{0,15})(?:\/(revisions|compare|uses|files|checks|release))?$/ },
  { view: 'families', pattern: /^\/(?:families|parts)$/ },
  { view: 'family', pattern: /^\/families\/([^/]+)$/ },
  { view: 'part', pattern: /^\/parts\/([^/]+)$/ },
  { view: 'people', pattern: new RegExp(`^/people(?:/(${kPeoplePlaces.join('|')}))?$`) },
  { view: 'profile', pattern: /^\/machines\/([^/]+)\/profile$/ },
  { view: 'profile', pattern: /^\/new-machine$/ },
  { view: 'badge', pattern: /^\/badge\/([^/]+)$/ },
  { view: 'sign_in', pattern: /^\/sign-in$/ },
];

export function routeOf(hash: string): Route {
  const address = hash.replace(/^#/, '');
  const [path = '', query = ''] = address.split('?', 2);
  for (const { view, pattern } of kRows) {
    const found = pattern.exec(path);
    if (!found) continue;
    const parameters = decoded(found.slice(1));
    if (parameters) return { view, parameters, query: new URLSearchParams(query), address };
  }
  return { view: 'not_found', parameters: [], query: new URLSearchParams(query), address };
}

// Null where an escape is broken.
function decoded(values: (string | undefined)[]): string[] | null {
  try {
    return values.map((value) => decodeURIComponent(value ?? ''));
  } catch {
    return null;
  }
}

export const hrefs = {
  floor: '#/floor',
  andon: '#/floor?look=andon',
  machine: (name: string) => `#/machines/${encodeURIComponent(name)}`,
  jobs: '#/jobs',
  job: (id: number) => `#/jobs/${id}`,
  alarms: '#/alarms',
  releases: '#/releases',
  received: '#/received',
  history: '#/history',
  orders: '#/orders',
  order: (id: number) => `#/orders/${id}`,
  review: '#/review',
  reviewed: (release: number) => `#/review/${release}`,
  library: '#/library',
  libraryOf: (query: Record<string, string>) => `#/library?${new URLSearchParams(query)}`,
  program: (id: number, place: ProgramPlace = 'text', query: Record<string, string> = {}) => {
    const asked = new URLSearchParams(query).toString();
    return `#/programs/${id}${place === 'text' ? '' : `/${place}`}${asked ? `?${asked}` : ''}`;
  },
  families: '#/families',
  family: (name: string) => `#/families/${encodeURIComponent(name)}`,
  people: (place: PeoplePlace = 'users') => `#/people/${place}`,
  profile: (name: string) => `#/machines/${encodeURIComponent(name)}/profile`,
  newProfile: (of?: string) => `#/new-machine${of === undefined ? '' : `?of=${encodeURIComponent(of)}`}`,
  part: (number: string) => `#/parts/${encodeURIComponent(number)}`,
};

export const kProgramPlaces = ['text', 'revisions', 'compare', 'uses', 'files', 'checks', 'release'] as const;
export type ProgramPlace = (typeof kProgramPlaces)[number];

export const route = signal<Route>(routeOf(''));

// An address that must not stay in the browser's history, such as a badge's, is replaced by the floor.
export function forgetAddress(): void {
  history.replaceState(null, '', hrefs.floor);
  route.value = routeOf(location.hash);
}

// How far each address was scrolled when it was left.
const scrolled = new Map<string, number>();

export function startRouter(): void {
  // A path that people type or keep, "/jobs/3", is the same address after '#'.
  if (location.pathname !== '/') history.replaceState(null, '', `/${location.hash || `#${location.pathname}${location.search}`}`);
  route.value = routeOf(location.hash);
  history.scrollRestoration = 'manual';
  addEventListener('hashchange', () => {
    route.value = routeOf(location.hash);
  });
  addEventListener('scroll', () => scrolled.set(route.peek().address, scrollY), { passive: true });
}

export const rememberedScroll = (address: string): number => scrolled.get(address) ?? 0;

// Another query of the same view, without a step in the browser's history.
export function changeQuery(name: string, value: string | null): void {
  const { address, query } = route.peek();
  const next = new URLSearchParams(query);
  if (value === null) next.delete(name);
  else next.set(name, value);
  const text = next.toString();
  history.replaceState(null, '', `#${pathOf(address)}${text ? `?${text}` : ''}`);
  route.value = routeOf(location.hash);
}

export function go(href: string): void {
  location.hash = href;
}

const pathOf = (address: string): string => address.split('?', 1)[0] ?? '';

// For what an answer leads to. Whoever has gone to another place before it came stays there.
export function goUnlessLeft(): (href: string) => void {
  const asked = pathOf(route.peek().address);
  return (href) => {
    if (pathOf(route.peek().address) === asked) go(href);
  };
}
