// A state as icon and word in the colour of its tone: the colour alone never says anything.
import type { Tone, Wording } from '../format/words';

const kShapes: Record<Tone, string> = {
  quiet: 'M8 4.5a3.5 3.5 0 1 0 0 7 3.5 3.5 0 0 0 0-7z',
  ready: 'M8 2a6 6 0 1 0 0 12A6 6 0 0 0 8 2zm.8 2.600v3.100l2.300 1.400-.7 1.200L7.300 8.500V4.600z',
  active: 'M4.500 2.500 13 8l-8.500 5.500z',
  waiting: 'M4 3h3v10H4zm5 0h3v10H9z',
  good: 'm2.700 8.300 1.500-1.500 2.500 2.500 5.200-5.700 1.500 1.400-6.600 7.200z',
  bad: 'M8 1.500 15 14H1zM7.200 6v4h1.600V6zm0 5v1.600h1.600V11z',
};

export const Icon = ({ tone }: { tone: Tone }) => (
  <svg class="icon" viewBox="0 0 16 16" width="14" height="14" aria-hidden="true">
    <path d={kShapes[tone]} fill-rule="evenodd" />
  </svg>
);

// `old`: the connection is lost, this was the last that was heard.
export const Badge = ({ wording, old = false }: { wording: Wording; old?: boolean }) => (
  <span class={`badge tone-${wording.tone}`}>
    <Icon tone={wording.tone} />
    {old ? `last known: ${wording.text}` : wording.text}
  </span>
);
