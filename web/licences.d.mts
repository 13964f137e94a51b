// What licences.mjs gives to its tests.
export function packageOf(input: string): string | null;
export function packagesOf(inputs: readonly string[]): string[];
export function sectionOf(licence: { name: string; version: string; license: string; text: string }): string;
