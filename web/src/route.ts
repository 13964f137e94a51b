// Which view the address names. The part behind '#' is all that changes, so the server needs to know of one page only.
import { useEffect, useState } from 'preact/hooks';

export type Route = { view: 'machines' } | { view: 'jobs' } | { view: 'job'; id: number } | { view: 'releases' } | { view: 'received' };

export function routeOf(hash: string): Route {
  const parts = hash.replace(/^#\/?/, '').split('/');
  if (parts[0] === 'jobs' && parts[1] && /^[1-9]\d*$/.test(parts[1])) return { view: 'job', id: Number(parts[1]) };
  if (parts[0] === 'jobs') return { view: 'jobs' };
  if (parts[0] === 'releases') return { view: 'releases' };
  if (parts[0] === 'received') return { view: 'received' };
  return { view: 'machines' };
}

export const hrefOf = (route: Route): string => (route.view === 'job' ? `#/jobs/${route.id}` : `#/${route.view}`);

export function useRoute(): Route {
  const [route, setRoute] = useState(() => routeOf(location.hash));
  useEffect(() => {
    const changed = () => setRoute(routeOf(location.hash));
    addEventListener('hashchange', changed);
    return () => removeEventListener('hashchange', changed);
  }, []);
  return route;
}
