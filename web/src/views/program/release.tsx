// From a text to its release: a draft binds the newest revision to a machine, and is handed in for review beside what has
// changed since the last one that was released there. To approve is another person's.
import { useState } from 'preact/hooks';
import { newOrderKey } from '../../api/client';
import { deskCalls } from '../../api/desk_calls';
import type { Delivery, Release } from '../../api/types';
import { dateTime } from '../../format/times';
import { deliveryText, releaseText, wordingOfOutcome } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Badge } from '../../parts/badge';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { Empty } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { TargetForm } from '../../parts/target';
import { useLoaded } from '../../parts/use_loaded';
import { hrefs } from '../../router';
import { lastBefore, verdictOf } from '../../rules/releases';
import { atLeast } from '../../rules/roles';
import { loader } from '../../state/loader';
import { bestRole, roleOn } from '../../state/shop';
import { maySomewhere } from './checks';
import { Since } from './since';
import type { PlaceProps } from './program_view';

export function ReleasePlace({ program }: PlaceProps) {
  const may = maySomewhere(program);
  const { value: releases, error, again } = useLoaded(`${program.id}`, () => deskCalls.releasesOf(program.id));
  const [failed, setFailed] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const draft = async (machine: string, delivery: Delivery) => {
    setBusy(true);
    setFailed(null);
    try {
      await loader.order(deskCalls.addRelease(program.id, program.revision, machine, delivery, newOrderKey()));
      again();
    } catch (failure) {
      setFailed(failure);
    }
    setBusy(false);
  };
  const handIn = (release: Release) =>
    showDialog(<HandIn release={release} before={lastBefore(releases ?? [], release)} done={again} />);
  return (
    <>
      <p class="lead">{t('release.lead')}</p>
      {may && <TargetForm fits={({ dialect }) => dialect === program.dialect} busy={busy} confirm={t('release.draft', { revision: program.revision })} send={(machine, delivery) => void draft(machine, delivery)} />}
      <Failure error={failed ?? error} />
      {releases?.length === 0 && <Empty>{t('release.none')}</Empty>}
      {releases && releases.length > 0 && (
        <Table
          label={t('program_place.release')}
          rows={releases}
          keyOf={({ id }) => id}
          marks={({ id, state }) => ({ 'data-release': String(id), 'data-state': state })}
          columns={[
            { id: 'release', head: t('column.release'), cell: ({ id }) => (atLeast(bestRole(), 'approver') ? <a href={hrefs.reviewed(id)}>{id}</a> : id) },
            { id: 'state', head: t('column.state'), cell: (release) => releaseText(release.state) },
            { id: 'machine', head: t('column.machine'), cell: (release) => `${release.machine}, ${deliveryText(release.delivery)}` },
            { id: 'revision', head: t('column.revision'), cell: ({ revision }) => revision },
            { id: 'changed', head: t('column.by'), cell: (release) => dateTime(release.changed_at_ms) },
            may && {
              id: 'orders',
              head: t('column.orders'),
              class: 'orders',
              cell: (release) =>
                release.state === 'draft' &&
                atLeast(roleOn(release.machine), 'programmer') && (
                  <button type="button" class="button button-main" onClick={() => handIn(release)} aria-label={t('release.hand_in_of', { id: release.id })}>
                    {t('release.hand_in')}
                  </button>
                ),
            },
          ]}
        />
      )}
    </>
  );
}

function HandIn({ release, before, done }: { release: Release; before: Release | null; done: () => void }) {
  const [note, setNote] = useState('');
  const verdicts = useLoaded(`${release.program}`, () => deskCalls.checks(release.program));
  const verdict = verdictOf(verdicts.value ?? [], release);
  return (
    <OrderDialog
      title={t('release.hand_in_title', { id: release.id, machine: release.machine })}
      confirm={t('release.hand_in')}
      send={async (key) => {
        await deskCalls.handIn(release.id, note.trim(), key);
        done();
      }}
    >
      {verdicts.value && (
        <p>
          {t('release.verdict')}{' '}
          {verdict ? <Badge wording={wordingOfOutcome(verdict.verdict)} /> : <span class="quiet-text">{t('release.not_checked')}</span>}{' '}
          <a href={hrefs.program(release.program, 'checks', verdict ? { check: String(verdict.id) } : {})}>{t('release.to_checks')}</a>
        </p>
      )}
      <Since release={release} before={before} />
      <label class="field">
        <span>{t('release.note')}</span>
        <input value={note} maxLength={500} onInput={(event) => setNote(event.currentTarget.value)} autocomplete="off" />
      </label>
    </OrderDialog>
  );
}
