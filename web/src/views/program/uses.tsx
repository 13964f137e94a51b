// Where a program is used, and what it calls: what one must know before it is changed or put aside.
import { deskCalls } from '../../api/desk_calls';
import type { ProgramUses } from '../../api/types';
import { jobWording, releaseText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Facts } from '../../parts/facts';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { hrefs } from '../../router';
import type { PlaceProps } from './program_view';

export function UsesPlace({ program }: PlaceProps) {
  const { value: uses, error } = useLoaded(`${program.id} ${program.revision}`, () => deskCalls.uses(program.id));
  if (!uses)
    return error !== null ? (
      <Failure error={error} />
    ) : (
      <p class="waiting" role="status">
        {t('page.loading')}
      </p>
    );
  return (
    <>
      <Facts
        facts={[
          [t('uses.machines'), listed(uses.machines.map((one) => <a href={hrefs.machine(one.machine)}>{one.machine}</a>))],
          [t('uses.releases'), listed(uses.releases.map((one) => t('uses.release', { id: one.id, revision: one.revision, machine: one.machine, state: releaseText(one.state) })))],
          [t('uses.jobs'), listed(uses.jobs.map((one) => <a href={hrefs.job(one.id)}>{t('uses.job', { id: one.id, machine: one.machine, state: jobWording(one.state).text })}</a>))],
          [t('uses.parts'), listed(uses.parts.map((one) => <a href={hrefs.part(one.number)}>{one.number}</a>))],
          [t('uses.called_by'), listed(uses.called_by.map((one) => <a href={hrefs.program(one.program, 'text', { line: String(one.line) })}>{one.name}</a>))],
          [t('uses.calls'), listed(uses.calls.map((one) => <Called of={one} />))],
        ]}
      />
      {uses.computed_calls > 0 && <p class="notice tone-waiting">{t('uses.computed', { count: uses.computed_calls })}</p>}
      {uses.calls_not_known && <p class="notice tone-waiting">{t('uses.calls_not_known', { why: uses.calls_not_known })}</p>}
      {uses.waiting > 0 && <p class="hint">{t('library.waiting', { count: uses.waiting })}</p>}
      {(uses.has_more_releases || uses.has_more_jobs) && <p class="hint">{t('uses.more')}</p>}
    </>
  );
}

const listed = (items: preact.ComponentChildren[]) =>
  items.length === 0 ? (
    <span class="quiet-text">{t('uses.none')}</span>
  ) : (
    <ul class="listed">
      {items.map((item, index) => (
        <li key={index}>{item}</li>
      ))}
    </ul>
  );

const Called = ({ of }: { of: ProgramUses['calls'][number] }) => (
  <>
    {of.called} <span class="quiet-text">{t('fault.line', { line: of.line })}</span>{' '}
    {of.programs.length === 0 ? (
      <span class="quiet-text">{t('uses.not_stored')}</span>
    ) : (
      of.programs.map((one) => (
        <a key={one.program} href={hrefs.program(one.program)}>
          {one.name}
        </a>
      ))
    )}
  </>
);
