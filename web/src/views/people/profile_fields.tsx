// The fields of a machine's profile, drawn from the schema of the API: one component a kind of member. Names are those of
// the profile's file, and words on them the server's own, so that page, file and documentation say the same.
import { useId, useState } from 'preact/hooks';
import { t } from '../../i18n/i18n';
import {
  boundsText,
  isField,
  isFlat,
  kindOf,
  membersOf,
  pointerTo,
  shownValue,
  typedValue,
  unitOf,
  valueAt,
  type FieldKind,
  type Json,
  type JsonObject,
  type SchemaNode,
} from '../../rules/profile_form';

export interface FormState {
  document: JsonObject;
  faults: ReadonlyMap<string, string>; // by pointer
  isFixed: (pointer: string) => boolean; // it cannot be changed here
  change: (pointer: string, value: Json | undefined) => void;
}

interface NodeProps {
  form: FormState;
  node: SchemaNode;
  name: string;
  pointer: string;
  isRequired: boolean;
  isNamed?: boolean; // what stands around it names it
}

const Legend = ({ name, isRequired, isNamed = false }: Pick<NodeProps, 'name' | 'isRequired' | 'isNamed'>) => (
  <legend class={isNamed ? 'unseen' : undefined}>
    <code>{name}</code>
    {isRequired && <span class="quiet-text"> {t('profile.required')}</span>}
  </legend>
);

interface ControlProps extends Omit<NodeProps, 'name' | 'isRequired'> {
  id?: string;
  label?: string; // where no <label> names it
  describedBy?: string;
}

// One value, without its words.
function Control({ form, node, pointer, id, label, describedBy }: ControlProps) {
  const kind = kindOf(node);
  const value = valueAt(form.document, pointer);
  const common = {
    ...(id === undefined ? {} : { id }),
    ...(label === undefined ? {} : { 'aria-label': label }),
    ...(describedBy === undefined ? {} : { 'aria-describedby': describedBy }),
    'aria-invalid': form.faults.has(pointer) ? true : undefined,
    'data-pointer': pointer,
    disabled: form.isFixed(pointer),
  } as const;
  if (kind === 'choice' || kind === 'flag') {
    const choices = kind === 'flag' ? ['true', 'false'] : (node.enum ?? []).filter((one) => one !== null);
    const given = (text: string) => (text === '' ? undefined : kind === 'flag' ? text === 'true' : text);
    return (
      <select {...common} value={shownValue(value)} onChange={(event) => form.change(pointer, given(event.currentTarget.value))}>
        <option value="">{t('profile.not_given')}</option>
        {choices.map((one) => (
          <option key={one} value={one}>
            {kind === 'flag' ? t(one === 'true' ? 'profile.yes' : 'profile.no') : one}
          </option>
        ))}
      </select>
    );
  }
  return <Typed kind={kind} value={value} common={common} change={(typed) => form.change(pointer, typed)} />;
}

interface TypedProps {
  kind: FieldKind;
  value: Json | undefined;
  common: Record<string, unknown>;
  change: (value: Json | undefined) => void;
}

// What was typed stays as it was typed ("8," before "8,5"), as long as it stands for the value.
function Typed({ kind, value, common, change }: TypedProps) {
  const [text, setText] = useState(shownValue(value));
  const shown = JSON.stringify(typedValue(kind, text)) === JSON.stringify(value ?? undefined) ? text : shownValue(value);
  const typed = (event: Event) => {
    const { value: now } = event.currentTarget as HTMLInputElement | HTMLTextAreaElement;
    setText(now);
    change(typedValue(kind, now));
  };
  if (kind === 'texts') return <textarea {...common} rows={3} value={shown} onInput={typed} />;
  const isNumber = kind === 'number' || kind === 'integer';
  return <input {...common} type="text" inputMode={isNumber ? 'decimal' : 'text'} autocomplete="off" spellcheck={false} value={shown} onInput={typed} />;
}

function Field({ form, node, name, pointer, isRequired }: NodeProps) {
  const id = useId();
  const fault = form.faults.get(pointer);
  const unit = unitOf(name);
  return (
    <div class={fault ? 'parameter parameter-wrong' : 'parameter'}>
      <label for={id}>
        <code>{name}</code>
        {isRequired && <span class="quiet-text"> {t('profile.required')}</span>}
      </label>
      <Control form={form} node={node} pointer={pointer} id={id} describedBy={`${id}-hint${fault ? ` ${id}-fault` : ''}`} />
      <p id={`${id}-hint`} class="hint" lang="en">
        {[node.description, [boundsText(node), unit].filter(Boolean).join(' ')].filter(Boolean).join('; ')}
      </p>
      {fault && (
        <p id={`${id}-fault`} class="parameter-fault">
          {fault}
        </p>
      )}
    </div>
  );
}

