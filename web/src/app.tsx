// The page: sign-in or the signed-in views, chosen by the address.
import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import { dateTime } from './format/times';
import { t } from './i18n/i18n';
import { minutes } from './parts/clock';
import { BackButton, Dialog, DialogHost, showDialog } from './parts/dialog';
import { ErrorBoundary } from './parts/error_boundary';
import { Failure } from './parts/failure';
import { lazyView } from './parts/lazy';
import { deskView, forgetAddress, rememberedScroll, route, type Route, type ViewName } from './router';
import { loader } from './state/loader';
import { connection, loaded, loadError, person, programName, session } from './state/shop';
import { tourStep } from './state/tour';
import { AlarmsView } from './views/alarms/alarms_view';
import { asking } from './views/alarms/tray';
import { FloorView } from './views/floor/floor_view';
import { Header } from './views/header';
import { JobView } from './views/job_view';
import { JobsView } from './views/jobs_view';
import { MachineView } from './views/machine/machine_view';
import { NotFound } from './views/not_found';
import { ReleasesView } from './views/releases_view';
import { useKeySheet } from './views/show_keys';
import { SignIn } from './views/sign_in';

export function App() {
  if (session.value === 'unknown') return <p class="waiting">{t('connection.connecting')}</p>;
  if (session.value === 'none') return <SignIn />;
  return <Desk />;
}

function Desk() {
  const { address, view, query } = route.value;
  const place = address.split('?', 1)[0] ?? '';
  const main = useRef<HTMLElement>(null);
  const before = useRef(place);
  useTitle(route.value);
  useBadge(route.value);
  useKeySheet();
  // After a change of view a keyboard goes on at its heading, and one who goes back finds the place again. At once: later
  // it could take the focus from a field into which a person types by then.
  useLayoutEffect(() => {
    if (before.current === place) return;
    before.current = place;
    main.current?.querySelector('h1')?.focus({ preventScroll: true });
    scrollTo(0, rememberedScroll(address));
  }, [place]);
  const isAlone = query.get('station') === '1' || query.get('look') === 'andon';
  return (
    <div class={`desk${isAlone ? ' desk-alone' : ''}${connection.value.phase === 'lost' ? ' stale' : ''}`} data-view={view}>
      <Header />
      {tourStep.value !== null && loaded.value && <Tour />}
      <main ref={main} id="main" class="main">
        <PrintHead />
        <ErrorBoundary where={address}>{loaded.value ? <View here={route.value} /> : <Loading />}</ErrorBoundary>
      </main>
      <DialogHost />
    </div>
  );
}

// Whose paper it is: what it shows was so at this time.
const PrintHead = () => (
  <p class="print-only print-head">
    {t('print.head', { name: person().name, time: dateTime(minutes.value), address: `${location.host}/#${route.value.address}` })}
  </p>
);

const Loading = () => (
  <p class="waiting" role="status">
    {loadError.value ?? t('page.loading')}
  </p>
);

const Tour = lazyView(() => import('./views/tour').then((one) => one.Tour));
const DeskHalf = lazyView(() => import('./views/desk').then((half) => half.DeskHalf));

function View({ here }: { here: Route }) {
  const [first = ''] = here.parameters;
  const desk = deskView(here.view);
  if (desk) return <DeskHalf view={desk} parameters={here.parameters} query={here.query} />;
  switch (here.view) {
    case 'floor':
    case 'badge':
    case 'sign_in':
      return <FloorView />;
    case 'machine':
      return <MachineView name={first} />;
    case 'jobs':
      return <JobsView />;
    case 'job':
      return <JobView key={first} id={Number(first)} />;
    case 'alarms':
      return <AlarmsView />;
    case 'releases':
      return <ReleasesView />;
    default:
      return <NotFound />;
  }
}

// A badge that is scanned while a person is signed in: from here on it is its person. A badge that is not valid changes
// nothing.
function useBadge(here: Route): void {
  const [badge] = here.parameters;
  useEffect(() => {
    if (here.view === 'sign_in') forgetAddress(); // another tab has signed in meanwhile
    if (here.view !== 'badge' || badge === undefined) return;
    forgetAddress();
    loader.signIn({ token: badge }).catch((error: unknown) =>
      showDialog(
        <Dialog title={t('badge.refused')}>
          <Failure error={error} />
          <BackButton />
        </Dialog>,
      ),
    );
  }, [here.view, badge]);
}

// The tab's title says where one is, and first how many alarms ask for a person.
function useTitle(here: Route): void {
  const [first = ''] = here.parameters;
  const named: Partial<Record<ViewName, string>> = { machine: first, job: t('job.title', { job: first }), family: first, program: programName(Number(first)) ?? t('title.program'), part: t('parts.title', { number: first }) };
  const name = named[here.view] ?? t(`title.${here.view}`);
  const count = asking.value.length;
  useEffect(() => {
    document.title = `${count > 0 ? `(${count}) ` : ''}${name} – dripfeed`;
  }, [name, count]);
}
