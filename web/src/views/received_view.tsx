// What controls punched: each receipt with its state, why it is in quarantine, and how it compares with the stored
// program of its name. Accepting makes a revision; nothing is ever overwritten.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../api/calls';
import type { Receipt } from '../api/types';
import { shortHash } from '../format/numbers';
import { dateTime } from '../format/times';
import { receiptWording } from '../format/words';
import { atLeast } from '../rules/roles';
import { isLive } from '../state/select';
import { Badge } from './badge';
import { useDesk } from './context';
import { Failure, OrderDialog } from './dialog';

type Asked = { order: 'accept' | 'discard'; receipt: Receipt } | null;

export function ReceivedView() {
  const { state, sync, session } = useDesk();
  const [receipts, setReceipts] = useState<Receipt[] | null>(null);
  const [error, setError] = useState<unknown>(null);
  const [asked, setAsked] = useState<Asked>(null);
  const live = isLive(state);
  const load = async () => {
    setError(null);
    try {
      setReceipts((await sync.order(calls.receipts())).items);
    } catch (failure) {
      setError(failure);
    }
  };
  useEffect(() => {
    if (live) void load();
  }, [live]);

  const mayAccept = atLeast(session.role, 'programmer');
  const mayDiscard = atLeast(session.role, 'approver');
  return (
    <>
      <h1 tabIndex={-1}>Received</h1>
      <p class="lead">Programs that controls punched. They are kept here until a person accepts or discards them.</p>
      <Failure error={error} />
      {receipts?.length === 0 && <p class="empty">Nothing was received yet.</p>}
      {receipts && receipts.length > 0 && (
        <table class="table">
          <thead>
            <tr>
              <th scope="col">Name</th>
              <th scope="col">State</th>
              <th scope="col">Machine</th>
              <th scope="col">Received</th>
              <th scope="col">Stored program</th>
              {mayAccept && <th scope="col">Orders</th>}
            </tr>
          </thead>
          <tbody>
            {receipts.map((receipt) => (
              <ReceiptRow
                key={receipt.id}
                receipt={receipt}
                orders={
                  mayAccept
                    ? { live, mayDiscard, ask: (order) => setAsked({ order, receipt }) }
                    : null
                }
              />
            ))}
          </tbody>
        </table>
      )}
      {asked && <Decision asked={asked} close={() => setAsked(null)} done={() => void load()} />}
    </>
  );
}

interface Orders {
  live: boolean;
  mayDiscard: boolean;
  ask: (order: 'accept' | 'discard') => void;
}

function ReceiptRow({ receipt, orders }: { receipt: Receipt; orders: Orders | null }) {
  const wording = receiptWording(receipt.state);
  const open = receipt.state === 'stored' || receipt.state === 'quarantined';
  return (
    <tr data-receipt={receipt.id}>
      <td data-label="Name">
        <strong>{receipt.name}</strong>{' '}
        <span class="quiet-text">
          {receipt.bytes} bytes, <code title={receipt.sha256}>{shortHash(receipt.sha256)}…</code>
        </span>
      </td>
      <td data-label="State">
        <Badge wording={wording} />
        {(receipt.decided_reason || receipt.reason) && <span class="reason">{receipt.decided_reason || receipt.reason}</span>}
        {receipt.state === 'quarantined' && <ReadableText receipt={receipt} />}
      </td>
      <td data-label="Machine">{receipt.machine}</td>
      <td data-label="Received">{dateTime(receipt.at_ms)}</td>
      <td data-label="Stored program">{likenessText(receipt)}</td>
      {orders && (
        <td data-label="Orders" class="orders">
          {receipt.state === 'stored' && (
            <button type="button" class="button button-main" disabled={!orders.live} onClick={() => orders.ask('accept')} aria-label={`Accept receipt ${receipt.id}`}>
              Accept
            </button>
          )}
          {receipt.state === 'quarantined' && orders.mayDiscard && (
            <button type="button" class="button" disabled={!orders.live} onClick={() => orders.ask('accept')} aria-label={`Take receipt ${receipt.id} out of quarantine`}>
              Accept with a reason
            </button>
          )}
          {open && orders.mayDiscard && (
            <button type="button" class="button" disabled={!orders.live} onClick={() => orders.ask('discard')} aria-label={`Discard receipt ${receipt.id}`}>
              Discard
            </button>
          )}
        </td>
      )}
    </tr>
  );
}

// Accepting goes to the program of the same name where there is one, as its next revision.
function Decision({ asked, close, done }: { asked: NonNullable<Asked>; close: () => void; done: () => void }) {
  const { receipt } = asked;
  const finish = async (sent: Promise<unknown>) => {
    await sent;
    done();
  };
  if (asked.order === 'discard')
    return (
      <OrderDialog title={`Discard ${receipt.name}`} confirm="Discard" danger reason="Why it is not wanted" send={(key, reason) => finish(calls.discardReceipt(receipt.id, reason, key))} close={close}>
        <p>The receipt stays in the list, with the reason.</p>
      </OrderDialog>
    );
  if (receipt.state === 'quarantined')
    return (
      <OrderDialog title={`Accept ${receipt.name} from quarantine`} confirm="Accept" danger reason="Why it is right all the same" send={(key, reason) => finish(calls.acceptFromQuarantine(receipt.id, reason, key))} close={close}>
        <p>
          It is in quarantine: {receipt.reason}. <ReadableText receipt={receipt} /> becomes a new program. It is not released by that.
        </p>
      </OrderDialog>
    );
  const stored = receipt.stored;
  return (
    <OrderDialog title={`Accept ${receipt.name}`} confirm="Accept" send={(key) => finish(calls.acceptReceipt(receipt.id, stored, key))} close={close}>
      <p>
        {stored
          ? `It becomes revision ${stored.revision + 1} of program ${stored.program}. ${likenessText(receipt)}.`
          : 'It becomes a new program.'}{' '}
        It is not released by that.
      </p>
    </OrderDialog>
  );
}

// What can be read of a broken one, in the code that it came in.
function ReadableText({ receipt }: { receipt: Receipt }) {
  return (
    <a href={`/api/v1/receipts/${receipt.id}/text?form=read`} target="_blank" rel="noreferrer">
      What can be read
    </a>
  );
}

function likenessText(receipt: Receipt): string {
  if (receipt.program !== null) return `program ${receipt.program} rev. ${receipt.revision}`;
  if (!receipt.stored) return receipt.state === 'stored' ? 'none of this name' : '';
  const { revision, same, difference } = receipt.stored;
  return same ? `same as rev. ${revision}` : `differs from rev. ${revision}: ${difference ?? 'elsewhere'}`;
}
