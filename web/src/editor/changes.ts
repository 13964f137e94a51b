// A text as changes of another one, line by line, so that the cursor and the view stay where they are.
import type { ChangeSpec, Text } from '@codemirror/state';

export function lineChanges(doc: Text, to: string): ChangeSpec {
  const lines = to.split('\n');
  if (lines.length !== doc.lines) return { from: 0, to: doc.length, insert: to };
  const changes: ChangeSpec[] = [];
  let from = 0;
  let number = 0;
  for (const line of doc.iterLines()) {
    const wanted = lines[number++] ?? '';
    if (line !== wanted) changes.push(changeOf(from, line, wanted));
    from += line.length + 1;
  }
  return changes;
}

// What differs between the equal beginnings and ends of the two.
function changeOf(from: number, line: string, wanted: string): ChangeSpec {
  const shorter = Math.min(line.length, wanted.length);
  let head = 0;
  while (head < shorter && line[head] === wanted[head]) head += 1;
  let tail = 0;
  while (tail < shorter - head && line[line.length - 1 - tail] === wanted[wanted.length - 1 - tail]) tail += 1;
  return { from: from + head, to: from + line.length - tail, insert: wanted.slice(head, wanted.length - tail) };
}
