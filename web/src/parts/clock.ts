// The present time as signals, so that what counts down draws itself and nothing else.
import { signal, type ReadonlySignal } from '@preact/signals';

function ticking(everyMs: number): ReadonlySignal<number> {
  const now = signal(Date.now());
  setInterval(() => {
    if (!document.hidden) now.value = Date.now();
  }, everyMs);
  document.addEventListener('visibilitychange', () => {
    now.value = Date.now();
  });
  return now;
}

export const seconds = ticking(1_000);
export const minutes = ticking(30_000);
