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
import { useLoaded } from '../../parts/use_loaded';
import { hrefs } from '../../router';
import { atLeast } from '../../rules/roles';
import { loader } from '../../state/loader';
import { roleOn } from '../../state/shop';
import { MachineForm, maySomewhere } from './checks';
import { ComparedView } from './compare';
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
      {may && <MachineForm dialect={program.dialect} busy={busy} confirm={t('release.draft', { revision: program.revision })} send={(machine, delivery) => void draft(machine, delivery)} />}
      <Failure error={failed ?? error} />
      {releases?.length === 0 && <Empty>{t('release.none')}</Empty>}
      {releases && releases.length > 0 && (
        <Table
          label={t('program_place.release')}
          rows={releases}
          keyOf={({ id }) => id}
          marks={({ id, state }) => ({ 'data-release': String(id), 'data-state': state })}
          columns={[
            { id: 'release', head: t('column.release'), cell: ({ id }) => id },
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

// The newest one before it that went to the same machine.
const lastBefore = (releases: readonly Release[], release: Release): Release | null =>
  releases
    .filter((one) => one.id < release.id && one.machine === release.machine && (one.approved_by !== null || one.state === 'proving'))
    .sort((a, b) => b.id - a.id)[0] ?? null;

function HandIn({ release, before, done }: { release: Release; before: Release | null; done: () => void }) {
  const [note, setNote] = useState('');
  const verdicts = useLoaded(`${release.program}`, () => deskCalls.checks(release.program));
  const verdict = verdicts.value?.find((one) => one.revision === release.revision && one.machine === release.machine && one.delivery === release.delivery) ?? null;
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
      {before && before.revision !== release.revision ? (
        <Since release={release} before={before} />
      ) : (
        <p class="quiet-text">{before ? t('release.same_text', { id: before.id }) : t('release.first_one')}</p>
      )}
      <label class="field">
        <span>{t('release.note')}</span>
        <input value={note} maxLength={500} onInput={(event) => setNote(event.currentTarget.value)} autocomplete="off" />
      </label>
    </OrderDialog>
  );
}

function Since({ release, before }: { release: Release; before: Release }) {
  const { value, error } = useLoaded(`${before.id} ${release.id}`, () =>
    deskCalls.compare(release.program, { revision: before.revision, with_revision: release.revision, machine: release.machine }),
  );
  return (
    <div class="since">
      <h3>{t('release.since', { id: before.id, revision: before.revision })}</h3>
      <Failure error={error} />
      {value ? <ComparedView of={value} /> : error === null && <p role="status">{t('compare.running')}</p>}
    </div>
  );
}
