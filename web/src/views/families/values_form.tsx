// A part's values as a form, made from its family's parameters: their words, units, ranges and defaults. What is left
// empty has the default. An error of the server stands at the field that it is about.
import { useId, useRef, useState } from 'preact/hooks';
import { ApiError, newOrderKey } from '../../api/client';
import type { Family, Parameter } from '../../api/types';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { boundsOf, givenValues, grouped, isList, isMadeOn, parameterOf, wantedBy, type Values } from '../../rules/part_values';
import { kPlaces, placeOf, rangeOf, typedAt } from '../../rules/sliding';
import { loader } from '../../state/loader';
import { Preview } from './preview';
import { Region } from './region';

interface Props {
  family: Family;
  number: string | null; // null: a new part, whose number is asked for
  values: Values;
  may: boolean;
  confirm: string;
  save: (number: string, values: Values, key: string) => Promise<unknown>;
}

export function ValuesForm({ family, number: given, values, may, confirm, save }: Props) {
  const [number, setNumber] = useState(given ?? '');
  const [typed, setTyped] = useState<Values>(values);
  const [error, setError] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const [previewError, setPreviewError] = useState<unknown>(null);
  const [lit, light] = useState<string | null>(null);
  const form = useRef<HTMLFormElement>(null);
  const faults = faultsOf(error ?? previewError, family.parameters);
  const submit = async (event: Event) => {
    event.preventDefault();
    if (busy || !may) return;
    setBusy(true);
    setError(null);
    try {
      await loader.order(save(number.trim(), givenValues(family.parameters, typed), newOrderKey()));
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  const change = (name: string, text: string) => {
    setError(null);
    setTyped((before) => ({ ...before, [name]: text }));
  };
  return (
    <div class="values">
      <form ref={form} class="card values-form" onSubmit={submit}>
        {given === null && (
          <label class="field">
            <span>{t('parts.number')}</span>
            <input value={number} required disabled={!may} onInput={(event) => setNumber(event.currentTarget.value)} autocomplete="off" />
          </label>
        )}
        {grouped(family.parameters).map(({ group, parameters }) => (
          <fieldset key={group} disabled={!may}>
            <legend>{group || t('parts.values')}</legend>
            {parameters.map((parameter) => (
              <ParameterField
                key={parameter.name}
                parameter={parameter}
                value={typed[parameter.name] ?? ''}
                fault={faults.get(parameter.name) ?? null}
                typed={(text) => change(parameter.name, text)}
                isLit={lit === parameter.name}
                light={light}
              />
            ))}
          </fieldset>
        ))}
        {error !== null && (faults.size === 0 ? <Failure error={error} /> : <p class="notice tone-bad" role="alert">{t('parts.look_at_fields')}</p>)}
        {may && (
          <button type="submit" class="button button-main" disabled={busy}>
            {busy ? t('dialog.sending') : confirm}
          </button>
        )}
      </form>
      {may && (
        <Preview
          family={family.name}
          fits={(machine) => isMadeOn(wantedBy(family.text), machine)}
          values={givenValues(family.parameters, typed)}
          failed={setPreviewError}
          isShown={(failure) => faultsOf(failure, family.parameters).size > 0}
          lit={lit}
          light={light}
          chosen={(parameter) => form.current?.querySelector<HTMLElement>(`[data-parameter="${parameter}"] input`)?.focus()}
        />
      )}
      {may && <Region family={family} values={typed} />}
    </div>
  );
}

// By parameter. Empty where one of the faults is of no field: then all of them stand below the form.
function faultsOf(error: unknown, parameters: readonly Parameter[]): Map<string, string> {
  const found = new Map<string, string>();
  for (const place of error instanceof ApiError ? error.places : []) {
    const name = parameterOf(place, parameters);
    if (name === null) return new Map();
    found.set(name, place.text);
  }
  return found;
}

interface FieldProps {
  parameter: Parameter;
  value: string;
  fault: string | null;
  typed: (text: string) => void;
  isLit: boolean; // it or its dimension is looked at
  light: (parameter: string | null) => void;
}

function ParameterField({ parameter, value, fault, typed, isLit, light }: FieldProps) {
  const id = useId();
  const { name, text, choices } = parameter;
  const common = { id, 'aria-describedby': `${id}-hint`, 'aria-invalid': fault ? true : undefined };
  return (
    <div
      class={`parameter${fault ? ' parameter-wrong' : ''}${isLit ? ' parameter-lit' : ''}`}
      data-parameter={name}
      onPointerEnter={() => light(name)}
      onPointerLeave={() => light(null)}
      onFocusIn={() => light(name)}
      onFocusOut={() => light(null)}
    >
      <label for={id}>
        {text || name} {text && <code>{name}</code>}
      </label>
      {choices.length > 0 ? (
        <select {...common} value={value} onChange={(event) => typed(event.currentTarget.value)}>
          <option value="">{t('parts.default', { value: parameter.default })}</option>
          {choices.map((one) => (
            <option key={one} value={one}>
              {one}
            </option>
          ))}
        </select>
      ) : (
        <input {...common} value={value} placeholder={parameter.default} onInput={(event) => typed(event.currentTarget.value)} autocomplete="off" />
      )}
      {rangeOf(parameter) && (
        <input
          type="range"
          class="slide"
          min="0"
          max={kPlaces}
          value={placeOf(parameter, value)}
          aria-label={t('drawing.drag', { name })}
          aria-valuetext={value || parameter.default}
          onInput={(event) => typed(typedAt(parameter, Number(event.currentTarget.value)))}
        />
      )}
      {/* A fault stands in the hint's place: what is below, the form's button as well, does not move while one presses it. */}
      <p id={`${id}-hint`} class={fault ? 'parameter-fault' : 'hint'}>
        {fault ?? hintOf(parameter)}
      </p>
    </div>
  );
}

function hintOf(parameter: Parameter): string {
  const bounds = boundsOf(parameter);
  const parts = [bounds];
  if (parameter.step > 0) parts.push(t('parts.step', { step: `${parameter.step} ${parameter.unit}`.trim() }));
  if (isList(parameter)) parts.push(t('parts.list', { fewest: parameter.fewest, most: parameter.most }));
  else if (bounds === null && parameter.unit !== '') parts.push(t('parts.unit', { unit: parameter.unit }));
  return parts.filter((one) => one !== null).join(', ');
}
