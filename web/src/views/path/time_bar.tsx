// Time along the program: a slider, and a button that lets it run. It runs the picture, nothing else.
import { useEffect, useRef, useState } from 'preact/hooks';
import { duration } from '../../format/times';
import { t } from '../../i18n/i18n';
import type { Clock, PathPlace } from '../../path/clock';

interface Props {
  clock: Clock;
  place: PathPlace;
  text: string; // of the place
  goTo: (place: PathPlace) => void;
  running: boolean;
  run: (is: boolean) => void;
}

const kPaces = [1, 10, 100, 1000];
const kWholeWithin_s = 40;
const kSteps = 1000;

// The slowest that has shown all of it soon.
export const paceFor = (end_s: number): number => kPaces.find((pace) => end_s / pace <= kWholeWithin_s) ?? kPaces.at(-1) ?? 1;

export function TimeBar({ clock, place, text, goTo, running, run }: Props) {
  const [pace, setPace] = useState(() => paceFor(clock.end_s));
  const latest = useRef({ clock, pace, goTo, running });
  latest.current = { clock, pace, goTo, running };
  const time_s = clock.timeAt(place);
  const now = useRef(time_s);
  if (!running) now.current = time_s;
  useEffect(() => () => run(false), [clock]);
  useEffect(() => {
    if (!running) return;
    let before = performance.now();
    let frame = 0;
    const step = () => {
      if (!latest.current.running) return; // paused, and this effect is not taken down yet
      const at = performance.now();
      const { clock: of, pace: by, goTo: go } = latest.current;
      now.current = Math.min(now.current + ((at - before) / 1000) * by, of.end_s);
      before = at;
      go(of.placeAt(now.current));
      if (now.current >= of.end_s) run(false);
      else frame = requestAnimationFrame(step);
    };
    frame = requestAnimationFrame(step);
    return () => cancelAnimationFrame(frame);
  }, [running]);
  const start = () => {
    if (!running && time_s >= clock.end_s) now.current = 0;
    run(!running);
  };
  const shown = t('path_time.of', { now: duration(time_s), end: duration(clock.end_s) });
  return (
    <div class="path-time">
      <button type="button" class="button button-small" aria-pressed={running} onClick={start}>
        {t(running ? 'path_time.pause' : 'path_time.play')}
      </button>
      <label class="path-slider">
        <span>{t('path_time.time')}</span>
        <input
          type="range"
          min={0}
          max={clock.end_s}
          step={clock.end_s / kSteps || 1}
          value={time_s}
          aria-valuetext={`${shown}. ${text}`}
          onInput={(event) => {
            now.current = Number(event.currentTarget.value);
            goTo(clock.placeAt(now.current));
          }}
        />
      </label>
      <span class="path-clock">{shown}</span>
      <label class="choice">
        <span>{t('path_time.pace')}</span>
        <select value={pace} onChange={(event) => setPace(Number(event.currentTarget.value))}>
          {kPaces.map((one) => (
            <option key={one} value={one}>
              {one}×
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}
