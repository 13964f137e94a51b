// The head of the page: where one is, whether what one sees is live, who one is.
import { useState } from 'preact/hooks';
import { clockTime } from '../format/times';
import { hrefOf, type Route } from '../route';
import { Icon } from './badge';
import { useDesk } from './context';

const kPlaces: { route: Route; label: string }[] = [
  { route: { view: 'machines' }, label: 'Machines' },
  { route: { view: 'jobs' }, label: 'Jobs' },
  { route: { view: 'releases' }, label: 'New job' },
  { route: { view: 'received' }, label: 'Received' },
];

export function Header({ route }: { route: Route }) {
  const { sync, session } = useDesk();
  const [error, setError] = useState(false);
  const here = route.view === 'job' ? 'jobs' : route.view;
  const signOut = () => void sync.signOut().catch(() => setError(true));
  return (
    <header class="top">
      <div class="top-row">
        <a class="brand" href={hrefOf({ view: 'machines' })}>
          dripfeed
        </a>
        <nav aria-label="Views">
          {kPlaces.map(({ route: to, label }) => (
            <a key={to.view} href={hrefOf(to)} aria-current={to.view === here ? 'page' : undefined}>
              {label}
            </a>
          ))}
        </nav>
        <ConnectionSign />
        <div class="who">
          <span>
            {session.name} <span class="quiet-text">{session.role}</span>
          </span>
          <button type="button" class="button button-small" onClick={signOut}>
            Sign out
          </button>
        </div>
      </div>
      {error && (
        <p class="notice tone-bad" role="alert">
          The server did not answer: you are still signed in.
        </p>
      )}
      <LostBanner />
    </header>
  );
}

function ConnectionSign() {
  const { phase } = useDesk().state.connection;
  if (phase === 'live')
    return (
      <span class="connection tone-good" role="status">
        <Icon tone="good" /> live
      </span>
    );
  return (
    <span class="connection tone-waiting" role="status">
      <Icon tone="waiting" /> {phase === 'connecting' ? 'connecting…' : 'not live'}
    </span>
  );
}

function LostBanner() {
  const { connection, loaded, loadError } = useDesk().state;
  if (connection.phase !== 'lost') return null;
  return (
    <div class="lost" role="alert">
      <Icon tone="bad" />
      <p>
        <strong>The connection to the server is lost</strong>, trying again.{' '}
        {loaded && `What is shown here was true at ${clockTime(connection.since)} at the latest and may be wrong now.`}
        {loadError && ` ${loadError}`}
      </p>
    </div>
  );
}
