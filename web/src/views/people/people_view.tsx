// What an administrator looks after: people, groups of machines, tokens, profiles, the servers, the store, and what everybody did.
// Approvers see the audit.
import { t } from '../../i18n/i18n';
import { hrefs, kPeoplePlaces, type PeoplePlace } from '../../router';
import { atLeast } from '../../rules/roles';
import { person } from '../../state/shop';
import { Audit } from './audit';
import { Groups } from './groups';
import { Machines } from './machines';
import { Servers } from './servers';
import { Store } from './store';
import { Tokens } from './tokens';
import { Users } from './users';

export function PeopleView({ place }: { place: PeoplePlace }) {
  const isAdmin = atLeast(person().role, 'admin');
  const places: readonly PeoplePlace[] = isAdmin ? kPeoplePlaces : kPeoplePlaces.filter((one) => one === 'audit');
  const here = places.includes(place) ? place : 'audit';
  if (!atLeast(person().role, 'approver')) return <p class="notice tone-waiting">{t('people.not_allowed')}</p>;
  return (
    <>
      <h1 tabIndex={-1}>{t('title.people')}</h1>
      <nav class="tabs" aria-label={t('people.places')}>
        {places.map((one) => (
          <a key={one} href={hrefs.people(one)} aria-current={one === here ? 'page' : undefined}>
            {t(`people.${one}`)}
          </a>
        ))}
      </nav>
      {here === 'users' && <Users />}
      {here === 'groups' && <Groups />}
      {here === 'tokens' && <Tokens />}
      {here === 'machines' && <Machines />}
      {here === 'servers' && <Servers />}
      {here === 'store' && <Store />}
      {here === 'audit' && <Audit />}
    </>
  );
}
