// The half of the page for who does not stand at a machine: orders, reviews, library, programs, families and parts. It is loaded when one
// of its addresses is asked for.
import { kPeoplePlaces, kProgramPlaces, type DeskView, type PeoplePlace, type ProgramPlace } from '../router';
import { FamiliesView } from './families/families_view';
import { FamilyView } from './families/family_view';
import { PartView } from './families/part_view';
import { LibraryView } from './library/library_view';
import { HistoryView } from './orders/history_view';
import { OrderView } from './orders/order_view';
import { OrdersView } from './orders/orders_view';
import { PeopleView } from './people/people_view';
import { ProgramView } from './program/program_view';
import { ReviewView } from './review/review_view';
import { ReviewedView } from './review/reviewed_view';

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
    case 'orders':
      return <OrdersView query={query} />;
    case 'order':
      return <OrderView key={first} id={Number(first)} />;
    case 'history':
      return <HistoryView query={query} />;
    case 'review':
      return <ReviewView />;
    case 'reviewed':
      return <ReviewedView key={first} id={Number(first)} />;
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
