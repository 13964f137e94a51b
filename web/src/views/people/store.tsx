// The whole store: where it is and what room it has, reading it through, and its backups. Both go on in a process of
// their own, and no line waits for them.
import { useState } from 'preact/hooks';
import { newOrderKey } from '../../api/client';
import { peopleCalls } from '../../api/people_calls';
import type { Backup, StoreRoom, StoreVerification } from '../../api/types';
import { bytes, count } from '../../format/numbers';
import { dateTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { Empty } from '../../parts/empty';
import { Facts } from '../../parts/facts';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { loader } from '../../state/loader';

export function Store() {
  const room = useLoaded('store', peopleCalls.store);
  const [busy, setBusy] = useState(false); // one at a time
  return (
    <section class="people">
      <p class="lead">{t('store.lead')}</p>
      <Failure error={room.error} />
      {room.value && <Room room={room.value} />}
      <Verification busy={busy} setBusy={setBusy} />
      {room.value && <Backing busy={busy} setBusy={setBusy} room={room.value} done={room.again} />}
      <p>
        <a href="/docs/licences">{t('store.licences')}</a>
      </p>
    </section>
  );
}

interface WorkProps {
  busy: boolean;
  setBusy: (busy: boolean) => void;
}

// One piece of work that a person asks for: its result, or why there is none.
function useWork<Result>({ setBusy }: WorkProps, ask: (key: string) => Promise<Result>) {
  const [result, setResult] = useState<Result | null>(null);
  const [error, setError] = useState<unknown>(null);
  const [running, setRunning] = useState(false);
  const begin = async () => {
    setBusy(true);
    setRunning(true);
    setError(null);
    setResult(null);
    try {
      setResult(await loader.order(ask(newOrderKey())));
    } catch (failure) {
      setError(failure);
    }
    setRunning(false);
    setBusy(false);
  };
  return { result, error, running, begin };
}

function Verification(props: WorkProps) {
  const { result, error, running, begin } = useWork(props, peopleCalls.verifyStore);
  return (
    <>
      <h2>{t('store.soundness')}</h2>
      <p class="hint">{t('store.verify_hint')}</p>
      <button type="button" class="button" disabled={props.busy} onClick={() => void begin()}>
        {t(running ? 'store.verifying' : 'store.verify')}
      </button>
      <Failure error={error} />
      {result && <Found found={result} />}
    </>
  );
}

function Backing({ room, done, ...props }: WorkProps & { room: StoreRoom; done: () => void }) {
  const backups = useLoaded('backups', peopleCalls.backups);
  const again = () => {
    backups.again();
    done();
  };
  const { result: made, error, running, begin } = useWork(props, (key) => peopleCalls.addBackup(key).finally(again));
  const isHere = room.why_no_backups === null;
  const backUp = (
    <button type="button" class="button button-main" disabled={props.busy || !isHere} onClick={() => void begin()}>
      {t(running ? 'store.backing_up' : 'store.back_up')}
    </button>
  );
  return (
    <>
      <h2>{t('store.backups')}</h2>
      <p class="hint">{isHere ? t('store.backup_hint', { folder: room.backups ?? '' }) : t('store.no_backups')}</p>
      {made && (
        <p class="notice tone-good" role="status">
          {t('store.made', { name: made.backup, size: bytes(made.bytes), programs: made.holds.programs, machines: made.holds.machines })}
        </p>
      )}
      <Failure error={error ?? backups.error} />
      {backups.value?.length === 0 && <Empty action={backUp}>{t('store.none')}</Empty>}
      {backups.value && backups.value.length > 0 && (
        <>
          {backUp}
          <Backups backups={backups.value} done={again} />
        </>
      )}
    </>
  );
}

// Room on a disk: whether it lasts, not each byte.
const gigabytes = (value: number): string => (value < 1e9 ? bytes(value) : `${(value / 1e9).toFixed(1)}\u202FGB`);

const Room = ({ room }: { room: StoreRoom }) => (
  <Facts
    facts={[
      [t('store.engine'), room.engine === 'sqlite' ? 'SQLite' : 'PostgreSQL'],
      [t('store.folder'), <code key="folder">{room.folder}</code>],
      [t('store.size'), room.bytes === null ? null : bytes(room.bytes)],
      [t('store.free'), room.free_bytes === null ? null : gigabytes(room.free_bytes)],
      [t('store.backups_free'), room.backups_free_bytes === null ? null : gigabytes(room.backups_free_bytes)],
    ]}
  />
);

const Found = ({ found }: { found: StoreVerification }) => (
  <>
    <p class={`notice tone-${found.whole ? 'good' : 'bad'}`} role="status">
      {found.whole ? t('store.whole') : t('store.has_faults', { count: found.faults.length })}
    </p>
    <ul class="listed">
      {found.faults.map(({ subject, what }) => (
        <li key={subject}>
          <code>{subject}</code>: {what}
        </li>
      ))}
    </ul>
    <Facts
      facts={[
        [t('people.audit'), t('store.rows', { count: found.audit.rows, text: count(found.audit.rows) })],
        [t('store.head'), <code key="head">{found.audit.head}</code>],
        [t('store.ledger'), t('store.ledger_rows', { rows: count(found.ledger.rows), jobs: found.ledger.jobs })],
        [t('store.contents'), t('store.texts', { count: found.contents.count, size: bytes(found.contents.bytes) })],
      ]}
    />
  </>
);

const Backups = ({ backups, done }: { backups: readonly Backup[]; done: () => void }) => (
  <Table
    label={t('store.backups')}
    rows={backups}
    keyOf={({ name }) => name}
    columns={[
      { id: 'name', head: t('column.name'), cell: ({ name }) => <code>{name}</code> },
      { id: 'made', head: t('store.made_at'), cell: ({ made_at_ms }) => dateTime(made_at_ms), by: ({ made_at_ms }) => made_at_ms },
      { id: 'size', head: t('store.size'), cell: (backup) => bytes(backup.bytes), by: (backup) => backup.bytes },
      {
        id: 'orders',
        head: t('column.orders'),
        class: 'orders',
        cell: ({ name }) => (
          <button type="button" class="button button-small" aria-label={t('people.remove_of', { name })} onClick={() => showDialog(<RemoveDialog name={name} done={done} />)}>
            {t('people.remove')}
          </button>
        ),
      },
    ]}
  />
);

const RemoveDialog = ({ name, done }: { name: string; done: () => void }) => (
  <OrderDialog title={t('people.remove_of', { name })} confirm={t('people.remove')} danger send={(key) => peopleCalls.removeBackup(name, key).then(done)}>
    <p>{t('store.remove_text')}</p>
  </OrderDialog>
);
