// One machine as a card. Every line of it has a fixed place and height: nothing that happens moves a button. What
// changes with each report of a feed is bound to its text or bar; the card itself is drawn when its standing changes.
import type { ReadonlySignal } from '@preact/signals';
import { t } from '../../i18n/i18n';
import { programText } from '../../orders/dialogs';
import { OrderBar } from '../../orders/order_bar';
import { Badge } from '../../parts/badge';
import { Icon } from '../../parts/icon';
import { WireBar } from '../../parts/wire_progress';
import { isTorn } from '../../rules/lines';
import { hrefs } from '../../router';
import { isLost, nextOf, queueOf, type Machine } from '../../state/shop';
import { wordsOf } from './words';

export function MachineCard({ machine }: { machine: Machine }) {
  const words = wordsOf(machine);
  const { key, tone } = words.standing.value;
  const core = machine.core.value;
  const line = isTorn(core) ? 'torn' : core.line;
  return (
    <article class={`card machine edge-${tone}`} aria-label={t('machine.label', { machine: machine.name })} data-line={line} data-standing={key}>
      <header class="machine-head">
        <h2>
          <a href={hrefs.machine(machine.name)} title={machine.head.value.title || undefined}>
            {machine.name}
          </a>
        </h2>
        <Badge wording={{ text: t(`standing.${key}`), tone }} old={isLost.value} />
      </header>
      <Text class="machine-sentence" text={words.sentence} />
      <OrderBar machine={machine} />
      <WireBar status={machine.status} />
      <OnLine machine={machine} />
      <p class="machine-block">
        <span class="block-line">{words.line}</span> <code>{words.block}</code>
      </p>
      <Text class="machine-remark" text={words.remark} />
      <Foot machine={machine} />
    </article>
  );
}

// One line; what does not fit is read by pointing at it.
const Text = ({ class: name, text }: { class: string; text: ReadonlySignal<string> }) => (
  <p class={name} title={text}>
    {text}
  </p>
);

// The program on the line, or the next one of the queue.
function OnLine({ machine }: { machine: Machine }) {
  const { onLine, program } = wordsOf(machine);
  const next = onLine.value ? undefined : (nextOf(machine.name) ?? undefined);
  const id = onLine.value ? machine.core.value.job : next?.id;
  return (
    <p class="machine-program">
      {next && <span class="quiet-text">{t('machine.next')} </span>}
      {id !== undefined && id !== null && (
        <>
          <strong>{next ? programText(next) : program}</strong> <a href={hrefs.job(id)}>{t('job.number', { job: id })}</a>
        </>
      )}
    </p>
  );
}

function Foot({ machine }: { machine: Machine }) {
  const queued = queueOf(machine.name).length;
  const open = wordsOf(machine).alarms.value;
  return (
    <p class="machine-foot">
      <a href={hrefs.machine(machine.name)}>{t('machine.queue', { count: queued })}</a>
      {open > 0 && (
        <a class="tone-bad machine-alarms" href={hrefs.alarms}>
          <Icon shape="bell" /> {t('machine.alarms', { count: open })}
        </a>
      )}
    </p>
  );
}
