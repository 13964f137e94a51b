// The words of a dialect as the server lists them, found by what stands in a text. There is no second list of them here.
import type { DialectWord, DialectWords } from '../api/types';

// "G02", "g2" and "G002" are one code.
export function codeKey(text: string): string {
  const [, letter = '', digits = '', rest = ''] = /^([A-Z])0*(\d+)((?:\.\d+)?)$/i.exec(text) ?? [];
  return letter === '' ? '' : `${letter.toUpperCase()}${digits}${rest}`;
}

export class Words {
  private readonly byName = new Map<string, DialectWord>();
  private readonly byCode = new Map<string, DialectWord>();
  private readonly ranges: { first: number; last: number; word: DialectWord }[] = [];
  private readonly longest: number;

  // `isSure`: they are of the control that the text is for; otherwise they color it and explain nothing.
  constructor(
    readonly of: DialectWords,
    readonly isSure: boolean,
  ) {
    let longest = 0;
    for (const word of of.words) {
      this.byName.set(word.word, word);
      longest = Math.max(longest, word.word.length);
      if (word.sort === 'code') {
        const key = codeKey(word.word);
        if (key !== '') this.byCode.set(key, word);
      }
      if (word.sort === 'variable' && word.word.startsWith('#')) {
        const first = Number(word.word.slice(1));
        this.ranges.push({ first, last: word.last ?? first, word });
      }
    }
    this.longest = longest;
  }

  name(text: string): DialectWord | null {
    return this.byName.get(text.toUpperCase()) ?? null;
  }

  code(text: string): DialectWord | null {
    return this.byCode.get(codeKey(text)) ?? null;
  }

  variable(number: number): DialectWord | null {
    return this.ranges.find(({ first, last }) => number >= first && number <= last)?.word ?? null;
  }

  // The longest word that stands at the start of a run of letters, where words touch each other.
  headOf(letters: string): DialectWord | null {
    for (let length = Math.min(letters.length, this.longest); length > 1; --length) {
      const word = this.name(letters.slice(0, length));
      if (word && word.sort !== 'code') return word;
    }
    return null;
  }
}
