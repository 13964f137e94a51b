// The feasible region of a family on a machine: for each parameter the values that pass all checks while the others have
// their defaults, what ends them, and where the typed value stands. Asked for by a person: it makes many checks.
import { useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Family, SweepFigures } from '../../api/types';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { TargetForm } from '../../parts/target';
import { rowOf, type Swept } from '../../rules/region';
import { givenValues, isMadeOn, wantedBy, type Values } from '../../rules/part_values';
import { loader } from '../../state/loader';

const figure = (value: number, unit: string): string => `${Number(value.toPrecision(5))}${unit === '' ? '' : `\u202F${unit}`}`;

export function Region({ family, values }: { family: Family; values: Values }) {
  const [figures, setFigures] = useState<{ machine: string; of: SweepFigures } | null>(null);
  const [error, setError] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  // What has no range is not swept: it stays as it was typed.
  const fixed = givenValues(family.parameters.filter(({ choices }) => choices.length > 0), values);
  const sweep = async (machine: string, delivery: 'drip' | 'memory') => {
    setBusy(true);
    setError(null);
    try {
      setFigures({ machine, of: await loader.order(deskCalls.sweep(family.name, fixed, machine, delivery)) });
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  return (
    <section class="card region" aria-label={t('region.title')} aria-busy={busy}>
      <h2>{t('region.title')}</h2>
      <p class="hint">{t('region.hint')}</p>
      <TargetForm fits={(machine) => isMadeOn(wantedBy(family.text), machine)} busy={busy} confirm={t(busy ? 'region.running' : 'region.compute')} send={(machine, delivery) => void sweep(machine, delivery)} />
      <Failure error={error} />
      {figures && <Shown figures={figures.of} machine={figures.machine} values={values} />}
    </section>
  );
}

function Shown({ figures, machine, values }: { figures: SweepFigures; machine: string; values: Values }) {
  const { standard, corners, samples, smallest_failure: failure } = figures;
  return (
    <>
      <p class={`notice tone-${standard.passes ? 'good' : 'bad'}`} role="status">
        {standard.passes ? t('region.standard_passes', { machine }) : t('region.standard_fails', { machine, text: standard.text })}
      </p>
      <table class="region-table" aria-label={t('region.of', { machine })}>
        <thead>
          <tr>
            <th scope="col">{t('region.parameter')}</th>
            <th scope="col">{t('region.range')}</th>
            <th scope="col">{t('region.passes')}</th>
          </tr>
        </thead>
        <tbody>
          {figures.parameters.map((one) => (
            <Row key={one.name} swept={one} typed={values[one.name] ?? ''} />
          ))}
        </tbody>
      </table>
      <p class="hint">{t('region.shares', { corners: corners.passed, of_corners: corners.tried, samples: samples.passed, of_samples: samples.tried })}</p>
      {failure && (
        <p class="notice tone-waiting">
          {t('region.nearest')} {failure.changed.map((name) => `${name} = ${figure(failure.values[name] ?? 0, unitOf(figures, name))}`).join(', ')}: {failure.text}
        </p>
      )}
    </>
  );
}

const unitOf = ({ parameters }: SweepFigures, name: string): string => parameters.find((one) => one.name === name)?.unit ?? '';

function Row({ swept, typed }: { swept: Swept; typed: string }) {
  const row = rowOf(swept, typed);
  const [low, high] = swept.passes ?? [];
  return (
    <tr data-parameter={swept.name}>
      <th scope="row">
        <code>{swept.name}</code>
      </th>
      <td>
        <Bar row={row} />
        <span class="region-ends" aria-hidden="true">
          <span>{figure(swept.low, swept.unit)}</span>
          <span>{figure(swept.high, swept.unit)}</span>
        </span>
      </td>
      <td>
        {low === undefined || high === undefined ? t('region.none') : `${figure(low, swept.unit)} … ${figure(high, swept.unit)}`}
        {swept.low_bound && low !== undefined && <span class="reason">{t('region.below', { at: figure(low, swept.unit), text: swept.low_bound.text })}</span>}
        {swept.high_bound && high !== undefined && <span class="reason">{t('region.above', { at: figure(high, swept.unit), text: swept.high_bound.text })}</span>}
        {row.isOutside && (
          <span class="parameter-fault" role="status">
            {t('region.outside', { value: typed })}
          </span>
        )}
      </td>
    </tr>
  );
}

const kWide = 1000; // units of the picture

// What it shows stands in words beside it.
const Bar = ({ row }: { row: ReturnType<typeof rowOf> }) => (
  <svg class="region-bar" viewBox={`0 0 ${kWide} 36`} preserveAspectRatio="none" aria-hidden="true">
    <rect class="region-range" x="0" y="10" width={kWide} height="16" />
    {row.passes && <rect class="region-passes" x={kWide * row.passes.from} y="10" width={Math.max(kWide * (row.passes.to - row.passes.from), 4)} height="16" />}
    <rect class="region-standard" x={kWide * row.standard - 2} y="6" width="4" height="24" />
    {row.now !== null && <rect class={row.isOutside ? 'region-now region-outside' : 'region-now'} x={kWide * row.now - 4} y="0" width="8" height="36" />}
  </svg>
);
