// Machines for whoever sets them up: each with its control and line, and its profile as a form.
import { t } from '../../i18n/i18n';
import { Empty } from '../../parts/empty';
import { Table } from '../../parts/table';
import { hrefs } from '../../router';
import { machines } from '../../state/shop';

export function Machines() {
  const all = [...machines.value.values()].map(({ head }) => head.value);
  const add = (
    <a class="button button-main" href={hrefs.newProfile()}>
      {t('machine.add')}
    </a>
  );
  return (
    <section class="people">
      <p class="lead">{t('profile.machines_lead')}</p>
      {all.length === 0 && <Empty action={add}>{t('profile.no_machine')}</Empty>}
      {all.length > 0 && (
        <>
          {add}
          <Table
            label={t('people.machines')}
            rows={all}
            keyOf={({ name }) => name}
            columns={[
              { id: 'name', head: t('column.name'), cell: ({ name }) => <a href={hrefs.profile(name)}>{name}</a>, by: ({ name }) => name },
              { id: 'title', head: t('profile.machine_title'), cell: ({ title }) => title },
              { id: 'control', head: t('profile.control'), cell: ({ dialect }) => dialect, by: ({ dialect }) => dialect },
              { id: 'line', head: t('profile.line'), cell: ({ link }) => <code>{link}</code> },
              {
                id: 'orders',
                head: t('column.orders'),
                class: 'orders',
                cell: ({ name }) => (
                  <a class="button button-small" href={hrefs.newProfile(name)} aria-label={t('profile.copy_of', { machine: name })}>
                    {t('profile.copy')}
                  </a>
                ),
              },
            ]}
          />
        </>
      )}
    </section>
  );
}
