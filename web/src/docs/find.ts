// Finds words in the documentation's index. A word finds what begins with it; all words must be found in one entry: in its heading, its
// text or the name of its page. Small words of a question are left out.

export interface DocsIndex {
  pages: [address: string, label: string][];
  entries: [page: number, id: string, heading: string, text: string][];
}

export interface Piece {
  text: string;
  isHit: boolean;
}

export interface Hit {
  href: string;
  page: string;
  heading: string;
  text: Piece[];
}

export interface Found {
  count: number; // of all hits; `hits` has the best of them
  hits: Hit[];
}

const kMost = 30;
const kBefore = 50; // characters of the text before the first word that is found
const kShown = 190;

// Words of a question that say nothing of where its answer stands.
const kSmallWords = new Set(['a', 'an', 'and', 'are', 'can', 'do', 'does', 'for', 'how', 'i', 'in', 'is', 'it', 'my', 'of', 'or', 'the', 'to', 'what', 'where', 'why', 'with']);

function wordsOf(query: string): string[] {
  const all = query.toLowerCase().split(/[\s?]+/).filter(Boolean);
  const others = all.filter((word) => !kSmallWords.has(word));
  return others.length > 0 ? others : all;
}

const isWordCharacter = (c: string | undefined): boolean => c !== undefined && /[\p{L}\p{N}]/u.test(c);

// Where the next word of `text` begins that begins with `word`, both in small letters; -1: none.
function placeOf(text: string, word: string, from = 0): number {
  for (let at = text.indexOf(word, from); at >= 0; at = text.indexOf(word, at + 1)) {
    if (!isWordCharacter(text[at - 1]) || !isWordCharacter(word[0])) return at;
  }
  return -1;
}

// 0: not found, 1: words that begin with it, 2: the word itself.
function degreeOf(text: string, word: string): 0 | 1 | 2 {
  let found: 0 | 1 = 0;
  for (let at = placeOf(text, word); at >= 0; at = placeOf(text, word, at + 1)) {
    if (!isWordCharacter(text[at + word.length])) return 2;
    found = 1;
  }
  return found;
}

// G01 is G1.
const withoutZeros = (word: string): string => word.replace(/^([a-z])0+(?=\d)/, '$1');

const kHeadingIsIt = 100;
const kOfHeading = [0, 25, 40] as const;
const kOfPage = [0, 4, 8] as const;
const kOfText = [0, 3, 6] as const;

function weightOf(word: string, page: string, heading: string, text: string): number {
  if (withoutZeros(heading) === withoutZeros(word)) return kHeadingIsIt;
  return kOfHeading[degreeOf(heading, word)] + kOfPage[degreeOf(page, word)] + kOfText[degreeOf(text, word)];
}

// The part of a text in which the first of the words stands, all of them marked.
function shownOf(text: string, words: string[]): Piece[] {
  const small = text.toLowerCase();
  const places = words.map((word) => placeOf(small, word)).filter((at) => at >= 0);
  const first = places.length > 0 ? Math.min(...places) : 0;
  const start = first <= kBefore ? 0 : text.lastIndexOf(' ', first - kBefore) + 1;
  const blank = text.indexOf(' ', start + kShown);
  const end = blank < 0 ? text.length : blank;
  const pieces: Piece[] = start > 0 ? [{ text: '… ', isHit: false }] : [];
  let at = start;
  while (at < end) {
    const next = words.map((word) => ({ word, place: placeOf(small, word, at) })).filter(({ place }) => place >= 0 && place < end);
    const hit = next.sort((a, b) => a.place - b.place || b.word.length - a.word.length)[0];
    if (!hit) break;
    pieces.push({ text: text.slice(at, hit.place), isHit: false }, { text: text.slice(hit.place, hit.place + hit.word.length), isHit: true });
    at = hit.place + hit.word.length;
  }
  pieces.push({ text: text.slice(at, end) + (end < text.length ? ' …' : ''), isHit: false });
  return pieces.filter((piece) => piece.text !== '');
}

// Searches with small letters; made once for an index.
export function searchOf(index: DocsIndex): (query: string) => Found {
  const pages = index.pages.map(([, label]) => label.toLowerCase());
  const small = index.entries.map(([page, , heading, text]) => ({ page: pages[page] ?? '', heading: heading.toLowerCase(), text: text.toLowerCase() }));
  return (query) => {
    const words = wordsOf(query);
    if (words.length === 0) return { count: 0, hits: [] };
    const weighed = small.flatMap(({ page, heading, text }, entry) => {
      const weights = words.map((word) => weightOf(word, page, heading, text));
      return weights.includes(0) ? [] : [{ entry, weight: weights.reduce((sum, one) => sum + one, 0) }];
    });
    weighed.sort((a, b) => b.weight - a.weight || a.entry - b.entry);
    const hits = weighed.slice(0, kMost).map(({ entry }) => {
      const [page, id, heading, text] = index.entries[entry]!;
      const [address, label] = index.pages[page]!;
      return { href: `${address}#${encodeURIComponent(id)}`, page: label, heading, text: shownOf(text, words) };
    });
    return { count: weighed.length, hits };
  };
}
