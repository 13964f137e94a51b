// People: roles, secrets, locks.
import { useState } from 'preact/hooks';
import { peopleCalls, type Roles, type SecretKind } from '../../api/people_calls';
import type { MachineGroup, Role, User } from '../../api/types';
import { clockTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { Empty } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { kRoles } from '../../rules/roles';
import { person } from '../../state/shop';
import { RoleField, TextField } from './fields';

export function Users() {
  const users = useLoaded('users', peopleCalls.users);
  const groups = useLoaded('groups', peopleCalls.groups);
  const add = (
    <button type="button" class="button button-main" onClick={() => showDialog(<UserDialog user={null} groups={groups.value ?? []} done={users.again} />)}>
      {t('people.add_user')}
    </button>
  );
  return (
    <section class="people">
      <p class="lead">{t('people.users_lead')}</p>
      <Failure error={users.error ?? groups.error} />
      {users.value?.length === 0 && <Empty action={add}>{t('people.no_user')}</Empty>}
      {users.value && users.value.length > 0 && (
        <>
          {add}
          <Table
            label={t('people.users')}
            rows={users.value}
            keyOf={({ name }) => name}
            columns={[
              { id: 'name', head: t('column.name'), cell: ({ name }) => <strong>{name}</strong> },
              { id: 'role', head: t('people.role'), cell: rolesText },
              { id: 'secrets', head: t('people.signs_in_with'), cell: secretsText },
              { id: 'state', head: t('column.state'), cell: stateText },
              {
                id: 'orders',
                head: t('column.orders'),
                class: 'orders',
                cell: (user) => <Orders user={user} groups={groups.value ?? []} done={users.again} />,
              },
            ]}
          />
        </>
      )}
    </section>
  );
}

const rolesText = ({ role, grants }: User) =>
  [t(`role.${role}`), ...grants.map((grant) => t('people.role_in', { role: t(`role.${grant.role}`), group: grant.group }))].join(', ');

const secretsText = ({ has_password, has_pin, provider }: User) =>
  [has_password && t('sign_in.password_kind'), has_pin && t('sign_in.pin_kind'), provider && t('people.by_provider', { provider })].filter(Boolean).join(', ') || t('people.nothing');

function stateText(user: User): string {
  if (user.disabled_at_ms !== null) return t('people.disabled');
  if (user.locked_until_ms !== null && user.locked_until_ms > Date.now()) return t('people.locked', { time: clockTime(user.locked_until_ms) });
  return t('people.enabled');
}

interface OrdersProps {
  user: User;
  groups: MachineGroup[];
  done: () => void;
}

function Orders({ user, groups, done }: OrdersProps) {
  const secret = (kind: SecretKind) => showDialog(<SecretDialog user={user} kind={kind} done={done} />);
  const { name } = user;
  return (
    <>
      <button type="button" class="button button-small" onClick={() => showDialog(<UserDialog user={user} groups={groups} done={done} />)} aria-label={t('people.change_of', { name })}>
        {t('people.change')}
      </button>
      <button type="button" class="button button-small" onClick={() => secret('password')} aria-label={t('people.password_of', { name })}>
        {t('sign_in.password_kind')}
      </button>
      <button type="button" class="button button-small" onClick={() => secret('pin')} aria-label={t('people.pin_of', { name })}>
        {t('sign_in.pin_kind')}
      </button>
      {user.failures > 0 && (
        <button type="button" class="button button-small" onClick={() => showDialog(<UnlockDialog user={user} done={done} />)} aria-label={t('people.unlock_of', { name })}>
          {t('people.unlock')}
        </button>
      )}
    </>
  );
}

// "" is no role of its own in that group.
function UserDialog({ user, groups, done }: { user: User | null; groups: MachineGroup[]; done: () => void }) {
  const [name, setName] = useState(user?.name ?? '');
  const [role, setRole] = useState<Role>(user?.role ?? 'operator');
  const [grants, setGrants] = useState<Record<string, Role | ''>>(Object.fromEntries((user?.grants ?? []).map((one) => [one.group, one.role])));
  const [disabled, setDisabled] = useState(user !== null && user.disabled_at_ms !== null);
  const roles: Roles = { role, grants: Object.entries(grants).flatMap(([group, there]) => (there === '' ? [] : [{ group, role: there }])) };
  const send = async (key: string) => {
    await (user ? peopleCalls.changeUser(user, roles, disabled, key) : peopleCalls.addUser(name.trim(), roles, key));
    done();
  };
  return (
    <OrderDialog
      title={user ? t('people.change_of', { name: user.name }) : t('people.add_user')}
      confirm={t('people.save')}
      blocked={user === null && name.trim() === '' ? t('people.needs_name') : null}
      send={send}
    >
      {user === null && <TextField label={t('column.name')} value={name} change={setName} required />}
      <RoleField label={t('people.role')} value={role} change={setRole} />
      {groups.map((group) => (
        <label key={group.name} class="field">
          <span>{t('people.role_on', { group: group.name })}</span>
          <select
            value={grants[group.name] ?? ''}
            onChange={(event) => setGrants({ ...grants, [group.name]: kRoles.find((one) => one === event.currentTarget.value) ?? '' })}
          >
            <option value="">{t('people.same_role')}</option>
            {kRoles.map((one) => (
              <option key={one} value={one}>
                {t(`role.${one}`)}
              </option>
            ))}
          </select>
        </label>
      ))}
      {user && user.name !== person().name && (
        <label class="check">
          <input type="checkbox" checked={disabled} onChange={(event) => setDisabled(event.currentTarget.checked)} /> {t('people.disable')}
        </label>
      )}
    </OrderDialog>
  );
}

function SecretDialog({ user, kind, done }: { user: User; kind: SecretKind; done: () => void }) {
  const [secret, setSecret] = useState('');
  const has = kind === 'pin' ? user.has_pin : user.has_password;
  const send = async () => {
    await (secret === '' ? peopleCalls.removeSecret(user.name, kind) : peopleCalls.setSecret(user.name, kind, secret));
    done();
  };
  return (
    <OrderDialog
      title={t(kind === 'pin' ? 'people.pin_of' : 'people.password_of', { name: user.name })}
      confirm={t(secret === '' && has ? 'people.take_away' : 'people.save')}
      danger={secret === '' && has}
      blocked={secret === '' && !has ? t('people.needs_secret') : null}
      send={send}
    >
      <label class="field">
        <span>{t(kind === 'pin' ? 'people.new_pin' : 'people.new_password')}</span>
        <input
          type="password"
          autocomplete="new-password"
          inputMode={kind === 'pin' ? 'numeric' : 'text'}
          value={secret}
          onInput={(event) => setSecret(event.currentTarget.value)}
        />
        <small class="quiet-text">{t(kind === 'pin' ? 'people.pin_rule' : 'people.password_rule')}</small>
      </label>
      <p>{t('people.ends_sessions', { name: user.name })}</p>
    </OrderDialog>
  );
}

const UnlockDialog = ({ user, done }: { user: User; done: () => void }) => (
  <OrderDialog title={t('people.unlock_of', { name: user.name })} confirm={t('people.unlock')} send={(key) => peopleCalls.unlock(user.name, key).then(done)}>
    <p>{t('people.refusals', { count: user.failures })}</p>
  </OrderDialog>
);
