// Signing in by the shop's OpenID Connect provider: its button, where one is configured, and what the provider sent back
// with the browser, at the address #/sign-in.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../api/calls';
import type { ProviderAnswer } from '../api/types';
import { t } from '../i18n/i18n';
import { forgetAddress, route } from '../router';

interface Props {
  busy: boolean;
  enter: (answer: ProviderAnswer) => void;
  failed: (error: unknown) => void;
}

const kSentBack = ['code', 'iss', 'error'] as const;

function answerOf(query: URLSearchParams): ProviderAnswer {
  const answer: ProviderAnswer = { state: query.get('state') ?? '' };
  for (const name of kSentBack) {
    const value = query.get(name);
    if (value !== null) answer[name] = value;
  }
  return answer;
}

export function ProviderSignIn({ busy, enter, failed }: Props) {
  const [title, setTitle] = useState<string | null>(null);
  useEffect(() => {
    calls.signInProvider().then(
      (provider) => setTitle(provider.title),
      () => undefined, // the other methods to sign in stay
    );
  }, []);
  const here = route.value;
  useEffect(() => {
    if (here.view !== 'sign_in') return;
    forgetAddress();
    if (here.query.has('state')) enter(answerOf(here.query));
  }, [here.view]);
  if (title === null) return null;
  const begin = () => void calls.beginByProvider().then(({ url }) => location.assign(url), failed);
  return (
    <button type="button" class="button" disabled={busy} onClick={begin}>
      {t('sign_in.by', { provider: title })}
    </button>
  );
}
