// A machine's profile as a form: changed, copied for another machine, read from a file and written to one. The server
// reads it as it reads a file, and each fault stands at its field.
import { useMemo, useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import { ApiError, newOrderKey } from '../../api/client';
import { peopleCalls } from '../../api/people_calls';
import type { LineTest, MachineWhole } from '../../api/types';
import { t } from '../../i18n/i18n';
import { showDialog } from '../../parts/dialog';
import { Failure } from '../../parts/failure';
import { saveFile } from '../../parts/save_file';
import { useLeaving } from '../../parts/use_leaving';
import { useLoaded } from '../../parts/use_loaded';
import { goUnlessLeft, hrefs } from '../../router';
import { faultsAt, fieldPointers, membersOf, pointerTo, withValue, type JsonObject, type SchemaNode } from '../../rules/profile_form';
import { atLeast } from '../../rules/roles';
import { loader } from '../../state/loader';
import { person, roleOn } from '../../state/shop';
import { LineTestDialog, LineTestShown } from '../machine/line_test';
import { Section, type FormState } from './profile_fields';

// `name`: null for a new machine. `copyOf`: whose profile a new one begins with.
export function ProfileView({ name, copyOf }: { name: string | null; copyOf: string | null }) {
  const from = name ?? copyOf;
  const schema = useLoaded('schema', peopleCalls.profileSchema);
  const machine = useLoaded(from, () => calls.machine(from ?? ''));
  const may = atLeast(name === null ? person().role : roleOn(name), 'admin');
  const isReady = schema.value !== null && (from === null || machine.value !== null);
  return (
    <>
      <p class="back">
        <a href={hrefs.people('machines')}>{t('profile.back')}</a>
      </p>
      <h1 tabIndex={-1}>{name === null ? t('profile.new') : t('profile.title', { machine: name })}</h1>
      <p class="lead">{t('profile.lead')}</p>
      <Failure error={schema.error ?? machine.error} />
      {!isReady && schema.error === null && machine.error === null && <p role="status">{t('page.loading')}</p>}
      {isReady && schema.value && (
        <ProfileForm key={`${from ?? ''} ${machine.value?.revision ?? 0}`} schema={schema.value} machine={name === null ? null : machine.value} start={startOf(machine.value, name === null)} may={may} saved={machine.set} />
      )}
    </>
  );
}

// A copy has no name yet: two machines with one name, or one line, are refused.
function startOf(machine: MachineWhole | null, isNew: boolean): JsonObject {
  const profile = { ...((machine?.profile ?? {}) as unknown as JsonObject) };
  if (isNew) delete profile['name'];
  return profile;
}

interface FormProps {
  schema: SchemaNode;
  machine: MachineWhole | null; // null: a new one
  start: JsonObject;
  may: boolean;
  saved: (machine: MachineWhole) => void;
}

function ProfileForm({ schema, machine, start, may, saved }: FormProps) {
  const [document, setDocument] = useState(start);
  const [error, setError] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const [key, setKey] = useState(newOrderKey);
  const [done, setDone] = useState<string | null>(null);
  const isChanged = document !== start;
  useLeaving(isChanged);
  const faults = useMemo(() => faultsAt(error instanceof ApiError ? error.places : [], fieldPointers(schema, document)), [error, document]);
  const form: FormState = {
    document,
    faults: faults.at,
    isFixed: (pointer) => !may || (machine !== null && pointer === '/name'),
    change: (pointer, value) => {
      setDone(null);
      setKey(newOrderKey());
      setDocument((before) => (withValue(before, pointer, value) ?? {}) as JsonObject);
    },
  };
  const submit = async (event: Event) => {
    event.preventDefault();
    if (busy || !may) return;
    setBusy(true);
    setError(null);
    try {
      const follow = goUnlessLeft();
      const answer = await loader.order(machine ? peopleCalls.changeMachine(machine, document, key) : peopleCalls.addMachine(document, key));
      await loader.load();
      if (machine) saved(answer);
      else follow(hrefs.profile(answer.name));
    } catch (failure) {
      setError(failure);
      setKey(newOrderKey());
    }
    setBusy(false);
  };
  const take = async (file: File | undefined) => {
    if (!file) return;
    setError(null);
    try {
      const read = JSON.parse(await file.text()) as JsonObject;
      setDocument(machine ? { ...read, name: machine.name } : read);
      setDone(t('profile.from_file', { file: file.name }));
    } catch (failure) {
      setError(new Error(t('machine.no_json', { text: failure instanceof Error ? failure.message : '' })));
    }
  };
  return (
    <form class="profile-form" onSubmit={submit} noValidate>
      {membersOf(schema).map(([name, node]) => (
        <Section key={name} form={form} node={node} name={name} pointer={pointerTo('', name)} isRequired={schema.required?.includes(name) ?? false} />
      ))}
      {faults.at.size > 0 && <Faulty pointers={[...faults.at.keys()]} rest={faults.rest} />}
      {error !== null && faults.at.size === 0 && <Failure error={error} />}
      {done && (
        <p class="notice tone-good" role="status">
          {done}
        </p>
      )}
      <div class="profile-orders">
        {may && (
          <button type="submit" class="button button-main" disabled={busy || (machine !== null && !isChanged)}>
            {busy ? t('dialog.sending') : machine ? t('parts.save', { next: machine.revision + 1 }) : t('machine.add_confirm')}
          </button>
        )}
        <button type="button" class="button" onClick={() => saveProfile(document)}>
          {t('profile.to_file')}
        </button>
        {may && (
          <label class="field">
            <span>{t('machine.profile_file')}</span>
            <input type="file" accept=".json,application/json" onChange={(event) => void take(event.currentTarget.files?.[0])} />
          </label>
        )}
      </div>
      {machine && <LineTesting name={machine.name} isChanged={isChanged} />}
    </form>
  );
}

// Each fault leads to its field.
const Faulty = ({ pointers, rest }: { pointers: readonly string[]; rest: readonly string[] }) => (
  <div class="notice tone-bad" role="alert">
    <p>{t('parts.look_at_fields')}</p>
    <ul>
      {pointers.map((pointer) => (
        <li key={pointer}>
          <button type="button" class="button button-small" onClick={() => focusOn(pointer)}>
            {pointer.slice(1).replaceAll('/', '.')}
          </button>
        </li>
      ))}
      {rest.map((one) => (
        <li key={one}>{one}</li>
      ))}
    </ul>
  </div>
);

function focusOn(pointer: string): void {
  const field = document.querySelector<HTMLElement>(`[data-pointer="${CSS.escape(pointer)}"]`);
  for (let fold = field?.closest('details'); fold; fold = fold.parentElement?.closest('details')) fold.open = true;
  field?.focus();
}

// The line is tested as it is stored: what is only typed here does not count.
function LineTesting({ name, isChanged }: { name: string; isChanged: boolean }) {
  const [test, setTest] = useState<LineTest | null>(null);
  if (!atLeast(roleOn(name), 'operator')) return null;
  return (
    <section class="card">
      <h2>{t('profile.line')}</h2>
      <p class="hint">{t(isChanged ? 'profile.save_first' : 'profile.line_hint')}</p>
      <button type="button" class="button" disabled={isChanged} onClick={() => showDialog(<LineTestDialog name={name} done={setTest} />)}>
        {t('line_test.confirm')}
      </button>
      {test && <LineTestShown test={test} />}
    </section>
  );
}

// The file has what the form has, saved or not.
function saveProfile(profile: JsonObject): void {
  const name = typeof profile['name'] === 'string' ? profile['name'] : 'profile';
  saveFile(`${name}.json`, 'application/json', `${JSON.stringify(profile, null, 2)}\n`);
}
