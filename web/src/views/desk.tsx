// The half of the page for who does not stand at a machine: receipts, orders, reviews, library, programs, families and parts. It is loaded when one
// of its addresses is asked for.
import type { VNode } from 'preact';
import { kPeoplePlaces, kProgramPlaces, type DeskView, type PeoplePlace, type ProgramPlace } from '../router';
import { FamiliesView } from './families/families_view';
import { FamilyView } from './families/family_view';
import { PartView } from './families/part_view';
import { LibraryView } from './library/library_view';
import { HistoryView } from './orders/history_view';
import { OrderView } from './orders/order_view';
import { OrdersView } from './orders/orders_view';
import { PeopleView } from './people/people_view';
import { ProfileView } from './people/profile_view';
import { ProgramView } from './program/program_view';
import { ReceivedView } from './received_view';
import { ReviewView } from './review/review_view';
import { ReviewedView } from './review/reviewed_view';

interface Props {
  view: DeskView;
  parameters: readonly string[];
  query: URLSearchParams;
}

const peoplePlaceOf = (text: string): PeoplePlace => kPeoplePlaces.find((one) => one === text) ?? 'users';

const placeOf = (text: string): ProgramPlace => kProgramPlaces.find((one) => one === text) ?? 'text';

type Draw = (first: string, second: string, query: URLSearchParams) => VNode;

const kViews: Record<DeskView, Draw> = {
  received: () => <ReceivedView />,
  orders: (_first, _second, query) => <OrdersView query={query} />,
  order: (id) => <OrderView key={id} id={Number(id)} />,
  history: (_first, _second, query) => <HistoryView query={query} />,
  review: () => <ReviewView />,
  reviewed: (release) => <ReviewedView key={release} id={Number(release)} />,
  library: () => <LibraryView />,
  program: (id, place, query) => <ProgramView key={id} id={Number(id)} place={placeOf(place)} query={query} />,
  families: () => <FamiliesView />,
  family: (name) => <FamilyView key={name} name={name} />,
  people: (place) => <PeopleView place={peoplePlaceOf(place)} />,
  profile: (name, _second, query) => <ProfileView key={`${name} ${query.get('of') ?? ''}`} name={name === '' ? null : name} copyOf={query.get('of')} />,
  part: (number) => <PartView key={number} number={number} />,
};

export const DeskHalf = ({ view, parameters: [first = '', second = ''], query }: Props) => kViews[view](first, second, query);
