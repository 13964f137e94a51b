// The dashboard. Folders: api (requests and documents), live (the event stream), state (all that is known, and how it
// changes), rules (what follows from it), format (words, numbers, times), views (what is shown). Views never fetch by
// themselves what the state should know; rules and format know no browser, so plain tests run them.
import { render } from 'preact';
import { App } from './app';
import { Store } from './state/store';
import { Sync } from './state/sync';
import './styles/app.css';

const store = new Store();
const sync = new Sync(store);
const root = document.getElementById('app');
if (root) render(<App store={store} sync={sync} />, root);
void sync.begin();
