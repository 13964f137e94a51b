// The sheet of the page's keys: what each place answers to. "?" shows it, and the person's menu for who has no keyboard at hand.
import type { ComponentChildren } from 'preact';
import { t } from '../i18n/i18n';
import { BackButton, Dialog } from '../parts/dialog';
import { Facts } from '../parts/facts';
import { hasKeySheetKey, keepKeySheetKey } from '../state/key_sheet';

type Row = [keys: string, means: string];

// A key's name that is a word is one of the catalogue: "keys.cap_tab".
const kPlaces: { title: string; rows: Row[] }[] = [
  {
    title: 'keys.everywhere',
    rows: [
      ['Tab', 'keys.next'],
      ['Enter', 'keys.press'],
      ['Esc', 'keys.close'],
      ['?', 'keys.sheet'],
    ],
  },
  {
    title: 'keys.text',
    rows: [
      ['Ctrl+S', 'keys.save'],
      ['Ctrl+Z', 'keys.undo'],
      ['Ctrl+Y', 'keys.redo'],
      ['Ctrl+F', 'keys.find'],
      ['F3', 'keys.find_next'],
      ['F8', 'keys.next_fault'],
      ['Ctrl+Alt+G', 'keys.line'],
      ['Alt+↑ ↓', 'keys.move_line'],
    ],
  },
  {
    title: 'path.picture',
    rows: [
      ['← → ↑ ↓', 'keys.turn'],
      ['Shift+← → ↑ ↓', 'keys.move'],
      ['+ −', 'keys.zoom'],
      ['1 2 3 4', 'keys.view'],
    ],
  },
  {
    title: 'plots.title',
    rows: [
      ['← →', 'keys.move'],
      ['+ −', 'keys.zoom'],
      ['0', 'keys.whole'],
    ],
  },
];

const cap = (keys: string): ComponentChildren => <kbd>{keys.replace('Ctrl', t('keys.ctrl')).replace('Shift', t('keys.shift'))}</kbd>;

export const KeySheet = () => (
  <Dialog title={t('nav.keys')}>
    <div class="sheet">
      {kPlaces.map(({ title, rows }) => (
        <section key={title} aria-label={t(title)}>
          <h3>{t(title)}</h3>
          <Facts facts={rows.map(([keys, means]) => [t(means), cap(keys)])} />
        </section>
      ))}
      <p class="quiet-text">{t('keys.mac')}</p>
      <label class="check">
        <input type="checkbox" defaultChecked={hasKeySheetKey()} onChange={(event) => keepKeySheetKey(event.currentTarget.checked)} />{' '}
        <span>{t('keys.by_key')}</span>
      </label>
      <div class="dialog-buttons">
        <BackButton />
      </div>
    </div>
  </Dialog>
);