// A list of objects with one field a member: a table, a row an object.
function RowsTable({ form, node, name, pointer }: NodeProps) {
  const row = node.items ?? {};
  const value = valueAt(form.document, pointer);
  const rows = Array.isArray(value) ? value : [];
  const members = membersOf(row);
  return (
    <div class="profile-rows" role="region" aria-label={name} tabIndex={0}>
      <table>
        <thead>
          <tr>
            {members.map(([member, { description }]) => (
              <th key={member} scope="col" title={description}>
                <code>{member}</code>
              </th>
            ))}
            <th scope="col">{t('column.orders')}</th>
          </tr>
        </thead>
        <tbody>
          {rows.map((_, index) => (
            <tr key={index}>
              {members.map(([member, one]) => {
                const at = pointerTo(pointerTo(pointer, index), member);
                return (
                  <td key={member}>
                    {!isField(one) ? (
                      <Folded form={form} node={one} pointer={at} name={`${name} ${index + 1} ${member}`} isRequired={false} />
                    ) : (
                      <>
                        <Control form={form} node={one} pointer={at} label={`${name} ${index + 1} ${member}`} />
                        {form.faults.has(at) && <p class="parameter-fault">{form.faults.get(at)}</p>}
                      </>
                    )}
                  </td>
                );
              })}
              <td>
                <RemoveRow form={form} pointer={pointer} rows={rows} index={index} name={name} />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

const hasFaultBelow = (form: FormState, pointer: string): boolean => [...form.faults.keys()].some((one) => one === pointer || one.startsWith(`${pointer}/`));

// A list or an object in a cell of a table.
const Folded = (props: NodeProps) => (
  <details open={hasFaultBelow(props.form, props.pointer) || undefined}>
    <summary>
      <span class="unseen">{props.name}: </span>
      {summaryOf(valueAt(props.form.document, props.pointer))}
    </summary>
    <Node {...props} isNamed />
  </details>
);

interface RowProps {
  form: FormState;
  pointer: string;
  rows: Json[];
  index: number;
  name: string;
}

const RemoveRow = ({ form, pointer, rows, index, name }: RowProps) => (
  <button
    type="button"
    class="button button-small"
    aria-label={t('profile.remove_row', { name, row: index + 1 })}
    onClick={() => {
      const left = rows.filter((_, other) => other !== index);
      form.change(pointer, left.length === 0 ? undefined : left);
    }}
  >
    {t('people.remove')}
  </button>
);

function Rows(props: NodeProps) {
  const { form, node, name, pointer } = props;
  const value = valueAt(form.document, pointer);
  const rows = Array.isArray(value) ? value : [];
  const row = node.items ?? {};
  const fault = form.faults.get(pointer);
  return (
    <fieldset class="profile-group">
      <Legend {...props} />
      <p class="hint" lang="en">
        {node.description}
      </p>
      {fault && <p class="parameter-fault">{fault}</p>}
      {rows.length > 0 && isFlat(row) && <RowsTable {...props} />}
      {!isFlat(row) &&
        rows.map((_, index) => (
          <div key={index} class="profile-row">
            <Members form={form} node={row} pointer={pointerTo(pointer, index)} />
            <RemoveRow form={form} pointer={pointer} rows={rows} index={index} name={name} />
          </div>
        ))}
      <button type="button" class="button button-small" onClick={() => form.change(pointer, [...rows, {}])}>
        {t('profile.add_row', { name })}
      </button>
    </fieldset>
  );
}

export function Members({ form, node, pointer }: { form: FormState; node: SchemaNode; pointer: string }) {
  return (
    <div class="profile-members">
      {membersOf(node).map(([name, member]) => (
        <Node key={name} form={form} node={member} name={name} pointer={pointerTo(pointer, name)} isRequired={node.required?.includes(name) ?? false} />
      ))}
    </div>
  );
}

function Node(props: NodeProps) {
  const { form, node, pointer } = props;
  const kind = kindOf(node);
  if (kind === 'rows') return <Rows {...props} />;
  if (kind !== 'group') return <Field {...props} />;
  return (
    <fieldset class="profile-group">
      <Legend {...props} />
      <p class="hint" lang="en">
        {node.description}
      </p>
      <Members form={form} node={node} pointer={pointer} />
    </fieldset>
  );
}

// A member of the profile itself as a part of the form that folds: open where it has a fault.
export function Section({ form, node, name, pointer, isRequired }: NodeProps) {
  const kind = kindOf(node);
  if (kind !== 'rows' && kind !== 'group') return <Field form={form} node={node} name={name} pointer={pointer} isRequired={isRequired} />;
  const value = valueAt(form.document, pointer);
  return (
    <details class="profile-section" open={hasFaultBelow(form, pointer) || undefined} data-section={name}>
      <summary>
        <code>{name}</code> <span class="quiet-text">{summaryOf(value)}</span>
      </summary>
      <Node form={form} node={node} name={name} pointer={pointer} isRequired={isRequired} isNamed />
    </details>
  );
}

function summaryOf(value: Json | undefined): string {
  if (value === undefined || value === null) return t('profile.not_given');
  if (Array.isArray(value)) return t('profile.rows', { count: value.length });
  return t('profile.members', { count: Object.keys(value).length });
}
