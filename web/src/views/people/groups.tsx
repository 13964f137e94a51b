// Groups of machines, in which people have roles of their own and a second pair of eyes may be asked for.
import { useState } from 'preact/hooks';
import { peopleCalls } from '../../api/people_calls';
import type { MachineGroup } from '../../api/types';
import { t } from '../../i18n/i18n';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { Empty } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { machines } from '../../state/shop';
import { Choices, TextField } from './fields';

export function Groups() {
  const groups = useLoaded('groups', peopleCalls.groups);
  const change = (group: MachineGroup | null) => showDialog(<GroupDialog group={group} done={groups.again} />);
  const add = (
    <button type="button" class="button button-main" onClick={() => change(null)}>
      {t('people.add_group')}
    </button>
  );
  return (
    <section class="people">
      <p class="lead">{t('people.groups_lead')}</p>
      <Failure error={groups.error} />
      {groups.value?.length === 0 && <Empty action={add}>{t('people.no_group')}</Empty>}
      {groups.value && groups.value.length > 0 && (
        <>
          {add}
          <Table
            label={t('people.groups')}
            rows={groups.value}
            keyOf={({ name }) => name}
            columns={[
              { id: 'name', head: t('column.name'), cell: ({ name }) => <strong>{name}</strong> },
              { id: 'machines', head: t('nav.floor'), cell: (group) => group.machines.join(', ') || t('people.nothing') },
              { id: 'eyes', head: t('people.approval'), cell: (group) => <Approval group={group} /> },
              {
                id: 'orders',
                head: t('column.orders'),
                class: 'orders',
                cell: (group) => (
                  <>
                    <button type="button" class="button button-small" onClick={() => change(group)} aria-label={t('people.change_of', { name: group.name })}>
                      {t('people.change')}
                    </button>
                    <button
                      type="button"
                      class="button button-small"
                      onClick={() => showDialog(<RemoveDialog group={group} done={groups.again} />)}
                      aria-label={t('people.remove_of', { name: group.name })}
                    >
                      {t('people.remove')}
                    </button>
                  </>
                ),
              },
            ]}
          />
        </>
      )}
    </section>
  );
}

const Approval = ({ group }: { group: MachineGroup }) => (
  <>
    {t(group.four_eyes ? 'people.four_eyes' : 'people.two_eyes')}
    {!group.operator_sign_off && <span class="reason">{t('people.no_sign_off')}</span>}
  </>
);

function GroupDialog({ group, done }: { group: MachineGroup | null; done: () => void }) {
  const [name, setName] = useState(group?.name ?? '');
  const [chosen, setChosen] = useState<string[]>(group?.machines ?? []);
  const [fourEyes, setFourEyes] = useState(group?.four_eyes ?? false);
  const [signOff, setSignOff] = useState(group?.operator_sign_off ?? true);
  const all = [...new Set([...machines.value.keys(), ...chosen])].sort();
  return (
    <OrderDialog
      title={group ? t('people.change_of', { name: group.name }) : t('people.add_group')}
      confirm={t('people.save')}
      blocked={name.trim() === '' ? t('people.needs_name') : null}
      send={(key) => peopleCalls.putGroup(name.trim(), { machines: chosen, four_eyes: fourEyes, operator_sign_off: signOff }, key).then(done)}
    >
      {group === null && <TextField label={t('column.name')} value={name} change={setName} required />}
      <Choices label={t('people.machines')} all={all} chosen={chosen} change={setChosen} />
      <label class="check">
        <input type="checkbox" checked={fourEyes} onChange={(event) => setFourEyes(event.currentTarget.checked)} /> {t('people.four_eyes_rule')}
      </label>
      <label class="check">
        <input type="checkbox" checked={signOff} onChange={(event) => setSignOff(event.currentTarget.checked)} /> {t('people.sign_off_rule')}
      </label>
    </OrderDialog>
  );
}

const RemoveDialog = ({ group, done }: { group: MachineGroup; done: () => void }) => (
  <OrderDialog title={t('people.remove_of', { name: group.name })} confirm={t('people.remove')} danger send={(key) => peopleCalls.removeGroup(group.name, key).then(done)}>
    <p>{t('people.remove_group')}</p>
  </OrderDialog>
);
