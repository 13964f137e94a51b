// Checks of this program: the verdicts so far, a new one for a machine, and what one found, each finding with its line.
import { useState } from 'preact/hooks';
import { newOrderKey } from '../../api/client';
import { deskCalls } from '../../api/desk_calls';
import type { Delivery, Program } from '../../api/types';
import { dateTime } from '../../format/times';
import { deliveryText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Empty } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { TargetForm } from '../../parts/target';
import { useLoaded } from '../../parts/use_loaded';
import { goUnlessLeft, hrefs } from '../../router';
import { atLeast } from '../../rules/roles';
import { loader } from '../../state/loader';
import { bestRole } from '../../state/shop';
import { WaiverText } from '../review/waive';
import type { PlaceProps } from './program_view';
import { OutcomeBadge, VerdictReport } from './verdict_report';

export function ChecksPlace({ program, query }: PlaceProps) {
  const may = maySomewhere(program);
  const { value: verdicts, error, again } = useLoaded(String(program.id), () => deskCalls.checks(program.id));
  const shown = Number(query.get('check')) || verdicts?.[0]?.id || null;
  return (
    <>
      {may && (
        <CheckForm
          program={program.id}
          revision={program.revision}
          dialect={program.dialect}
          done={again}
        />
      )}
      <Failure error={error} />
      {verdicts?.length === 0 && <Empty>{t(may ? 'checks.none' : 'checks.none_viewer')}</Empty>}
      {verdicts && verdicts.length > 0 && (
        <Table
          label={t('program_place.checks')}
          rows={verdicts}
          keyOf={({ id }) => id}
          marks={({ id }) => (id === shown ? { 'data-shown': 'true' } : {})}
          columns={[
            {
              id: 'verdict',
              head: t('column.verdict'),
              cell: ({ id, verdict, stale, waivers }) => (
                <>
                  <OutcomeBadge outcome={verdict} />{' '}
                  <a href={hrefs.program(program.id, 'checks', { check: String(id) })}>{t('checks.report', { id })}</a>
                  {stale && <span class="reason">{t('checks.stale')}</span>}
                  {waivers.map((one) => (
                    <span key={`${one.at_ms} ${one.point}`} class="reason">
                      <WaiverText of={one} />
                    </span>
                  ))}
                </>
              ),
            },
            { id: 'machine', head: t('column.machine'), cell: ({ machine, delivery }) => `${machine}, ${deliveryText(delivery)}` },
            { id: 'revision', head: t('column.revision'), cell: ({ revision }) => revision },
            { id: 'by', head: t('column.by'), cell: (one) => t('library.changed', { name: one.created_by, at: dateTime(one.created_at_ms) }) },
          ]}
        />
      )}
      {shown !== null && <VerdictReport key={shown} id={shown} program={program.id} />}
    </>
  );
}

// On some machine at least: a person may have another role there than in the rest of the shop.
export const maySomewhere = (program: Program): boolean => !program.archived && atLeast(bestRole(), 'programmer');

interface CheckFormProps {
  program: number;
  revision: number;
  dialect: string;
  done: () => void;
}

function CheckForm({ program, revision, dialect, done }: CheckFormProps) {
  const [error, setError] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const check = async (machine: string, delivery: Delivery) => {
    setBusy(true);
    setError(null);
    const follow = goUnlessLeft();
    try {
      const verdict = await loader.order(deskCalls.addCheck(program, revision, machine, delivery, newOrderKey()));
      done();
      follow(hrefs.program(program, 'checks', { check: String(verdict.id) }));
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  return (
    <>
      <TargetForm fits={(one) => one.dialect === dialect} busy={busy} confirm={busy ? t('checks.running') : t('checks.start', { revision })} send={(machine, delivery) => void check(machine, delivery)} />
      <Failure error={error} />
    </>
  );
}
