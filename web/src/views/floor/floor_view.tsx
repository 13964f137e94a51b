// All machines: as cards with their orders, compact, or as a board for a screen on the wall. The order is by what needs
// a person, and stands still while a person looks: it is taken when the view opens and when a person asks for it. What
// needs a person since then stands in the strip above, at once.
import { useComputed, useSignal } from '@preact/signals';
import { t } from '../../i18n/i18n';
import { Empty } from '../../parts/empty';
import { Icon } from '../../parts/icon';
import { atLeast } from '../../rules/roles';
import { kNeedsPerson } from '../../rules/standing';
import { changeQuery, hrefs, route } from '../../router';
import { machines, person, type Machine } from '../../state/shop';
import { MachineCard } from './machine_card';
import { MachineTile } from './machine_tile';
import { wordsOf } from './words';

const kLooks = ['cards', 'compact', 'andon'] as const;
type Look = (typeof kLooks)[number];

const lookOf = (text: string | null): Look => kLooks.find((look) => look === text) ?? 'cards';

const need = (machine: Machine): number => wordsOf(machine).need.value;

function byNeed(list: readonly Machine[]): string[] {
  const needs = new Map(list.map((machine) => [machine.name, need(machine)]));
  return list
    .map((machine) => machine.name)
    .sort((a, b) => (needs.get(b) ?? 0) - (needs.get(a) ?? 0) || a.localeCompare(b, undefined, { numeric: true }));
}

export function FloorView() {
  const look = lookOf(route.value.query.get('look'));
  const order = useSignal<string[]>([]);
  const all = machines.value;
  const fresh = useComputed(() => byNeed([...machines.value.values()]));
  if (all.size === 0) return <NoMachine />;
  // A machine that came, or one that went, keeps the place of the others.
  const kept = order.value.filter((name) => all.has(name));
  if (kept.length === 0) order.value = byNeed([...all.values()]);
  const missing = [...all.keys()].filter((name) => !order.value.includes(name));
  const names = look === 'andon' ? fresh.value : [...(kept.length === 0 ? order.value : kept), ...missing];
  const resort = () => {
    order.value = fresh.peek();
  };
  const list = names.map((name) => all.get(name)).filter((machine) => machine !== undefined);
  return (
    <>
      <div class="floor-head">
        <h1 tabIndex={-1}>{t('floor.title')}</h1>
        <div class="segments" role="group" aria-label={t('floor.look')}>
          {kLooks.map((one) => (
            <button key={one} type="button" aria-pressed={one === look} onClick={() => changeQuery('look', one === 'cards' ? null : one)}>
              {t(`floor.look_${one}`)}
            </button>
          ))}
        </div>
        <button type="button" class="button button-small" onClick={resort}>
          {t('floor.sort')}
        </button>
      </div>
      {look !== 'andon' && <Needs />}
      {look === 'cards' ? (
        <div class="cards">
          {list.map((machine) => (
            <MachineCard key={machine.name} machine={machine} />
          ))}
        </div>
      ) : (
        <div class={look === 'andon' ? 'tiles tiles-andon' : 'tiles'}>
          {list.map((machine) => (
            <MachineTile key={machine.name} machine={machine} />
          ))}
        </div>
      )}
    </>
  );
}

// One line, always there and always as high, so that nothing moves when it fills.
function Needs() {
  const needing = useComputed(() =>
    [...machines.value.values()].filter((machine) => need(machine) > kNeedsPerson).sort((a, b) => need(b) - need(a)),
  );
  return (
    <nav class="needs" aria-label={t('floor.needs_label')}>
      <span class="needs-head">{t('floor.needs', { count: needing.value.length })}</span>
      <ul>
        {needing.value.map((machine) => (
          <Need key={machine.name} machine={machine} />
        ))}
      </ul>
    </nav>
  );
}

function Need({ machine }: { machine: Machine }) {
  const { key, tone } = wordsOf(machine).standing.value;
  return (
    <li>
      <a class={`needs-one tone-${tone}`} href={hrefs.machine(machine.name)}>
        <Icon shape={tone} />
        <strong>{machine.name}</strong> {t(`standing.${key}`)}
      </a>
    </li>
  );
}

function NoMachine() {
  const may = atLeast(person().role, 'admin');
  return (
    <>
      <h1 tabIndex={-1}>{t('floor.title')}</h1>
      <Empty
        action={
          may && (
            <a class="button button-main" href={hrefs.newProfile()}>
              {t('machine.add')}
            </a>
          )
        }
      >
        {t(may ? 'floor.empty_admin' : 'floor.empty')}
      </Empty>
    </>
  );
}
