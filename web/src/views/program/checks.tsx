// Checks of this program: the verdicts so far, a new one for a machine, and what one found, each finding with its line.
import { useState } from 'preact/hooks';
import { newOrderKey } from '../../api/client';
import { deskCalls } from '../../api/desk_calls';
import type { Delivery, Outcome, Program, Verdict } from '../../api/types';
import { count } from '../../format/numbers';
import { dateTime, duration } from '../../format/times';
import { deliveryText, kDeliveries, wordingOfOutcome } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Badge } from '../../parts/badge';
import { Empty } from '../../parts/empty';
import { Facts } from '../../parts/facts';
import { Failure } from '../../parts/failure';
import { Icon } from '../../parts/icon';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { go, hrefs } from '../../router';
import { atLeast } from '../../rules/roles';
import { findingsOf, type Finding } from '../../rules/verdicts';
import { loader } from '../../state/loader';
import { bestRole, machines, roleOn } from '../../state/shop';
import type { PlaceProps } from './program_view';

export function ChecksPlace({ program, query }: PlaceProps) {
  const may = maySomewhere(program);
  const { value: verdicts, error, again } = useLoaded(String(program.id), () => deskCalls.checks(program.id));
  const shown = Number(query.get('check')) || verdicts?.[0]?.id || null;
  return (
    <>
      {may && (
        <CheckForm
          program={program.id}
          revision={program.revision}
          dialect={program.dialect}
          done={(verdict) => {
            again();
            go(hrefs.program(program.id, 'checks', { check: String(verdict.id) }));
          }}
        />
      )}
      <Failure error={error} />
      {verdicts?.length === 0 && <Empty>{t(may ? 'checks.none' : 'checks.none_viewer')}</Empty>}
      {verdicts && verdicts.length > 0 && (
        <Table
          label={t('program_place.checks')}
          rows={verdicts}
          keyOf={({ id }) => id}
          marks={({ id }) => (id === shown ? { 'data-shown': 'true' } : {})}
          columns={[
            {
              id: 'verdict',
              head: t('column.verdict'),
              cell: ({ id, verdict, stale, waivers }) => (
                <>
                  <OutcomeBadge outcome={verdict} />{' '}
                  <a href={hrefs.program(program.id, 'checks', { check: String(id) })}>{t('checks.report', { id })}</a>
                  {stale && <span class="reason">{t('checks.stale')}</span>}
                  {waivers.map((one) => (
                    <span key={one.at_ms} class="reason">
                      {t('checks.waived', { name: one.name, reason: one.reason })}
                    </span>
                  ))}
                </>
              ),
            },
            { id: 'machine', head: t('column.machine'), cell: ({ machine, delivery }) => `${machine}, ${deliveryText(delivery)}` },
            { id: 'revision', head: t('column.revision'), cell: ({ revision }) => revision },
            { id: 'by', head: t('column.by'), cell: (one) => t('library.changed', { name: one.created_by, at: dateTime(one.created_at_ms) }) },
          ]}
        />
      )}
      {shown !== null && <VerdictReport key={shown} id={shown} program={program.id} />}
    </>
  );
}

// On some machine at least: a person may have another role there than in the rest of the shop.
export const maySomewhere = (program: Program): boolean => !program.archived && atLeast(bestRole(), 'programmer');

const OutcomeBadge = ({ outcome }: { outcome: Outcome }) => <Badge wording={wordingOfOutcome(outcome)} />;

interface CheckFormProps {
  program: number;
  revision: number;
  dialect: string;
  done: (verdict: Verdict) => void;
}

