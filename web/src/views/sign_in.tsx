// The only view without a session: a token opens one.
import { useState } from 'preact/hooks';
import type { Sync } from '../state/sync';
import { Failure } from './dialog';

export function SignIn({ sync, because }: { sync: Sync; because: string | null }) {
  const [token, setToken] = useState('');
  const [busy, setBusy] = useState(false);
  const [error, setError] = useState<unknown>(null);
  const submit = async (event: Event) => {
    event.preventDefault();
    if (busy || token.trim() === '') return;
    setBusy(true);
    setError(null);
    try {
      await sync.signIn(token.trim());
    } catch (failure) {
      setError(failure);
      setBusy(false);
    }
  };
  return (
    <main class="sign-in">
      <form class="card" onSubmit={submit}>
        <h1>dripfeed</h1>
        <p class="lead">Program distribution and drip-feed for machine tools</p>
        {because && error === null && (
          <p class="notice tone-waiting" role="status">
            {because}
          </p>
        )}
        <label class="field">
          <span>Token</span>
          <input
            type="password"
            name="token"
            autocomplete="current-password"
            spellcheck={false}
            required
            value={token}
            onInput={(event) => setToken(event.currentTarget.value)}
          />
        </label>
        <Failure error={error} />
        <button type="submit" class="button button-main" disabled={busy || token.trim() === ''}>
          {busy ? 'Signing in…' : 'Sign in'}
        </button>
      </form>
    </main>
  );
}
