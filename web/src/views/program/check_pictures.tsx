// Pictures of a check, drawn by the server when a person asks for them.
import { useState } from 'preact/hooks';
import { deskCalls, type CheckPicture } from '../../api/desk_calls';
import type { Verdict } from '../../api/types';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';

// Those that the checks of this verdict have figures for.
function picturesOf({ timing, gouge, accuracy, delivery }: Verdict): CheckPicture[] {
  const all: (CheckPicture | false)[] = [
    timing !== null && { route: 'timing', plot: 'feed' },
    timing !== null && delivery === 'drip' && { route: 'timing', plot: 'buffer' },
    gouge !== null && { route: 'gouge', plot: 'stock' },
    accuracy !== null && { route: 'accuracy', plot: 'deviation' },
  ];
  return all.filter((one) => one !== false);
}

export function CheckPictures({ verdict }: { verdict: Verdict }) {
  const [shown, setShown] = useState<CheckPicture['plot'] | null>(null);
  const pictures = picturesOf(verdict);
  const picture = pictures.find(({ plot }) => plot === shown) ?? null;
  const { program, revision, machine, delivery } = verdict;
  const { value, error, loading } = useLoaded(picture ? `${verdict.id} ${picture.plot}` : null, () =>
    deskCalls.checkPicture(picture ?? { route: 'timing', plot: 'feed' }, { program, revision, machine, delivery }),
  );
  if (pictures.length === 0) return null;
  return (
    <div class="check-pictures">
      <div class="segments" role="group" aria-label={t('picture.label')}>
        {pictures.map(({ plot }) => (
          <button key={plot} type="button" aria-pressed={plot === shown} onClick={() => setShown(plot === shown ? null : plot)}>
            {t(`picture.${plot}`)}
          </button>
        ))}
      </div>
      <Failure error={picture ? error : null} />
      {picture && loading && <p role="status">{t('picture.running')}</p>}
      {picture && value && <img class="check-picture" src={`data:image/svg+xml,${encodeURIComponent(value)}`} alt={t(`picture.${picture.plot}`)} />}
    </div>
  );
}
