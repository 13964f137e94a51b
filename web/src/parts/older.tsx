// What is shown is of an earlier text; of a long one a person asks for the newer.
import { t } from '../i18n/i18n';

export const Older = ({ what, askNow }: { what: string; askNow: (() => void) | null }) => (
  <p class="hint" role="status">
    {what}{' '}
    {askNow && (
      <>
        {t('older.long')}{' '}
        <button type="button" class="button button-small" onClick={askNow}>
          {t('older.again')}
        </button>
      </>
    )}
  </p>
);
