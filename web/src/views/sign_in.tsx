// The only view without a session. A token is typed, or read by a scanner from a badge: a scanner types and presses
// Enter. A badge's QR code may also be the address #/badge/TOKEN; the part after '#' never leaves the browser.
import { useEffect, useState } from 'preact/hooks';
import { t } from '../i18n/i18n';
import { Failure } from '../parts/failure';
import { forgetAddress, route } from '../router';
import { loader } from '../state/loader';
import { signedOutBecause } from '../state/shop';

export function SignIn() {
  const [token, setToken] = useState('');
  const [busy, setBusy] = useState(false);
  const [error, setError] = useState<unknown>(null);
  const because = signedOutBecause.value;
  const enter = async (given: string) => {
    if (busy || given === '') return;
    setBusy(true);
    setError(null);
    try {
      await loader.signIn(given);
    } catch (failure) {
      setError(failure);
      setBusy(false);
    }
  };
  const badge = route.value.view === 'badge' ? route.value.parameters[0] : undefined;
  useEffect(() => {
    if (badge === undefined) return;
    forgetAddress();
    void enter(badge);
  }, [badge]);
  return (
    <main class="sign-in">
      <form
        class="card"
        onSubmit={(event) => {
          event.preventDefault();
          void enter(token.trim());
        }}
      >
        <h1>dripfeed</h1>
        <p class="lead">{t('sign_in.lead')}</p>
        {because && error === null && (
          <p class="notice tone-waiting" role="status">
            {because}
          </p>
        )}
        <label class="field">
          <span>{t('sign_in.token')}</span>
          <input
            type="password"
            name="token"
            autocomplete="current-password"
            spellcheck={false}
            required
            autofocus
            value={token}
            onInput={(event) => setToken(event.currentTarget.value)}
          />
        </label>
        <p class="hint">{t('sign_in.hint')}</p>
        <Failure error={error} />
        <button type="submit" class="button button-main" disabled={busy || token.trim() === ''}>
          {t(busy ? 'sign_in.busy' : 'sign_in.enter')}
        </button>
      </form>
    </main>
  );
}
