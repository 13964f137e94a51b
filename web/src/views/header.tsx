// The head of the page: where one is, what asks for a person, whether what one sees is live, who one is.
import { useState } from 'preact/hooks';
import { clockTime } from '../format/times';
import { chooseLanguage, kLanguages, spoken, t } from '../i18n/i18n';
import type { Role } from '../api/types';
import { Icon } from '../parts/icon';
import { hrefs, route, type ViewName } from '../router';
import { atLeast } from '../rules/roles';
import { loader } from '../state/loader';
import { connection, loaded, loadError, person } from '../state/shop';
import { setTour } from '../state/tour';
import { AlarmBell } from './alarms/tray';
import { showKeys } from './show_keys';

const kPlaces: { views: ViewName[]; href: string; label: string; from?: Role }[] = [
  { views: ['floor', 'machine'], href: hrefs.floor, label: 'nav.floor' },
  { views: ['orders', 'order'], href: hrefs.orders, label: 'nav.orders' },
  { views: ['jobs', 'job', 'history'], href: hrefs.jobs, label: 'nav.jobs' },
  { views: ['releases'], href: hrefs.releases, label: 'nav.releases' },
  { views: ['review', 'reviewed'], href: hrefs.review, label: 'nav.review', from: 'approver' },
  { views: ['library', 'program'], href: hrefs.library, label: 'nav.library' },
  { views: ['families', 'family', 'part'], href: hrefs.families, label: 'nav.parts' },
  { views: ['received'], href: hrefs.received, label: 'nav.received' },
  { views: ['alarms'], href: hrefs.alarms, label: 'nav.alarms' },
  { views: ['people', 'profile'], href: hrefs.people(), label: 'nav.people', from: 'approver' },
];

export function Header() {
  const here = route.value.view;
  return (
    <header class="top">
      <a class="skip" href="#main" onClick={skipToMain}>
        {t('nav.skip')}
      </a>
      <div class="top-row">
        <a class="brand" href={hrefs.floor}>
          dripfeed
        </a>
        <nav class="places" aria-label={t('nav.label')}>
          {kPlaces.filter(({ from }) => atLeast(person().role, from ?? 'viewer')).map(({ views, href, label }) => (
            <a key={href} href={href} aria-current={views.includes(here) ? 'page' : undefined}>
              {t(label)}
            </a>
          ))}
          <a href="/docs">{t('nav.docs')}</a>
        </nav>
        <AlarmBell />
        <ConnectionSign />
        <Person />
      </div>
      <LostBanner />
    </header>
  );
}

function takeTour(event: Event): void {
  if (event.currentTarget instanceof Element) event.currentTarget.closest('details')?.removeAttribute('open');
  setTour(0);
}

function skipToMain(event: Event): void {
  event.preventDefault();
  document.querySelector<HTMLElement>('main h1')?.focus();
}

function Person() {
  const [error, setError] = useState(false);
  const { name, role } = person();
  return (
    <details class="who">
      <summary>
        {name} <span class="quiet-text">{t(`role.${role}`)}</span>
      </summary>
      <div class="who-box">
        <label class="field">
          <span>{t('language.label')}</span>
          <select value={spoken.value.tag} onChange={(event) => void chooseLanguage(event.currentTarget.value)}>
            {kLanguages.map(({ tag, name: own }) => (
              <option key={tag} value={tag} lang={tag}>
                {own}
              </option>
            ))}
          </select>
        </label>
        <button type="button" class="button" onClick={takeTour}>
          {t('nav.tour')}
        </button>
        <button type="button" class="button" onClick={showKeys}>
          {t('nav.keys')}
        </button>
        <button type="button" class="button" onClick={() => void loader.signOut().catch(() => setError(true))}>
          {t('session.sign_out')}
        </button>
        {error && (
          <p class="notice tone-bad" role="alert">
            {t('session.still_in')}
          </p>
        )}
      </div>
    </details>
  );
}

function ConnectionSign() {
  const { phase } = connection.value;
  return (
    <span class={`connection ${phase === 'live' ? 'tone-good' : 'tone-waiting'}`} role="status" data-phase={phase}>
      <Icon shape={phase === 'live' ? 'good' : 'waiting'} /> {t(`connection.${phase}`)}
    </span>
  );
}

function LostBanner() {
  const now = connection.value;
  if (now.phase !== 'lost') return null;
  return (
    <div class="lost" role="alert">
      <Icon shape="bad" />
      <p>
        <strong>{t('lost.title')}</strong> {loaded.value && now.heardAt > 0 && t('lost.old', { time: clockTime(now.heardAt) })}
        {loadError.value && ` ${loadError.value}`}
      </p>
    </div>
  );
}
