// The running block among its neighbours: the plain blocks that are sent, and beside them the line of the family that
// each was rendered from, with the values of its variables (paper 001's "basic blocks"). Marked are the lines between
// which the last character that may have reached the control lies.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import type { Job, ProgramLine } from '../../api/types';
import { placeText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { loader } from '../../state/loader';

const kBefore = 5;
const kAfter = 8;
const kPiece = 60; // lines that are asked for at once

interface Piece {
  from: number;
  all: number;
  lines: ProgramLine[];
}

const covers = (piece: Piece | null, first: number, last: number): boolean =>
  piece !== null && piece.from <= first && Math.min(last, piece.all) < piece.from + piece.lines.length;

export function Blocks({ job, from, to }: { job: Job; from: number; to: number }) {
  const [piece, setPiece] = useState<Piece | null>(null);
  const [error, setError] = useState<unknown>(null);
  const middle = Math.max(to, 1);
  const first = Math.max(1, Math.min(middle - kBefore, from > 0 ? from : middle));
  const last = middle + kAfter;
  const isThere = covers(piece, Math.max(first, middle - kBefore), last);
  useEffect(() => {
    if (isThere) return;
    const begin = Math.max(1, middle - kBefore);
    loader
      .order(calls.programLines(job.program, job.revision, begin, kPiece))
      .then((found) => setPiece({ from: begin, all: found.count_all, lines: found.lines }), setError);
  }, [job.id, job.revision, isThere]);
  const shown = piece?.lines.filter(({ line }) => line >= middle - kBefore && line <= last) ?? [];
  const hasFamily = shown.some((line) => line.family_text !== null);
  return (
    <div class="blocks">
      <p>
        {t('machine.sent_to')} <strong>{placeText(from, to)}</strong>
      </p>
      <Failure error={error} />
      <ol class={hasFamily ? 'block-list block-list-two' : 'block-list'} aria-label={t('machine.blocks')}>
        {shown.map((line) => (
          <li key={line.line} class={mark(line.line, from, to)} aria-current={line.line === to ? 'true' : undefined}>
            <span class="block-line">{line.line}</span>
            <code>{line.text}</code>
            {hasFamily && <FamilyPart line={line} />}
          </li>
        ))}
      </ol>
    </div>
  );
}

function mark(line: number, from: number, to: number): string {
  if (to > 0 && line === to) return 'block-now';
  return from > 0 && line >= from && line < to ? 'block-between' : '';
}

const FamilyPart = ({ line }: { line: ProgramLine }) => (
  <span class="block-family">
    {line.family_text !== null && <code>{line.family_text}</code>}
    {line.values && (
      <span class="quiet-text">
        {Object.entries(line.values)
          .map(([name, value]) => `${name} = ${value}`)
          .join(', ')}
      </span>
    )}
  </span>
);
