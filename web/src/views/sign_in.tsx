// The only view without a session. A badge's token is typed, or read by a scanner: a scanner types and presses Enter. A
// badge's QR code may also be the address #/badge/TOKEN; the part after '#' never leaves the browser. A person signs in
// with a name and a PIN, on the shop floor, or a password.
import { useEffect, useState } from 'preact/hooks';
import type { NewSession } from '../api/types';
import { t } from '../i18n/i18n';
import { Failure } from '../parts/failure';
import { forgetAddress, route } from '../router';
import { loader } from '../state/loader';
import { signedOutBecause } from '../state/shop';
import { ProviderSignIn } from './provider_sign_in';

const kKinds = ['badge', 'pin', 'password'] as const;
type Kind = (typeof kKinds)[number];

// A station is used by people who sign in alike.
const kStored = 'dripfeed.sign-in';

const usual = (): Kind => kKinds.find((kind) => kind === localStorage.getItem(kStored)) ?? 'badge';

function whoOf(kind: Kind, name: string, secret: string): NewSession {
  if (kind === 'badge') return { token: secret.trim() };
  return kind === 'pin' ? { name: name.trim(), pin: secret } : { name: name.trim(), password: secret };
}

interface FieldProps {
  label: string;
  name: string;
  kind: 'text' | 'password';
  complete: AutoFill;
  digits?: boolean;
  focused?: boolean;
  value: string;
  change: (value: string) => void;
}

function Field({ label, name, kind, complete, digits = false, focused = false, value, change }: FieldProps) {
  const same = {
    name,
    autocomplete: complete,
    inputMode: digits ? ('numeric' as const) : ('text' as const),
    spellcheck: false,
    required: true,
    autofocus: focused,
    value,
    onInput: (event: { currentTarget: HTMLInputElement }) => change(event.currentTarget.value),
  };
  return (
    <label class="field">
      <span>{label}</span>
      {kind === 'text' ? <input type="text" {...same} /> : <input type="password" {...same} />}
    </label>
  );
}

export function SignIn() {
  const [kind, setKind] = useState<Kind>(usual);
  const [name, setName] = useState('');
  const [secret, setSecret] = useState('');
  const [busy, setBusy] = useState(false);
  const [error, setError] = useState<unknown>(null);
  const because = signedOutBecause.value;
  const enter = async (open: () => Promise<void>) => {
    if (busy) return;
    setBusy(true);
    setError(null);
    try {
      await open();
    } catch (failure) {
      setError(failure);
      setSecret('');
      setBusy(false);
    }
  };
  const choose = (chosen: Kind) => {
    localStorage.setItem(kStored, chosen);
    setKind(chosen);
    setSecret('');
    setError(null);
  };
  const badge = route.value.view === 'badge' ? route.value.parameters[0] : undefined;
  useEffect(() => {
    if (badge === undefined || badge === '') return;
    forgetAddress();
    void enter(() => loader.signIn({ token: badge }));
  }, [badge]);
  const isFilled = secret.trim() !== '' && (kind === 'badge' || name.trim() !== '');
  return (
    <main class="sign-in">
      <form
        class="card"
        onSubmit={(event) => {
          event.preventDefault();
          if (isFilled) void enter(() => loader.signIn(whoOf(kind, name, secret)));
        }}
      >
        <h1>dripfeed</h1>
        <p class="lead">{t('sign_in.lead')}</p>
        {because && error === null && (
          <p class="notice tone-waiting" role="status">
            {because}
          </p>
        )}
        <div class="segments" role="group" aria-label={t('sign_in.kinds')}>
          {kKinds.map((one) => (
            <button key={one} type="button" aria-pressed={one === kind} onClick={() => choose(one)}>
              {t(one === 'badge' ? 'sign_in.badge' : `sign_in.${one}_kind`)}
            </button>
          ))}
        </div>
        {kind === 'badge' ? (
          <>
            <Field label={t('sign_in.token')} name="token" kind="password" complete="current-password" focused value={secret} change={setSecret} />
            <p class="hint">{t('sign_in.hint')}</p>
          </>
        ) : (
          <>
            <Field label={t('sign_in.name')} name="name" kind="text" complete="username" focused value={name} change={setName} />
            <Field
              label={t(kind === 'pin' ? 'sign_in.pin' : 'sign_in.password')}
              name={kind}
              kind="password"
              complete={kind === 'pin' ? 'off' : 'current-password'}
              digits={kind === 'pin'}
              value={secret}
              change={setSecret}
            />
          </>
        )}
        <Failure error={error} />
        <button type="submit" class="button button-main" disabled={busy || !isFilled}>
          {t(busy ? 'sign_in.busy' : 'sign_in.enter')}
        </button>
        <ProviderSignIn busy={busy} enter={(answer) => void enter(() => loader.signInByProvider(answer))} failed={setError} />
      </form>
    </main>
  );
}
