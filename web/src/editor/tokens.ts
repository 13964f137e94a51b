// A line of a program as pieces that have a color. It knows what a number, a text and a comment look like and asks the
// dialect's own words for the rest; what a block means is the server's reader's to say.
import type { DialectWord } from '../api/types';
import type { Words } from './words';

export type TokenSort = 'comment' | 'string' | 'number' | 'code' | 'keyword' | 'function' | 'cycle' | 'variable' | 'block' | 'address' | 'name' | 'sign';

export interface Token {
  from: number;
  to: number;
  sort: TokenSort;
  word: DialectWord | null; // what the dialect says of it
}

const kNumber = /^(?:\d+\.?\d*|\.\d+)/;
const kCode = /^[GM]\d+(?:\.\d+)?/i;
const kBlockNumber = /^N\d+/i;
const kHash = /^#\d*/;
const kNumbered = /^R\d+/i; // a variable where the dialect's words are names
const kName = /^[A-Za-z_$][A-Za-z_$]+[\w$]*/;

// The piece that begins at the start of `rest`.
function pieceOf(rest: string, words: Words): Omit<Token, 'from' | 'to'> & { length: number } {
  const { comment, touching } = words.of;
  if (rest.startsWith(comment.open)) {
    const end = comment.close === null ? -1 : rest.indexOf(comment.close);
    return { length: end < 0 ? rest.length : end + 1, sort: 'comment', word: null };
  }
  const at = (pattern: RegExp): string => pattern.exec(rest)?.[0] ?? '';
  const quoted = at(/^"[^"]*"?/);
  if (quoted) return { length: quoted.length, sort: 'string', word: null };
  const number = at(kNumber);
  if (number) return { length: number.length, sort: 'number', word: null };
  const hash = at(kHash);
  if (hash) return { length: hash.length, sort: 'variable', word: hash === '#' ? null : words.variable(Number(hash.slice(1))) };
  const code = at(kCode);
  if (code) return { length: code.length, sort: 'code', word: words.code(code) };
  const block = at(kBlockNumber);
  if (block) return { length: block.length, sort: 'block', word: null };
  return touching ? touchingPiece(rest, words) : namedPiece(rest, words);
}

function touchingPiece(rest: string, words: Words) {
  const letters = /^[A-Z_]+/i.exec(rest)?.[0] ?? '';
  if (letters === '') return { length: 1, sort: 'sign' as const, word: null };
  const word = words.headOf(letters);
  if (word) return { length: word.word.length, sort: word.sort as TokenSort, word };
  return { length: 1, sort: 'address' as const, word: null };
}

function namedPiece(rest: string, words: Words) {
  const numbered = kNumbered.exec(rest)?.[0];
  if (numbered) return { length: numbered.length, sort: 'variable' as const, word: null };
  const name = kName.exec(rest)?.[0];
  if (name === undefined) return { length: 1, sort: /^[A-Z]/i.test(rest) ? ('address' as const) : ('sign' as const), word: null };
  const word = words.name(name);
  if (name.startsWith('$')) return { length: name.length, sort: 'variable' as const, word };
  return { length: name.length, sort: word ? (word.sort as TokenSort) : ('name' as const), word };
}

export function tokensOf(line: string, words: Words): Token[] {
  const tokens: Token[] = [];
  for (let at = 0; at < line.length; ) {
    const blank = /^\s+/.exec(line.slice(at));
    if (blank) {
      at += blank[0].length;
      continue;
    }
    const { length, sort, word } = pieceOf(line.slice(at), words);
    tokens.push({ from: at, to: at + length, sort, word });
    at += length;
  }
  return tokens;
}
