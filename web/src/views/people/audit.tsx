// Who did what, newest first.
import { useState } from 'preact/hooks';
import { peopleCalls } from '../../api/people_calls';
import type { AuditRow } from '../../api/types';
import { dateTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { CsvButton } from '../../parts/csv_button';
import { Empty } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { useLoaded } from '../../parts/use_loaded';
import { isoTime, type CsvColumn } from '../../rules/csv';
import { loader } from '../../state/loader';
import { TextField } from './fields';

export function Audit() {
  const [subject, setSubject] = useState('');
  const [actor, setActor] = useState('');
  const [filter, setFilter] = useState<Record<string, string>>({});
  const [more, setMore] = useState<{ of: unknown; rows: AuditRow[]; next: string | null } | null>(null);
  const [error, setError] = useState<unknown>(null);
  const first = useLoaded(JSON.stringify(filter), () => peopleCalls.audit(filter, null));
  const later = more?.of === first.value ? more : null;
  const rows = [...(first.value?.items ?? []), ...(later?.rows ?? [])];
  const next = later ? later.next : (first.value?.next ?? null);
  const load = async () => {
    setError(null);
    try {
      const page = await loader.order(peopleCalls.audit(filter, next));
      setMore({ of: first.value, rows: [...(later?.rows ?? []), ...page.items], next: page.next });
    } catch (failure) {
      setError(failure);
    }
  };
  const showAll = () => {
    setSubject('');
    setActor('');
    setFilter({ subject: '', actor: '' });
  };
  return (
    <section class="people">
      <form
        class="filters"
        onSubmit={(event) => {
          event.preventDefault();
          setFilter({ subject: subject.trim(), actor: actor.trim() });
        }}
      >
        <TextField label={t('audit.subject')} value={subject} change={setSubject} hint={t('audit.subject_hint')} />
        <TextField label={t('audit.actor')} value={actor} change={setActor} />
        <button type="submit" class="button">
          {t('audit.filter')}
        </button>
        <CsvButton name="audit" columns={kCsv} rows={rows} />
      </form>
      <Failure error={first.error ?? error} />
      {first.value?.items.length === 0 && (
        <Empty
          action={
            <button type="button" class="button" onClick={showAll}>
              {t('list.show_all')}
            </button>
          }
        >
          {t('audit.none')}
        </Empty>
      )}
      {rows.length > 0 && (
        <Table
          label={t('people.audit')}
          rows={rows}
          keyOf={({ seq }) => seq}
          columns={[
            { id: 'at', head: t('audit.at'), cell: ({ at_ms }) => dateTime(at_ms) },
            { id: 'actor', head: t('audit.actor'), cell: ({ actor: who }) => who },
            { id: 'action', head: t('audit.action'), cell: ({ action }) => <code>{action}</code> },
            { id: 'subject', head: t('audit.subject'), cell: ({ subject: what }) => what },
            { id: 'detail', head: t('audit.detail'), cell: ({ detail }) => detail },
          ]}
        />
      )}
      {next !== null && rows.length > 0 && (
        <button type="button" class="button" onClick={() => void load()}>
          {t('list.more')}
        </button>
      )}
    </section>
  );
}

const kCsv: CsvColumn<AuditRow>[] = [
  { head: 'seq', of: ({ seq }) => seq },
  { head: 'at', of: ({ at_ms }) => isoTime(at_ms) },
  { head: 'actor', of: ({ actor }) => actor },
  { head: 'action', of: ({ action }) => action },
  { head: 'subject', of: ({ subject }) => subject },
  { head: 'detail', of: ({ detail }) => detail },
  { head: 'hash', of: ({ hash }) => hash },
];
