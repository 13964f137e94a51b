// Sound and notifications, as each browser's person wants them.
import { signal } from '@preact/signals';

export interface Settings {
  sound: boolean;
  notify: boolean;
}

const kStored = 'dripfeed.alarms';

function stored(): Settings {
  const text = localStorage.getItem(kStored) ?? '';
  return { sound: text.includes('sound'), notify: text.includes('notify') };
}

export const settings = signal<Settings>({ sound: false, notify: false });
export const readSettings = (): void => {
  settings.value = stored();
};

export function setSetting(name: keyof Settings, on: boolean): void {
  settings.value = { ...settings.peek(), [name]: on };
  const kept = Object.entries(settings.peek()).filter(([, value]) => value);
  localStorage.setItem(kStored, kept.map(([key]) => key).join(' '));
}

let audio: AudioContext | null = null;

// Two short tones. A browser lets a page sound only after a person touched it; before that nothing is heard.
export function beep(): void {
  audio ??= new AudioContext();
  for (const [at, frequency] of [[0, 880], [0.25, 660]] as const) {
    const tone = audio.createOscillator();
    const loudness = audio.createGain();
    const begin = audio.currentTime + at;
    tone.frequency.value = frequency;
    loudness.gain.setValueAtTime(0.2, begin);
    loudness.gain.exponentialRampToValueAtTime(0.001, begin + 0.2);
    tone.connect(loudness).connect(audio.destination);
    tone.start(begin);
    tone.stop(begin + 0.2);
  }
}
