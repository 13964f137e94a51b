// A line broke off inside a block: the control may hold a part of it. Nothing goes out until a person says that the
// control was reset.
import { useState } from 'preact/hooks';
import { calls } from '../api/calls';
import type { MachineItem } from '../api/types';
import { reasonText } from '../format/words';
import { isLive } from '../state/select';
import { atLeast } from '../rules/roles';
import { Icon } from './badge';
import { useDesk } from './context';
import { OrderDialog } from './dialog';

export function TornWarning({ machine }: { machine: MachineItem }) {
  const { state, session } = useDesk();
  const [open, setOpen] = useState(false);
  const torn = machine.status.needs_confirmation;
  const may = atLeast(session.role, 'operator');
  return (
    <section class="torn" role="alert" aria-label={`Torn block on ${machine.name}`}>
      <h3>
        <Icon tone="bad" /> Torn block{torn?.job ? `, job ${torn.job}` : ''}
      </h3>
      <p>
        The feed broke off inside a block: the control may hold a part of it. Nothing more goes out on this line until a
        person confirms that the control was reset.
      </p>
      {torn && <p class="torn-text">{reasonText(torn.text)}</p>}
      {may && isLive(state) && (
        <button type="button" class="button button-danger" onClick={() => setOpen(true)}>
          I have reset the control…
        </button>
      )}
      {!may && <p class="hint">An operator can confirm the reset.</p>}
      {open && (
        <OrderDialog
          title={`The control of ${machine.name} was reset?`}
          confirm="I have reset the control"
          danger
          reason="What was done, and why it is safe to go on (kept on record)"
          blocked={isLive(state) ? null : 'The connection to the server is lost: this cannot be ordered now.'}
          send={(key, reason) => calls.confirmReset(machine.name, reason, key)}
          close={() => setOpen(false)}
        >
          {torn && <p class="torn-text">{reasonText(torn.text)}</p>}
          <p>
            Confirm this only after the control was reset and holds no part of the broken block. Then the line may be
            used again; nothing is sent by that.
          </p>
        </OrderDialog>
      )}
    </section>
  );
}
