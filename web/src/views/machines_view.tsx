// All machines, torn lines first: they need a person.
import { isTorn } from '../rules/lines';
import { useDesk } from './context';
import { MachineCard } from './machine_card';

export function MachinesView() {
  const { state } = useDesk();
  const entries = [...state.machines.values()].sort((a, b) => {
    const order = Number(isTorn(b.item.status)) - Number(isTorn(a.item.status));
    return order || a.item.name.localeCompare(b.item.name);
  });
  return (
    <>
      <h1 tabIndex={-1}>Machines</h1>
      {entries.length === 0 && <p class="empty">No machine is set up yet. An administrator adds them by the API or the command.</p>}
      <div class="cards">
        {entries.map((entry) => (
          <MachineCard key={entry.item.name} entry={entry} />
        ))}
      </div>
    </>
  );
}
