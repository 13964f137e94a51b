// The guided tour: five places of the page with a few words each, on what the shop has now. It stands in the page above
// its views and covers nothing: Stop stays where it is.
import { useEffect } from 'preact/hooks';
import { deskCalls } from '../api/desk_calls';
import { t } from '../i18n/i18n';
import { useLoaded } from '../parts/use_loaded';
import { go, hrefs, route } from '../router';
import { machines } from '../state/shop';
import { setTour, tourStep } from '../state/tour';

interface Step {
  id: 'floor' | 'machine' | 'program' | 'family' | 'review';
  href: string | null; // null: the shop has nothing to show there yet
  mark: string; // what it is about, as a selector
}

// Machines that feed show most.
function machineToShow(): string | null {
  const all = [...machines.value.values()];
  return (all.find((one) => one.core.value.line === 'feeding') ?? all[0])?.name ?? null;
}

function useSteps(): Step[] {
  const programs = useLoaded('tour programs', () => deskCalls.programs({}, null));
  const families = useLoaded('tour families', deskCalls.families);
  const machine = machineToShow();
  const program = programs.value?.items[0]?.id;
  const family = families.value?.[0]?.name;
  return [
    { id: 'floor', href: hrefs.floor, mark: '.card.machine' },
    { id: 'machine', href: machine === null ? null : hrefs.machine(machine), mark: '.machine-top' },
    { id: 'program', href: program === undefined ? null : hrefs.program(program), mark: '.writing-bar' },
    { id: 'family', href: family === undefined ? null : hrefs.family(family), mark: '.values' },
    { id: 'review', href: hrefs.releases, mark: '.table' },
  ];
}

export function Tour() {
  const steps = useSteps();
  const at = Math.min(tourStep.value ?? 0, steps.length - 1);
  const step = steps[at];
  const { address } = route.value;
  useEffect(() => markOf(step?.mark ?? ''), [step?.mark, address]);
  if (!step) return null;
  const isThere = step.href !== null && address === step.href.replace(/^#/, '');
  const move = (to: number) => {
    const next = steps[to];
    setTour(next ? to : null);
    if (next?.href) go(next.href);
  };
  return (
    <section class="tour card" aria-label={t('tour.title')} aria-live="polite">
      <h2>
        {t(`tour_title.${step.id}`)} <span class="quiet-text">{t('tour.step', { step: at + 1, of: steps.length })}</span>
      </h2>
      <p>{t(`tour_text.${step.id}`)}</p>
      {step.href === null && <p class="hint">{t('tour.nothing')}</p>}
      <div class="tour-orders">
        {!isThere && step.href !== null && (
          <a class="button" href={step.href}>
            {t('tour.go')}
          </a>
        )}
        {at > 0 && (
          <button type="button" class="button" onClick={() => move(at - 1)}>
            {t('tour.back')}
          </button>
        )}
        <button type="button" class="button button-main" onClick={() => move(at + 1)}>
          {t(at + 1 < steps.length ? 'tour.next' : 'tour.end')}
        </button>
        <button type="button" class="button" onClick={() => setTour(null)}>
          {t('tour.leave')}
        </button>
      </div>
    </section>
  );
}

const kTries = 40;
const kPause_ms = 250;

// The view comes when its answers are there. Undone when the step is another one.
function markOf(selector: string): () => void {
  let left = kTries;
  let marked: Element | null = null;
  const timer = setInterval(() => {
    left -= 1;
    marked = selector === '' ? null : document.querySelector(selector);
    marked?.classList.add('tour-mark');
    if (marked || left === 0) clearInterval(timer);
  }, kPause_ms);
  return () => {
    clearInterval(timer);
    marked?.classList.remove('tour-mark');
  };
}
