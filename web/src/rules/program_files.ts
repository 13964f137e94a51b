// A program as a file of a person's disk: its name, its characters, its line ends.

// Endings that say no more than that it is a program; those of SINUMERIK (.MPF, .SPF) belong to the name.
const kEndings = /\.(?:nc|txt|tap|cnc|iso|eia|ngc|min|prg|h|din|g|gcode)$/i;

export const nameOfFile = (file: string): string => file.replace(kEndings, '').trim();

// Where a file lies in the folder that a person chose, whose own name does not count.
export const pathIn = (file: File): string => file.webkitRelativePath.slice(file.webkitRelativePath.indexOf('/') + 1) || file.name;

// Of paths: those whose program keeps its ending, because another one of the folder differs by that alone.
export function withEnding(paths: readonly string[]): Set<string> {
  const placeOf = (path: string): string => {
    const slash = path.lastIndexOf('/') + 1;
    return path.slice(0, slash) + nameOfFile(path.slice(slash));
  };
  const counts = new Map<string, number>();
  for (const path of paths) counts.set(placeOf(path), (counts.get(placeOf(path)) ?? 0) + 1);
  return new Set(paths.filter((path) => (counts.get(placeOf(path)) ?? 0) > 1));
}

export interface DecodedText {
  text: string;
  encoding: 'utf-8' | 'latin-1';
}

// Bytes that are no UTF-8 are Latin-1, as controls and old computers write.
export function decodeProgram(bytes: ArrayBuffer): DecodedText {
  try {
    return { text: new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes), encoding: 'utf-8' };
  } catch {
    let text = '';
    const all = new Uint8Array(bytes);
    const kPiece = 8192;
    for (let i = 0; i < all.length; i += kPiece) text += String.fromCharCode(...all.subarray(i, i + kPiece));
    return { text, encoding: 'latin-1' };
  }
}

// As controls count: LF, CR LF, CR, and LF CR CR end one block each.
const kLineEnd = /\n\r\r|\r\n|\n|\r/g;

// The line end that a text has all over; null where it has several.
export function lineEndOf(text: string): string | null {
  let found: string | null = null;
  for (const [end] of text.matchAll(kLineEnd)) {
    if (found !== null && found !== end) return null;
    found = end;
  }
  return found ?? '\n';
}

export const linesOf = (text: string): string[] => text.split(kLineEnd);

// Lines and columns as the server counts them (from 1, columns in characters) as an offset in the line's UTF-16.
export function columnOffset(line: string, columnChars: number): number {
  let offset = 0;
  for (const character of line) {
    if (--columnChars < 1) break;
    offset += character.length;
  }
  return offset;
}

// "pump, acme ,,", as a person writes tags.
export const tagsOf = (text: string): string[] => [...new Set(text.split(',').map((tag) => tag.trim()).filter(Boolean))].sort();
