// Putting a program aside, and using it again: both with a reason, which stands in the record.
import { deskCalls } from '../../api/desk_calls';
import type { Program } from '../../api/types';
import { t } from '../../i18n/i18n';
import { OrderDialog, showDialog } from '../../parts/dialog';

export function askArchive(program: Program, changed: (program: Program) => void): void {
  const { id, name } = program;
  showDialog(
    <OrderDialog
      title={t('library.archive_title', { name })}
      confirm={t('library.archive')}
      danger
      reason={t('library.archive_reason')}
      send={async (key, reason) => changed(await deskCalls.archive(id, reason, key))}
    >
      <p>{t('library.archive_text')}</p>
    </OrderDialog>,
  );
}

export function askFetchBack(program: Program, changed: (program: Program) => void): void {
  const { id, name } = program;
  showDialog(
    <OrderDialog
      title={t('library.fetch_back_title', { name })}
      confirm={t('library.fetch_back')}
      reason={t('library.fetch_back_reason')}
      send={async (key, reason) => changed(await deskCalls.fetchBack(id, reason, key))}
    >
      {null}
    </OrderDialog>,
  );
}

export const ArchiveButton = ({ program, changed }: { program: Program; changed: (program: Program) => void }) =>
  program.archived ? (
    <button
      type="button"
      class="button button-small"
      onClick={() => askFetchBack(program, changed)}
      aria-label={t('library.fetch_back_of', { name: program.name })}
    >
      {t('library.fetch_back')}
    </button>
  ) : (
    <button type="button" class="button button-small" onClick={() => askArchive(program, changed)} aria-label={t('library.archive_of', { name: program.name })}>
      {t('library.archive')}
    </button>
  );
