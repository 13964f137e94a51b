// One machine, whole: what it does and its orders, the running block among its neighbours, its queue, history, use,
// alarms and line. A tablet at the machine is bound to it by ?station=1: then the rest of the page steps back.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import type { MachineWhole, Utilisation } from '../../api/types';
import { dialectText, stallText } from '../../format/words';
import { duration } from '../../format/times';
import { t } from '../../i18n/i18n';
import { showDialog } from '../../parts/dialog';
import { Arranged, type DrawnPart } from '../../parts/arrange';
import { Badge } from '../../parts/badge';
import { Facts } from '../../parts/facts';
import { Failure } from '../../parts/failure';
import { lazyView } from '../../parts/lazy';
import { WireBar, WireFigures } from '../../parts/wire_progress';
import { OrderBar } from '../../orders/order_bar';
import { ResumeAsDc1Dialog } from '../../orders/dialogs';
import { byUrgency } from '../../rules/alarms';
import { offerFor } from '../../rules/job_actions';
import { hasJob, isTorn } from '../../rules/lines';
import { changeQuery, hrefs, route } from '../../router';
import { alarms, isLive, isLost, machines, roleOn, type Machine } from '../../state/shop';
import { loader } from '../../state/loader';
import { AlarmList } from '../alarms/item';
import { wordsOf } from '../floor/words';
import { NotFound } from '../not_found';
import { Blocks } from './blocks';
import { Calibration } from './calibration';
import { LinePart } from './line';
import { Outlook } from './outlook';
import { Queue } from './queue';
import { Use } from './use';

// Below what a person looks for first, so its code comes after it.
const StopReasons = lazyView(() => import('../orders/stop_reasons').then((file) => file.StopReasons));
const History = lazyView(() => import('./history').then((file) => file.History));

export function MachineView({ name }: { name: string }) {
  const machine = machines.value.get(name);
  if (!machine) return <NotFound what={t('not_found.machine', { machine: name })} />;
  return <Whole key={name} machine={machine} />;
}

function Whole({ machine }: { machine: Machine }) {
  const core = machine.core.value;
  const { standing, sentence, remark } = wordsOf(machine);
  const { key, tone } = standing.value;
  const whole = useWhole(machine);
  const isStation = route.value.query.get('station') === '1';
  return (
    <div class="machine-view" data-line={isTorn(core) ? 'torn' : core.line} data-standing={key}>
      <header class={`card machine-top edge-${tone}`}>
        <div class="machine-head">
          <h1 tabIndex={-1}>{machine.name}</h1>
          <Badge wording={{ text: t(`standing.${key}`), tone }} old={isLost.value} />
        </div>
        <p class="quiet-text">
          {machine.head.value.title} · {dialectText(machine.head.value.dialect)}, {t(`kind.${machine.head.value.kind}`)}
        </p>
        <p class="machine-sentence machine-sentence-big" title={sentence}>
          {sentence}
        </p>
        <OrderBar machine={machine} />
        <WireBar status={machine.status} />
        <p class="machine-remark">{remark}</p>
      </header>
      <Arranged name="machine" class="machine-parts" parts={partsOf(machine, whole)} isBound={isStation} />
      <label class="choice">
        <input type="checkbox" checked={isStation} onChange={(event) => changeQuery('station', event.currentTarget.checked ? '1' : null)} />
        {t('station.bind')}
      </label>
    </div>
  );
}

