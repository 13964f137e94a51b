// The servers that share this store, and whose each machine's line is. A line goes to another server by a person alone:
// who has it gives it away; from one that is not heard of, the server that is to have it takes it.
import { useEffect, useState } from 'preact/hooks';
import { peopleCalls } from '../../api/people_calls';
import type { ServerNode } from '../../api/types';
import { dateTime } from '../../format/times';
import type { Wording } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Badge } from '../../parts/badge';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { Empty } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { linesOf, orderOf, type ServedLine } from '../../rules/servers';

const kAgainMs = 5_000; // whether a server is heard of is no event

export function Servers() {
  const servers = useLoaded('servers', peopleCalls.servers);
  useEffect(() => {
    const timer = setInterval(() => !document.hidden && servers.again(), kAgainMs);
    return () => clearInterval(timer);
  }, []);
  const all = servers.value;
  return (
    <section class="people">
      <p class="lead">{t('store_servers.lead')}</p>
      <Failure error={servers.error} />
      {all?.length === 0 && <Empty>{t('store_servers.alone')}</Empty>}
      {all && all.length > 0 && (
        <>
          <All servers={all} />
          <h2>{t('store_servers.lines')}</h2>
          <Lines servers={all} done={servers.again} />
        </>
      )}
    </section>
  );
}

const wordingOf = (server: ServerNode): Wording => ({
  text: t(server.this ? 'store_servers.this' : server.answers ? 'store_servers.heard' : 'store_servers.unheard'),
  tone: server.answers ? 'good' : 'bad',
});

const All = ({ servers }: { servers: readonly ServerNode[] }) => (
  <Table
    label={t('people.servers')}
    rows={servers}
    keyOf={({ name }) => name}
    marks={({ name }) => ({ 'data-server': name })}
    columns={[
      { id: 'name', head: t('column.name'), cell: ({ name }) => <strong>{name}</strong> },
      {
        id: 'state',
        head: t('column.state'),
        cell: (server) => <Badge wording={wordingOf(server)} />,
      },
      {
        id: 'address',
        head: t('store_servers.address'),
        cell: ({ url, ...server }) => (url && !server.this ? <a href={url}>{url}</a> : url),
      },
      { id: 'version', head: t('store_servers.version'), cell: ({ version }) => version },
      { id: 'started', head: t('store_servers.started'), cell: (server) => dateTime(server.started_at_ms) },
      { id: 'seen', head: t('store_servers.seen'), cell: (server) => dateTime(server.seen_at_ms) },
    ]}
  />
);

function Lines({ servers, done }: { servers: readonly ServerNode[]; done: () => void }) {
  const order = (line: ServedLine) => {
    const kind = orderOf(line, servers);
    if (kind === null) return null;
    const dialog = kind === 'hand_over' ? <HandOver line={line} servers={servers} done={done} /> : <TakeOver line={line} done={done} />;
    return (
      <button type="button" class="button button-small" onClick={() => showDialog(dialog)} aria-label={t(`store_servers.${kind}_of`, { machine: line.name })}>
        {t(`store_servers.${kind}`)}
      </button>
    );
  };
  return (
    <Table
      label={t('store_servers.lines')}
      rows={linesOf(servers)}
      keyOf={({ name }) => name}
      marks={({ name }) => ({ 'data-line': name })}
      columns={[
        { id: 'machine', head: t('column.machine'), cell: ({ name }) => <strong>{name}</strong>, by: ({ name }) => name },
        { id: 'server', head: t('store_servers.server'), cell: ({ server }) => server.name, by: ({ server }) => server.name },
        { id: 'since', head: t('store_servers.since'), cell: (line) => dateTime(line.since_ms), by: (line) => line.since_ms },
        { id: 'by', head: t('store_servers.given_by'), cell: (line) => line.given_by },
        { id: 'reason', head: t('column.reason'), cell: ({ reason }) => reason },
        { id: 'orders', head: t('column.orders'), class: 'orders', cell: order },
      ]}
    />
  );
}

function HandOver({ line, servers, done }: { line: ServedLine; servers: readonly ServerNode[]; done: () => void }) {
  const others = servers.filter((server) => !server.this);
  const [to, setTo] = useState(others.find(({ answers }) => answers)?.name ?? others[0]?.name ?? '');
  return (
    <OrderDialog
      title={t('store_servers.hand_over_of', { machine: line.name })}
      confirm={t('store_servers.hand_over')}
      reason={t('column.reason')}
      blocked={others.find(({ name }) => name === to)?.answers === false ? t('store_servers.to_unheard', { server: to }) : null}
      send={(key, reason) => peopleCalls.handOver(line.name, to, reason, key).then(done)}
    >
      <p>{t('store_servers.hand_over_text', { machine: line.name })}</p>
      <label class="field">
        <span>{t('store_servers.to')}</span>
        <select value={to} onChange={(event) => setTo(event.currentTarget.value)}>
          {others.map(({ name }) => (
            <option key={name}>{name}</option>
          ))}
        </select>
      </label>
    </OrderDialog>
  );
}

function TakeOver({ line, done }: { line: ServedLine; done: () => void }) {
  const [seen, setSeen] = useState(false);
  const server = line.server.name;
  return (
    <OrderDialog
      title={t('store_servers.take_over_of', { machine: line.name })}
      confirm={t('store_servers.take_over')}
      danger
      reason={t('column.reason')}
      blocked={seen ? null : t('store_servers.not_seen')}
      send={(key, reason) => peopleCalls.takeOver(line.name, reason, key).then(done)}
    >
      <p>{t('store_servers.take_over_text', { machine: line.name, server, time: dateTime(line.server.seen_at_ms) })}</p>
      <label class="check">
        <input type="checkbox" checked={seen} onChange={(event) => setSeen(event.currentTarget.checked)} /> {t('store_servers.seen_off', { server })}
      </label>
    </OrderDialog>
  );
}
