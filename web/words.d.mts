// What words.mjs gives to its tests.
export function partsOf(entry: string, words: Record<string, string>): Promise<{ first: Record<string, string>; rest: Record<string, string> }>;