// What is on the line and what asks for a person cannot be hidden.
const partsOf = (machine: Machine, whole: MachineWhole | null): DrawnPart[] => [
  { id: 'on_line', column: 0, isFixed: true, title: t('machine.on_line'), draw: () => <OnLine machine={machine} /> },
  { id: 'stops', column: 0, title: t('stops.title'), draw: () => <StoppedJob machine={machine} /> },
  { id: 'queue', column: 0, title: t('queue.title'), draw: () => <Queue machine={machine} /> },
  { id: 'line', column: 0, title: t('line.title'), draw: () => <LinePart machine={machine} whole={whole} /> },
  { id: 'history', column: 0, title: t('history.title'), draw: () => <History machine={machine.name} /> },
  { id: 'alarms', column: 1, isFixed: true, title: t('nav.alarms'), draw: () => <MachineAlarms name={machine.name} /> },
  { id: 'use', column: 1, title: t('use.title'), draw: () => <UsePart name={machine.name} /> },
  { id: 'calibration', column: 1, title: t('calibration.title'), draw: () => <Calibration whole={whole} /> },
];

// The machine with its profile, as of the revision that is known; null while it is not there.
function useWhole(machine: Machine): MachineWhole | null {
  const [whole, setWhole] = useState<MachineWhole | null>(null);
  const revision = machine.head.value.revision;
  useEffect(() => {
    loader.order(calls.machine(machine.name)).then(setWhole, () => setWhole(null));
  }, [machine.name, revision]);
  return whole;
}

function OnLine({ machine }: { machine: Machine }) {
  const status = machine.status.value;
  const { job: onLine, program } = wordsOf(machine);
  const job = onLine.value;
  if (!hasJob(status) || status.job === null) return null;
  return (
    <section class="card" aria-label={t('machine.on_line')}>
      <h2>
        {program} <a href={hrefs.job(status.job)}>{t('job.number', { job: status.job })}</a>
      </h2>
      {job && <Outlook machine={machine.name} job={job} status={status} />}
      {job && <Blocks job={job} from={status.block_from} to={status.block} />}
      <p class="hint">{t('machine.executed_unknown')}</p>
      <details>
        <summary>{t('page.details')}</summary>
        <WireFigures status={status} />
        <Facts
          facts={[
            [t('fact.wire_state'), t('wire.state', { line: status.line, stall: status.stall ? stallText(status.stall) : '–' })],
            [t('fact.holds'), t('wire.holds', { count: status.holds, time: duration(status.hold_s) })],
            [t('fact.line_use'), `${(status.line_use * 100).toFixed(1)} %`],
          ]}
        />
        {job && offerFor(job, status, roleOn(machine.name), isLive.value).actions.includes('resume_as_dc1') && (
          <button type="button" class="button" onClick={() => showDialog(<ResumeAsDc1Dialog id={job.id} />)}>
            {t('order.resume_as_dc1')}
          </button>
        )}
      </details>
    </section>
  );
}

// Of the job that a person stopped, or that did not end well.
function StoppedJob({ machine }: { machine: Machine }) {
  const { job, standing } = wordsOf(machine);
  const now = job.value;
  const broke = now !== null && (now.state === 'failed' || now.state === 'interrupted' || now.state === 'cancelled');
  return now && now.started_at_ms !== null && (broke || standing.value.key === 'stopped') ? <StopReasons key={now.id} job={now} /> : null;
}

function MachineAlarms({ name }: { name: string }) {
  const own = [...alarms.value.values()].filter((alarm) => alarm.machine === name).sort(byUrgency);
  return (
    <section class="card" aria-label={t('nav.alarms')}>
      <h2>{t('nav.alarms')}</h2>
      {own.length === 0 ? (
        <p class="quiet-text">{t('alarms.none_open')}</p>
      ) : (
        <AlarmList alarms={own} />
      )}
    </section>
  );
}

const kDays = 7;

function UsePart({ name }: { name: string }) {
  const [use, setUse] = useState<Utilisation | null>(null);
  const [error, setError] = useState<unknown>(null);
  useEffect(() => {
    loader.order(calls.utilisation(name, kDays)).then(setUse, setError);
  }, [name]);
  return (
    <section class="card" aria-label={t('use.title')}>
      <h2>{t('use.title')}</h2>
      <Failure error={error} />
      {use && <Use days={use.days} />}
    </section>
  );
}
