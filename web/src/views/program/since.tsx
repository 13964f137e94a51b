// What has changed since the last release of the same program that went to the same machine: text, meaning, motions.
import { deskCalls } from '../../api/desk_calls';
import type { Release } from '../../api/types';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { ComparedView } from './compare';

export function Since({ release, before }: { release: Release; before: Release | null }) {
  const isOther = before !== null && before.revision !== release.revision;
  const { value, error } = useLoaded(isOther ? `${before.id} ${release.id}` : null, () =>
    deskCalls.compare(release.program, { revision: before?.revision ?? 0, with_revision: release.revision, machine: release.machine }),
  );
  if (!before) return <p class="quiet-text">{t('release.first_one')}</p>;
  if (!isOther) return <p class="quiet-text">{t('release.same_text', { id: before.id })}</p>;
  return (
    <div class="since">
      <h3>{t('release.since', { id: before.id, revision: before.revision })}</h3>
      <Failure error={error} />
      {value ? <ComparedView of={value} /> : error === null && <p role="status">{t('compare.running')}</p>}
    </div>
  );
}
