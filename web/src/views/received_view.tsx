// What controls punched: each receipt with its state, why it is in quarantine, and how it compares with the stored
// program of its name. It is live. Nothing is accepted unread: the text stands in the dialog. Accepting makes a
// revision; nothing is ever overwritten.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../api/calls';
import type { Receipt } from '../api/types';
import { bytes, shortHash } from '../format/numbers';
import { dateTime } from '../format/times';
import { receiptWording } from '../format/words';
import { t } from '../i18n/i18n';
import { Badge } from '../parts/badge';
import { OrderDialog, showDialog } from '../parts/dialog';
import { Empty, GoTo } from '../parts/empty';
import { Failure } from '../parts/failure';
import { lazyView } from '../parts/lazy';
import { Table } from '../parts/table';
import { hrefs } from '../router';
import { atLeast } from '../rules/roles';
import { bestRole, isLive, receiptNews, roleOn } from '../state/shop';
import { loader } from '../state/loader';

export function ReceivedView() {
  const [receipts, setReceipts] = useState<Receipt[] | null>(null);
  const [next, setNext] = useState<string | null>(null);
  const [error, setError] = useState<unknown>(null);
  const live = isLive.value;
  const news = receiptNews.value;
  const load = async (after: string | null) => {
    setError(null);
    try {
      const page = await loader.order(calls.receipts(after));
      setReceipts((before) => (after === null ? page.items : [...(before ?? []), ...page.items]));
      setNext(page.next);
    } catch (failure) {
      setError(failure);
    }
  };
  useEffect(() => {
    if (live) void load(null);
  }, [live, news]);
  const mayAccept = atLeast(bestRole(), 'programmer');
  return (
    <>
      <h1 tabIndex={-1}>{t('nav.received')}</h1>
      <p class="lead">{t('received.lead')}</p>
      <Failure error={error} />
      {receipts?.length === 0 && <Empty action={<GoTo href={hrefs.floor}>{t('not_found.floor')}</GoTo>}>{t('received.empty')}</Empty>}
      {receipts && receipts.length > 0 && (
        <Table
          label={t('nav.received')}
          rows={receipts}
          keyOf={(receipt) => receipt.id}
          marks={(receipt) => ({ 'data-receipt': String(receipt.id) })}
          columns={[
            {
              id: 'name',
              head: t('column.name'),
              cell: (receipt) => (
                <>
                  <strong>{receipt.name}</strong>{' '}
                  <span class="quiet-text">
                    {bytes(receipt.bytes)}, <code title={receipt.sha256}>{shortHash(receipt.sha256)}…</code>
                  </span>
                </>
              ),
            },
            {
              id: 'state',
              head: t('column.state'),
              cell: (receipt) => (
                <>
                  <Badge wording={receiptWording(receipt.state)} />
                  {(receipt.decided_reason || receipt.reason) && <span class="reason">{receipt.decided_reason || receipt.reason}</span>}
                </>
              ),
            },
            { id: 'machine', head: t('column.machine'), cell: (receipt) => receipt.machine },
            { id: 'at', head: t('column.received'), cell: (receipt) => dateTime(receipt.at_ms) },
            { id: 'stored', head: t('column.stored'), cell: likenessText },
            mayAccept && {
              id: 'orders',
              head: t('column.orders'),
              class: 'orders',
              cell: (receipt) => atLeast(roleOn(receipt.machine), 'programmer') && <Orders receipt={receipt} live={live} done={() => void load(null)} />,
            },
          ]}
        />
      )}
      {next !== null && (
        <button type="button" class="button" onClick={() => void load(next)}>
          {t('list.more')}
        </button>
      )}
    </>
  );
}

