// One machine in a small tile: 64 of them fit on a screen. The whole tile leads to the machine.
import { t } from '../../i18n/i18n';
import { Icon } from '../../parts/icon';
import { WireBar } from '../../parts/wire_progress';
import { isTorn } from '../../rules/lines';
import { hrefs } from '../../router';
import { isLost, type Machine } from '../../state/shop';
import { wordsOf } from './words';

export function MachineTile({ machine }: { machine: Machine }) {
  const { standing, alarms, onLine, share, program, sentence } = wordsOf(machine);
  const { key, tone } = standing.value;
  const core = machine.core.value;
  const state = t(`standing.${key}`);
  return (
    <a
      class={`tile tone-${tone}`}
      href={hrefs.machine(machine.name)}
      data-machine={machine.name}
      data-line={isTorn(core) ? 'torn' : core.line}
      data-standing={key}
    >
      <span class="tile-name">{machine.name}</span>
      <span class="tile-state">
        <Icon shape={tone} /> {isLost.value ? t('state.last_known', { state }) : state}
      </span>
      <span class="tile-program">
        {onLine.value ? (
          <>
            {share} {program}
          </>
        ) : (
          alarms.value > 0 && t('machine.alarms', { count: alarms.value })
        )}
      </span>
      <span class="tile-sentence">{sentence}</span>
      {onLine.value && <WireBar status={machine.status} />}
    </a>
  );
}
