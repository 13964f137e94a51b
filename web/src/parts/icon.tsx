// Small drawings that stand beside words, never instead of them.
import type { Tone } from '../format/tones';

const kShapes = {
  quiet: 'M8 4.5a3.5 3.5 0 1 0 0 7 3.5 3.5 0 0 0 0-7z',
  ready: 'M8 2a6 6 0 1 0 0 12A6 6 0 0 0 8 2zm.8 2.600v3.100l2.300 1.400-.7 1.200L7.300 8.500V4.600z',
  active: 'M4.500 2.500 13 8l-8.500 5.500z',
  waiting: 'M4 3h3v10H4zm5 0h3v10H9z',
  good: 'm2.700 8.300 1.500-1.500 2.500 2.500 5.200-5.700 1.500 1.400-6.600 7.200z',
  bad: 'M8 1.500 15 14H1zM7.200 6v4h1.600V6zm0 5v1.600h1.600V11z',
  stop: 'M3 3h10v10H3z',
  bell: 'M8 1.500a4 4 0 0 0-4 4V9l-1.500 2.500h11L12 9V5.500a4 4 0 0 0-4-4zM6.500 12.500a1.500 1.500 0 0 0 3 0z',
  up: 'M8 3.500 13 9l-1.200 1.100L8.800 7V13H7.200V7l-3 3.100L3 9z',
  down: 'M8 12.500 3 7l1.200-1.100L7.200 9V3h1.600v6l3-3.100L13 7z',
} satisfies Record<Tone, string> & Record<string, string>;

export type Shape = keyof typeof kShapes;

export const Icon = ({ shape }: { shape: Shape }) => (
  <svg class="icon" viewBox="0 0 16 16" width="14" height="14" aria-hidden="true">
    <path d={kShapes[shape]} fill-rule="evenodd" />
  </svg>
);
