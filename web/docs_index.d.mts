// What docs_index.mjs gives to its tests.
import type { DocsIndex } from './src/docs/find';

export function entriesOf(html: string): { id: string; heading: string; text: string }[];
export function indexOf(pages: { name: string; label: string; html: string }[]): DocsIndex;
