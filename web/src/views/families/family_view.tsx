// One family: a form for a new part of it, the parts that it has, and its text.
import { deskCalls } from '../../api/desk_calls';
import { t } from '../../i18n/i18n';
import { AttachedFiles } from '../../parts/attached_files';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { goUnlessLeft, hrefs } from '../../router';
import { atLeast } from '../../rules/roles';
import { person } from '../../state/shop';
import { ValuesForm } from './values_form';

export function FamilyView({ name }: { name: string }) {
  const { value: family, error } = useLoaded(name, () => deskCalls.family(name));
  const parts = useLoaded(name, () => deskCalls.parts(name));
  const may = atLeast(person().role, 'programmer');
  return (
    <>
      <p class="back">
        <a href={hrefs.families}>{t('parts.back')}</a>
      </p>
      <h1 tabIndex={-1}>{family?.title || name}</h1>
      <Failure error={error} />
      {family && (
        <>
          <p class="lead">
            {family.name}, {t('job.revision', { revision: family.revision })}
          </p>
          <section>
            <h2>{t(may ? 'parts.new' : 'parts.parameters')}</h2>
            <ValuesForm
              family={family}
              number={null}
              values={{}}
              may={may}
              confirm={t('parts.make')}
              save={async (number, values, key) => {
                const follow = goUnlessLeft();
                await deskCalls.addPart(number, family.name, values, key);
                follow(hrefs.part(number));
              }}
            />
          </section>
          <section>
            <h2>{t('nav.parts')}</h2>
            <Failure error={parts.error} />
            {parts.value?.length === 0 && <p class="quiet-text">{t('parts.none_of_it')}</p>}
            <ul class="listed">
              {parts.value?.map(({ number }) => (
                <li key={number}>
                  <a href={hrefs.part(number)}>{number}</a>
                </li>
              ))}
            </ul>
          </section>
          <AttachedFiles owner={{ family: family.name }} may={may} />
          <details>
            <summary>{t('parts.text')}</summary>
            <pre class="text-box" tabIndex={0}>
              {family.text}
            </pre>
          </details>
        </>
      )}
    </>
  );
}
