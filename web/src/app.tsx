// The page: sign-in or the signed-in views, chosen by the address.
import { useEffect, useRef } from 'preact/hooks';
import type { Session } from './api/types';
import { useRoute, type Route } from './route';
import type { State } from './state/state';
import { useStore, type Store } from './state/store';
import type { Sync } from './state/sync';
import { Alarms } from './views/alarms';
import { DeskContext } from './views/context';
import { Header } from './views/header';
import { JobView } from './views/job_view';
import { JobsView } from './views/jobs_view';
import { MachinesView } from './views/machines_view';
import { ReceivedView } from './views/received_view';
import { ReleasesView } from './views/releases_view';
import { SignIn } from './views/sign_in';

interface Props {
  store: Store;
  sync: Sync;
}

export function App({ store, sync }: Props) {
  const state = useStore(store);
  if (state.session === 'unknown') return <p class="waiting">Connecting…</p>;
  if (state.session === 'none') return <SignIn sync={sync} because={state.signedOutBecause} />;
  return <Desk store={store} sync={sync} state={state} session={state.session} />;
}

function Desk({ store, sync, state, session }: Props & { state: State; session: Session }) {
  const route = useRoute();
  const main = useRef<HTMLElement>(null);
  const place = route.view === 'job' ? `job ${route.id}` : route.view;
  const before = useRef(place);
  // After a change of view a keyboard goes on at its heading.
  useEffect(() => {
    if (before.current === place) return;
    before.current = place;
    scrollTo(0, 0);
    main.current?.querySelector('h1')?.focus();
  }, [place]);
  return (
    <DeskContext.Provider value={{ state, sync, session }}>
      <Header route={route} />
      <main ref={main} class={state.connection.phase === 'lost' ? 'main stale' : 'main'}>
        <Alarms seen={(key) => store.dispatch({ type: 'alarm_seen', key })} />
        {state.loaded ? <View route={route} /> : <p class="waiting">Loading…</p>}
      </main>
    </DeskContext.Provider>
  );
}

function View({ route }: { route: Route }) {
  switch (route.view) {
    case 'machines':
      return <MachinesView />;
    case 'jobs':
      return <JobsView />;
    case 'job':
      return <JobView key={route.id} id={route.id} />;
    case 'releases':
      return <ReleasesView />;
    case 'received':
      return <ReceivedView />;
  }
}
