// An address that leads nowhere says so, and leads on.
import { t } from '../i18n/i18n';
import { Empty } from '../parts/empty';
import { hrefs, route } from '../router';

export const NotFound = ({ what }: { what?: string }) => (
  <>
    <h1 tabIndex={-1}>{t('not_found.title')}</h1>
    <Empty
      action={
        <a class="button button-main" href={hrefs.floor}>
          {t('not_found.floor')}
        </a>
      }
    >
      {what ?? t('not_found.text', { address: route.value.address })}
    </Empty>
  </>
);
