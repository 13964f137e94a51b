// Part families, and the parts that were made of them.
import { deskCalls } from '../../api/desk_calls';
import type { FamilySummary } from '../../api/types';
import { dateTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { Empty, GoTo } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { hrefs } from '../../router';
import { FamilyUpload } from './family_upload';
import { atLeast } from '../../rules/roles';
import { person } from '../../state/shop';

export function FamiliesView() {
  const families = useLoaded('families', deskCalls.families);
  const may = atLeast(person().role, 'programmer');
  const upload = may && families.value && <FamilyUpload families={families.value} done={families.again} />;
  return (
    <>
      <div class="floor-head">
        <h1 tabIndex={-1}>{t('nav.parts')}</h1>
        {families.value && families.value.length > 0 && upload}
      </div>
      <section>
        <h2>{t('parts.families')}</h2>
        <Failure error={families.error} />
        {families.value?.length === 0 && <Empty action={upload}>{t(may ? 'parts.no_family' : 'parts.no_family_viewer')}</Empty>}
        {families.value && families.value.length > 0 && (
          <Table
            label={t('parts.families')}
            rows={families.value}
            keyOf={({ name }) => name}
            columns={[
              {
                id: 'name',
                head: t('column.name'),
                cell: ({ name, title }) => (
                  <>
                    <a href={hrefs.family(name)}>
                      <strong>{title || name}</strong>
                    </a>{' '}
                    {title && <span class="quiet-text">{name}</span>}
                  </>
                ),
              },
              { id: 'revision', head: t('column.revision'), cell: ({ revision }) => revision },
              { id: 'by', head: t('column.by'), cell: (one) => t('library.changed', { name: one.changed_by, at: dateTime(one.changed_at_ms) }) },
              may && {
                id: 'orders',
                head: t('column.orders'),
                class: 'orders',
                cell: ({ name }) => (
                  <a class="button button-small" href={hrefs.family(name)} aria-label={t('parts.new_of', { family: name })}>
                    {t('parts.new')}
                  </a>
                ),
              },
            ]}
          />
        )}
      </section>
      <PartList family={may ? (families.value?.[0] ?? null) : null} />
    </>
  );
}

// `family`: of which a new part may be made.
function PartList({ family }: { family: FamilySummary | null }) {
  const parts = useLoaded('parts', () => deskCalls.parts());
  return (
    <section>
      <h2>{t('nav.parts')}</h2>
      <Failure error={parts.error} />
      {parts.value?.length === 0 && <NoPart family={family} />}
      {parts.value && parts.value.length > 0 && (
        <Table
          label={t('nav.parts')}
          rows={parts.value}
          keyOf={({ number }) => number}
          columns={[
            {
              id: 'number',
              head: t('column.part'),
              cell: ({ number }) => (
                <a href={hrefs.part(number)}>
                  <strong>{number}</strong>
                </a>
              ),
            },
            { id: 'family', head: t('column.family'), cell: ({ family }) => <a href={hrefs.family(family)}>{family}</a> },
            { id: 'values', head: t('column.values'), cell: ({ values }) => valuesText(values) },
            { id: 'by', head: t('column.by'), cell: (one) => t('library.changed', { name: one.changed_by, at: dateTime(one.changed_at_ms) }) },
          ]}
        />
      )}
    </section>
  );
}

const valuesText = (values: Record<string, string>): string => {
  const all = Object.entries(values).map(([name, value]) => `${name} = ${value}`);
  return all.length === 0 ? t('parts.defaults') : all.join(', ');
};

const NoPart = ({ family }: { family: FamilySummary | null }) => (
  <Empty action={family && <GoTo href={hrefs.family(family.name)}>{t('parts.new_of', { family: family.title || family.name })}</GoTo>}>{t('parts.none')}</Empty>
);
