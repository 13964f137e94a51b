// How far a job is: wire bytes as a bar and as three figures, each of which says only what is known.
import type { MachineStatus } from '../api/types';
import { bytes, count, percent, share } from '../format/numbers';

const kWide = 1000;
const kHigh = 14;

export function WireProgress({ status }: { status: MachineStatus }) {
  const { handed, clocked, confirmed, total } = status;
  const at = (part: number) => Math.round(share(part, total) * kWide);
  return (
    <div class="wire">
      <svg
        class="wire-bar"
        viewBox={`0 0 ${kWide} ${kHigh}`}
        preserveAspectRatio="none"
        role="img"
        aria-label={`${percent(clocked, total)} of ${bytes(total)} clocked out`}
      >
        <rect class="wire-track" width={kWide} height={kHigh} />
        <rect class="wire-handed" width={at(handed)} height={kHigh} />
        <rect class="wire-clocked" width={at(clocked)} height={kHigh} />
        {status.confirms && <rect class="wire-confirmed" y={kHigh - 5} width={at(confirmed)} height={5} />}
      </svg>
      <dl class="figures">
        <Figure kind="handed" name="handed" value={handed} total={total} says="taken by the line's driver" />
        <Figure
          kind="clocked"
          name={status.estimated ? 'clocked, estimated' : 'clocked'}
          value={clocked}
          total={total}
          says={status.estimated ? 'line time passed; this link cannot be read back' : 'its time on the line has passed'}
        />
        {status.confirms ? (
          <Figure kind="confirmed" name="confirmed" value={confirmed} total={total} says="acknowledged by the other side" />
        ) : (
          <div class="figure">
            <dt>
              <span class="swatch swatch-none" />
              confirmed
            </dt>
            <dd class="figure-none">none on a plain serial line</dd>
          </div>
        )}
      </dl>
      <p class="wire-total">of {bytes(total)} on the wire</p>
    </div>
  );
}

interface FigureProps {
  kind: string;
  name: string;
  value: number;
  total: number;
  says: string;
}

const Figure = ({ kind, name, value, total, says }: FigureProps) => (
  <div class="figure" title={says}>
    <dt>
      <span class={`swatch swatch-${kind}`} />
      {name}
    </dt>
    <dd>
      <span class="figure-count">{count(value)}</span> <span class="figure-share">{percent(value, total)}</span>
    </dd>
  </div>
);
