// The half of the page for who does not stand at a machine: library, programs, families and parts. It is loaded when one
// of its addresses is asked for.
import { kPeoplePlaces, kProgramPlaces, type DeskView, type PeoplePlace, type ProgramPlace } from '../router';
import { FamiliesView } from './families/families_view';
import { FamilyView } from './families/family_view';
import { PartView } from './families/part_view';
import { LibraryView } from './library/library_view';
import { PeopleView } from './people/people_view';
import { ProgramView } from './program/program_view';

interface Props {
  view: DeskView;
  parameters: readonly string[];
  query: URLSearchParams;
}

const peoplePlaceOf = (text: string): PeoplePlace => kPeoplePlaces.find((one) => one === text) ?? 'users';

const placeOf = (text: string): ProgramPlace => kProgramPlaces.find((one) => one === text) ?? 'text';

export function DeskHalf({ view, parameters, query }: Props) {
  const [first = '', second = ''] = parameters;
  switch (view) {
    case 'library':
      return <LibraryView />;
    case 'program':
      return <ProgramView key={first} id={Number(first)} place={placeOf(second)} query={query} />;
    case 'families':
      return <FamiliesView />;
    case 'family':
      return <FamilyView key={first} name={first} />;
    case 'people':
      return <PeopleView place={peoplePlaceOf(first)} />;
    case 'part':
      return <PartView key={first} number={first} />;
  }
}