function Orders({ receipt, live, done }: { receipt: Receipt; live: boolean; done: () => void }) {
  const mayDiscard = atLeast(roleOn(receipt.machine), 'approver');
  const open = receipt.state === 'stored' || receipt.state === 'quarantined';
  const isKept = receipt.state === 'quarantined';
  const ask = (order: 'accept' | 'discard') => live && showDialog(<Decision receipt={receipt} order={order} done={done} />);
  return (
    <>
      {open && (!isKept || mayDiscard) && (
        <button
          type="button"
          class={isKept ? 'button' : 'button button-main'}
          aria-disabled={!live}
          onClick={() => ask('accept')}
          aria-label={t(isKept ? 'received.take_out_of' : 'received.accept_of', { id: receipt.id })}
        >
          {t(isKept ? 'received.accept_reason' : 'received.accept')}
        </button>
      )}
      {open && mayDiscard && (
        <button type="button" class="button" aria-disabled={!live} onClick={() => ask('discard')} aria-label={t('received.discard_of', { id: receipt.id })}>
          {t('received.discard')}
        </button>
      )}
    </>
  );
}

// Accepting goes to the program of the same name where there is one, as its next revision.
function Decision({ receipt, order, done }: { receipt: Receipt; order: 'accept' | 'discard'; done: () => void }) {
  const [read, setRead] = useState(false);
  const finish = async (sent: Promise<unknown>) => {
    await sent;
    done();
  };
  const { id, name } = receipt;
  if (order === 'discard')
    return (
      <OrderDialog title={t('received.discard_title', { name })} confirm={t('received.discard')} danger reason={t('received.why_not')} send={(key, reason) => finish(calls.discardReceipt(id, reason, key))}>
        <p>{t('received.discard_text')}</p>
      </OrderDialog>
    );
  const isKept = receipt.state === 'quarantined';
  const send = (key: string, reason: string) =>
    finish(isKept ? calls.acceptFromQuarantine(id, reason, key) : calls.acceptReceipt(id, receipt.stored, key));
  return (
    <OrderDialog
      title={t(isKept ? 'received.take_out_title' : 'received.accept_title', { name })}
      confirm={t('received.accept')}
      danger={isKept}
      {...(isKept ? { reason: t('received.why_right') } : {})}
      blocked={read ? null : t('received.read_first')}
      send={send}
    >
      <p>
        {isKept && t('received.is_kept', { reason: receipt.reason ?? '' })} {becomesText(receipt)} {t('received.not_released')}
      </p>
      <ReceiptText receipt={receipt} shown={() => setRead(true)} />
    </OrderDialog>
  );
}

const Differences = lazyView(() => import('./received/differences').then((half) => half.Differences));

const kMostShown = 20_000; // characters

// The text of a receipt; of a broken one what can be read, in the code that it came in.
function ReceiptText({ receipt, shown }: { receipt: Receipt; shown: () => void }) {
  const [text, setText] = useState<string | null>(null);
  const [error, setError] = useState<unknown>(null);
  useEffect(() => {
    loader.order(calls.receiptText(receipt.id, receipt.state === 'quarantined')).then((found) => {
      setText(found);
      shown();
    }, setError);
  }, [receipt.id]);
  return (
    <>
      <Failure error={error} />
      {text !== null && (
        <pre class="text-box" tabIndex={0} aria-label={t('received.text')}>
          {text.slice(0, kMostShown)}
          {text.length > kMostShown && `\n${t('received.cut', { rest: text.length - kMostShown })}`}
        </pre>
      )}
      {text !== null && receipt.stored && !receipt.stored.same && <Differences receipt={receipt} text={text} />}
    </>
  );
}

const becomesText = ({ stored }: Receipt): string =>
  stored ? t('received.becomes_revision', { revision: stored.revision + 1, program: stored.program }) : t('received.becomes_program');

function likenessText(receipt: Receipt): string {
  if (receipt.program !== null) return t('received.as', { program: receipt.program, revision: receipt.revision ?? 0 });
  if (!receipt.stored) return receipt.state === 'stored' ? t('received.none_of_name') : '';
  const { revision, same, difference } = receipt.stored;
  return same ? t('received.same', { revision }) : t('received.differs', { revision, difference: difference ?? '?' });
}
