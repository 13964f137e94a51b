// What docs.mjs gives to its tests.
export function slugOf(heading: string): string;
export function hrefOf(href: string): string | null;
export function htmlOf(markdown: string, drawings?: Map<string, string>): string;
export function titleOf(markdown: string): string;
