// Tokens of programs and stations. A secret is shown once, when it is made.
import { useState } from 'preact/hooks';
import { peopleCalls, type NewToken } from '../../api/people_calls';
import type { Role, Token } from '../../api/types';
import { dateTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { BackButton, Dialog, OrderDialog, showDialog } from '../../parts/dialog';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { Choices, RoleField, TextField } from './fields';

const kScopes = ['library', 'checks', 'releases', 'queue', 'line', 'setup'] as const;
const kDayMs = 24 * 3600 * 1000;

export function Tokens() {
  const tokens = useLoaded('tokens', peopleCalls.tokens);
  return (
    <section class="people">
      <p class="lead">{t('people.tokens_lead')}</p>
      <Failure error={tokens.error} />
      <button type="button" class="button button-main" onClick={() => showDialog(<TokenDialog done={tokens.again} />)}>
        {t('people.add_token')}
      </button>
      {tokens.value && (
        <Table
          label={t('people.tokens')}
          rows={tokens.value}
          keyOf={({ id }) => id}
          columns={[
            { id: 'name', head: t('column.name'), cell: (token) => <NameOf token={token} /> },
            { id: 'role', head: t('people.role'), cell: ({ role }) => t(`role.${role}`) },
            { id: 'scope', head: t('people.may_change'), cell: ({ scope }) => scope.map((one) => t(`scope.${one}`)).join(', ') || t('people.everything') },
            { id: 'state', head: t('column.state'), cell: stateText },
            {
              id: 'orders',
              head: t('column.orders'),
              class: 'orders',
              cell: (token) =>
                isValid(token) && (
                  <button
                    type="button"
                    class="button button-small"
                    onClick={() => showDialog(<RevokeDialog token={token} done={tokens.again} />)}
                    aria-label={t('people.revoke_of', { name: token.name })}
                  >
                    {t('people.revoke')}
                  </button>
                ),
            },
          ]}
        />
      )}
    </section>
  );
}

const NameOf = ({ token }: { token: Token }) => (
  <>
    <strong>{token.name}</strong> {token.user && <span class="quiet-text">{t('people.token_of', { name: token.user })}</span>}
  </>
);

const isValid = ({ revoked_at_ms, expires_at_ms }: Token) => revoked_at_ms === null && (expires_at_ms === null || expires_at_ms > Date.now());

function stateText(token: Token): string {
  if (token.revoked_at_ms !== null) return t('people.revoked', { at: dateTime(token.revoked_at_ms) });
  if (token.expires_at_ms === null) return t('people.valid');
  return t(isValid(token) ? 'people.valid_until' : 'people.expired', { at: dateTime(token.expires_at_ms) });
}

function TokenDialog({ done }: { done: () => void }) {
  const [name, setName] = useState('');
  const [role, setRole] = useState<Role>('viewer');
  const [user, setUser] = useState('');
  const [scope, setScope] = useState<string[]>([]);
  const [days, setDays] = useState('');
  const send = async () => {
    const token: NewToken = {
      name: name.trim(),
      role,
      user: user.trim() === '' ? null : user.trim(),
      scope: scope.length > 0 ? scope : null,
      expires_at_ms: days === '' ? null : Date.now() + Number(days) * kDayMs,
    };
    const made = await peopleCalls.addToken(token);
    done();
    // After the dialog of the order has closed.
    setTimeout(() => showDialog(<MadeDialog name={made.name} secret={made.token} />));
  };
  return (
    <OrderDialog title={t('people.add_token')} confirm={t('people.make')} blocked={name.trim() === '' ? t('people.needs_name') : null} send={send}>
      <TextField label={t('column.name')} value={name} change={setName} required hint={t('people.token_name')} />
      <RoleField label={t('people.role')} value={role} change={setRole} />
      <TextField label={t('people.token_user')} value={user} change={setUser} hint={t('people.token_user_hint')} />
      <Choices label={t('people.scope')} all={kScopes} chosen={scope} change={setScope} name={(one) => t(`scope.${one}`)} />
      <label class="field">
        <span>{t('people.days')}</span>
        <input type="number" min={1} max={3650} value={days} onInput={(event) => setDays(event.currentTarget.value)} />
      </label>
    </OrderDialog>
  );
}

const MadeDialog = ({ name, secret }: { name: string; secret: string }) => (
  <Dialog title={t('people.token_made', { name })}>
    <p>{t('people.shown_once')}</p>
    <p>
      <code class="secret">{secret}</code>
    </p>
    <div class="dialog-buttons">
      <BackButton />
    </div>
  </Dialog>
);

const RevokeDialog = ({ token, done }: { token: Token; done: () => void }) => (
  <OrderDialog title={t('people.revoke_of', { name: token.name })} confirm={t('people.revoke')} danger send={(key) => peopleCalls.revoke(token.id, key).then(done)}>
    <p>{t('people.revoke_text')}</p>
  </OrderDialog>
);