function CheckForm({ program, revision, dialect, done }: CheckFormProps) {
  const [error, setError] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const check = async (machine: string, delivery: Delivery) => {
    setBusy(true);
    setError(null);
    try {
      done(await loader.order(deskCalls.addCheck(program, revision, machine, delivery, newOrderKey())));
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  return (
    <>
      <MachineForm dialect={dialect} busy={busy} confirm={busy ? t('checks.running') : t('checks.start', { revision })} send={(machine, delivery) => void check(machine, delivery)} />
      <Failure error={error} />
    </>
  );
}

interface MachineFormProps {
  dialect: string | null; // only machines of it; null: all
  busy: boolean;
  confirm: string;
  send: (machine: string, delivery: Delivery) => void;
  chosen?: (machine: string) => void;
}

// A machine and how the program goes to it.
export function MachineForm({ dialect, busy, confirm, send, chosen }: MachineFormProps) {
  const fitting = [...machines.value.values()].filter(
    (one) => (dialect === null || one.head.value.dialect === dialect) && atLeast(roleOn(one.name), 'programmer'),
  );
  const [machine, setMachine] = useState('');
  const [delivery, setDelivery] = useState<Delivery>('drip');
  const name = machine || fitting[0]?.name || '';
  if (fitting.length === 0) return <p class="notice tone-waiting">{t('checks.no_machine')}</p>;
  return (
    <form
      class="writing-bar"
      onSubmit={(event) => {
        event.preventDefault();
        if (!busy) send(name, delivery);
      }}
    >
      <label class="choice">
        <span>{t('fact.machine')}</span>
        <select
          value={name}
          onChange={(event) => {
            setMachine(event.currentTarget.value);
            chosen?.(event.currentTarget.value);
          }}
        >
          {fitting.map((one) => (
            <option key={one.name} value={one.name}>
              {one.name}
            </option>
          ))}
        </select>
      </label>
      <label class="choice">
        <span>{t('fact.delivery')}</span>
        <select value={delivery} onChange={(event) => setDelivery(event.currentTarget.value as Delivery)}>
          {kDeliveries.map((one) => (
            <option key={one} value={one}>
              {deliveryText(one)}
            </option>
          ))}
        </select>
      </label>
      <button type="submit" class="button button-main" aria-disabled={busy}>
        {confirm}
      </button>
    </form>
  );
}

function VerdictReport({ id, program }: { id: number; program: number }) {
  const { value: verdict, error } = useLoaded(String(id), () => deskCalls.check(id));
  if (!verdict) return <Failure error={error} />;
  const findings = findingsOf(verdict);
  return (
    <section class="card" aria-label={t('checks.report', { id })}>
      <h2>
        {t('checks.report', { id })} <OutcomeBadge outcome={verdict.verdict} />
      </h2>
      <p class="quiet-text">{t('checks.of', { revision: verdict.revision, machine: verdict.machine, control: verdict.control.title })}</p>
      {findings.length === 0 && <p>{t('checks.no_finding')}</p>}
      <ul class="faults">
        {findings.map((one) => (
          <FindingRow key={`${one.id} ${one.file} ${one.line} ${one.text}`} finding={one} program={program} revision={verdict.revision} />
        ))}
        {verdict.folded.map(({ id: kind, more }) => (
          <li key={kind} class="hint">
            {t('side.more', { count: more, id: kind })}
          </li>
        ))}
      </ul>
      {verdict.not_checked.length > 0 && (
        <>
          <h3>{t('checks.not_checked')}</h3>
          <ul class="listed">
            {verdict.not_checked.map((sentence) => (
              <li key={sentence}>{sentence}</li>
            ))}
          </ul>
        </>
      )}
      <Facts
        facts={[
          [t('checks.blocks'), count(verdict.blocks)],
          [t('checks.cycle'), verdict.timing ? duration(verdict.timing.cycle_s) : null],
          [t('checks.stalls'), verdict.timing && verdict.timing.stalls > 0 ? t('checks.stall_text', { count: verdict.timing.stalls, time: duration(verdict.timing.stall_s), line: verdict.timing.first_stall_line }) : null],
        ]}
      />
    </section>
  );
}

const kLooks = { error: ['tone-bad', 'bad'], warning: ['tone-waiting', 'waiting'], note: ['tone-active', 'quiet'] } as const;

function FindingRow({ finding, program, revision }: { finding: Finding; program: number; revision: number }) {
  const { line, file, text, alarm, severity } = finding;
  const [tone, shape] = kLooks[severity];
  return (
    <li class={`fault ${tone}`} data-fault={finding.id}>
      <span class="fault-go">
        <Icon shape={shape} /> <span class="unseen">{t(`severity.${severity}`)}</span>{' '}
        {line > 0 && file === null && (
          <a href={hrefs.program(program, 'text', { revision: String(revision), line: String(line) })}>{t('fault.line', { line })}</a>
        )}
        {line > 0 && file !== null && t('checks.line_of', { line, program: file })}
      </span>
      <p>{text}</p>
      {alarm && <p class="hint">{t('fault.alarm', { alarm })}</p>}
    </li>
  );
}
