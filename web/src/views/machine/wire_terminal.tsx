// The wire terminal: what passes on a machine's line, in both directions, while this is open. It has a stream of its
// own, which ends with it: the server keeps nothing of a line at which no person looks.
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { wireUrl } from '../../api/calls';
import type { WireReport } from '../../api/types';
import { clockTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { LiveConnection } from '../../live/connection';
import { addReport, pieces, type WireRow } from '../../rules/wire';

type Phase = 'connecting' | 'open' | 'lost';

export function WireTerminal({ name }: { name: string }) {
  const [rows, setRows] = useState<readonly WireRow[]>([]);
  const [phase, setPhase] = useState<Phase>('connecting');
  const [isStill, setStill] = useState(false);
  const [showsHex, setHex] = useState(false);
  const still = useRef(false);
  still.current = isStill;
  useEffect(() => watchWire(name, setPhase, (report) => !still.current && setRows((before) => addReport(before, report))), [name]);
  const list = useRef<HTMLOListElement>(null);
  useLayoutEffect(() => {
    if (list.current && !isStill) list.current.scrollTop = list.current.scrollHeight;
  }, [rows, isStill]);
  return (
    <section class="terminal" aria-label={t('terminal.title')} data-phase={`wire-${phase}`}>
      <div class="terminal-head">
        <h3>{t('terminal.title')}</h3>
        <span role="status">{t(isStill ? 'terminal.still' : `terminal_phase.${phase}`)}</span>
        <label class="choice">
          <input type="checkbox" checked={isStill} onChange={(event) => setStill(event.currentTarget.checked)} />
          {t('terminal.hold')}
        </label>
        <label class="choice">
          <input type="checkbox" checked={showsHex} onChange={(event) => setHex(event.currentTarget.checked)} />
          {t('terminal.hex')}
        </label>
        <button type="button" class="button button-small" onClick={() => setRows([])}>
          {t('terminal.clear')}
        </button>
      </div>
      <ol ref={list} class="terminal-rows" tabIndex={0} aria-label={t('terminal.rows')}>
        {rows.map((row) => (
          <Row key={row.id} row={row} showsHex={showsHex} />
        ))}
      </ol>
      {rows.length === 0 && <p class="quiet-text">{t('terminal.nothing')}</p>}
      <p class="hint">{t('terminal.hint')}</p>
    </section>
  );
}

// Gives what ends it. A page that is not looked at does not listen.
function watchWire(name: string, setPhase: (phase: Phase) => void, take: (report: WireReport) => void): () => void {
  const connection = new LiveConnection(wireUrl(name), {
    opened: () => setPhase('open'),
    event: (event) => event.name === 'wire' && take(JSON.parse(event.data) as WireReport),
    lost: () => setPhase('lost'),
    refused: () => setPhase('lost'),
  });
  let runs = false;
  const look = () => {
    if (document.hidden === !runs) return;
    runs = !document.hidden;
    if (runs) connection.start();
    else connection.stop();
    setPhase('connecting');
  };
  look();
  document.addEventListener('visibilitychange', look);
  return () => {
    document.removeEventListener('visibilitychange', look);
    if (runs) connection.stop();
  };
}

const millis = (ms: number): string => `${clockTime(ms)}.${String(ms % 1000).padStart(3, '0')}`;

function Row({ row, showsHex }: { row: WireRow; showsHex: boolean }) {
  const isText = row.kind === 'in' || row.kind === 'out';
  return (
    <li class={`terminal-row terminal-${row.kind}`}>
      <time>{millis(row.at_ms)}</time>
      <span class="terminal-kind">{row.kind === 'gap' ? t('terminal.gap', { count: row.wrong }) : t(`terminal_kind.${row.kind}`)}</span>
      {isText && (
        <code>
          {showsHex ? row.hex.replace(/..(?=.)/g, '$& ') : <Characters text={row.text} />}
          {row.wrong > 0 && <span class="terminal-wrong"> {t('terminal.wrong', { count: row.wrong })}</span>}
        </code>
      )}
    </li>
  );
}

const Characters = ({ text }: { text: string }) => (
  <>
    {pieces(text).map(({ text: plain, control }, i) =>
      control === null ? plain : (
        <abbr key={i} class={`control control-${control.toLowerCase()}`} title={t('terminal.control', { name: control })}>
          {control}
        </abbr>
      ),
    )}
  </>
);
