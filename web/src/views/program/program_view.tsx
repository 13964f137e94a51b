// One program: its head, and its places, each with an address of its own: text, revisions, comparison, uses, files,
// checks, release. What is typed and not saved is kept when one goes from place to place.
import { useEffect, useRef } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Program } from '../../api/types';
import { dateTime } from '../../format/times';
import { dialectText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { AttachedFiles } from '../../parts/attached_files';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { atLeast } from '../../rules/roles';
import { hrefs, kProgramPlaces, type ProgramPlace } from '../../router';
import { takePrograms } from '../../state/changes';
import { person } from '../../state/shop';
import { Labels } from '../library/labels';
import { ArchiveButton } from '../library/orders';
import { ChecksPlace } from './checks';
import { ComparePlace } from './compare';
import { ReleasePlace } from './release';
import { RevisionsPlace } from './revisions';
import { TextPlace } from './text_place';
import { UsesPlace } from './uses';

export interface PlaceProps {
  program: Program;
  query: URLSearchParams;
  isProgrammer: boolean;
  may: boolean; // write: a programmer, and the program is in use
  changed: (program: Program) => void;
  again: () => void;
}

const FilesPlace = ({ program, may }: PlaceProps) => <AttachedFiles owner={{ program: program.id }} may={may} />;

const kPlaces: Record<ProgramPlace, (props: PlaceProps) => preact.ComponentChildren> = {
  text: TextPlace,
  revisions: RevisionsPlace,
  compare: ComparePlace,
  uses: UsesPlace,
  files: FilesPlace,
  checks: ChecksPlace,
  release: ReleasePlace,
};

export function ProgramView({ id, place, query }: { id: number; place: ProgramPlace; query: URLSearchParams }) {
  const { value: program, error, again, set } = useLoaded(String(id), () => deskCalls.program(id));
  // Its name, for the tab's title.
  useEffect(() => {
    if (program) takePrograms([program]);
  }, [program]);
  if (!program)
    return (
      <>
        <h1 tabIndex={-1}>{t('program.number', { id })}</h1>
        {error === null ? (
          <p class="waiting" role="status">
            {t('page.loading')}
          </p>
        ) : (
          <Failure error={error} />
        )}
        <a href={hrefs.library}>{t('program.to_library')}</a>
      </>
    );
  const isProgrammer = atLeast(person().role, 'programmer');
  const Place = kPlaces[place];
  return (
    <>
      <div class="program-head">
        <h1 tabIndex={-1}>{program.name}</h1>
        <p class="quiet-text">
          {dialectText(program.dialect)}, {t('job.revision', { revision: program.revision })},{' '}
          {t('library.changed', { name: program.created_by, at: dateTime(program.created_at_ms) })}
        </p>
        <Labels program={program} may={isProgrammer && !program.archived} changed={set} />
        {isProgrammer && <ArchiveButton program={program} changed={set} />}
      </div>
      {program.archived && (
        <p class="notice tone-waiting">{t('library.archived_by', { name: program.archived.by, reason: program.archived.reason })}</p>
      )}
      <Tabs program={program} place={place} />
      <Place program={program} query={query} isProgrammer={isProgrammer} may={isProgrammer && !program.archived} changed={set} again={again} />
    </>
  );
}

// On a narrow screen they are a row that is moved: the one that is open is in sight.
function Tabs({ program, place }: { program: Program; place: ProgramPlace }) {
  const row = useRef<HTMLElement>(null);
  useEffect(() => {
    const open = row.current?.querySelector<HTMLElement>('[aria-current]');
    if (row.current && open) row.current.scrollLeft = open.offsetLeft - row.current.offsetLeft - row.current.clientWidth / 4;
  }, [place]);
  return (
    <nav ref={row} class="tabs" aria-label={t('program.places', { name: program.name })}>
      {kProgramPlaces.map((one) => (
        <a key={one} href={hrefs.program(program.id, one)} aria-current={one === place ? 'page' : undefined}>
          {t(`program_place.${one}`)}
        </a>
      ))}
    </nav>
  );
}
