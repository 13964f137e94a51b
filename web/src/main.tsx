// The dashboard. Folders: api (requests and documents), live (the event stream, one a browser), state (all that is known
// as signals, and the loader that keeps it like the server's), rules (what follows from it), format (numbers, times,
// names as words), i18n (the words), orders (what a person sets in motion or stops), parts (what several views are made
// of), views (what is shown). Views never ask the server for what the state should know; rules know no browser and no
// words, so plain tests run them.
import { render } from 'preact';
import '@preact/signals';
import { App } from './app';
import { preferredLanguage, speak } from './i18n/i18n';
import { startRouter } from './router';
import { loader } from './state/loader';
import './styles/app.css';
import { readSettings } from './views/alarms/signals';
import { announceAlarms } from './views/alarms/tray';

startRouter();
readSettings();
announceAlarms();
await speak(preferredLanguage());
const root = document.getElementById('app');
if (root) render(<App />, root);
openAllForPrint();
await loader.begin();

// What is folded on the screen is open on paper.
function openAllForPrint(): void {
  let opened: HTMLDetailsElement[] = [];
  addEventListener('beforeprint', () => {
    opened = [...document.querySelectorAll<HTMLDetailsElement>('main details:not([open])')];
    for (const one of opened) one.open = true;
  });
  addEventListener('afterprint', () => {
    for (const one of opened) one.open = false;
    opened = [];
  });
}
