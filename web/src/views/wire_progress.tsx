// How far a job is: wire bytes as a bar and as three figures, each of which says only what is known. In the bar the
// three differ by shape: clocked is full, handed a thin line ahead of it, confirmed a strip of its own below.
import type { MachineStatus } from '../api/types';
import { bytes, count, percent, share } from '../format/numbers';

const kWide = 1000;
const kHigh = 12;
const kThin = 4;
const kGap = 2;

export function WireProgress({ status }: { status: MachineStatus }) {
  const { handed, clocked, confirmed, total } = status;
  const at = (part: number) => Math.round(share(part, total) * kWide);
  const high = status.confirms ? kHigh + kGap + kThin : kHigh;
  return (
    <div class="wire">
      <svg
        class={status.confirms ? 'wire-bar wire-bar-double' : 'wire-bar'}
        viewBox={`0 0 ${kWide} ${high}`}
        preserveAspectRatio="none"
        role="img"
        aria-label={`${percent(clocked, total)} of ${bytes(total)} clocked out`}
      >
        <rect class="wire-track" width={kWide} height={kHigh} />
        <rect class="wire-handed" y={(kHigh - kThin) / 2} width={at(handed)} height={kThin} />
        <rect class="wire-clocked" width={at(clocked)} height={kHigh} />
        {status.confirms && (
          <>
            <rect class="wire-track" y={kHigh + kGap} width={kWide} height={kThin} />
            <rect class="wire-confirmed" y={kHigh + kGap} width={at(confirmed)} height={kThin} />
          </>
        )}
      </svg>
      <dl class="figures">
        <Figure kind="handed" value={handed} total={total} says="to the driver" />
        <Figure
          kind="clocked"
          value={clocked}
          total={total}
          says={status.estimated ? 'estimated' : 'line time passed'}
        />
        {status.confirms ? (
          <Figure kind="confirmed" value={confirmed} total={total} says="acknowledged" />
        ) : (
          <div class="figure">
            <dt>
              <span class="swatch swatch-none" />
              confirmed
            </dt>
            <dd class="figure-says">none on a plain serial line</dd>
          </div>
        )}
        <div class="figure figure-total">
          <dt>of</dt>
          <dd>
            <span class="figure-count">{count(total)}</span>
            <span />
            <span class="figure-says">wire bytes</span>
          </dd>
        </div>
      </dl>
    </div>
  );
}

interface FigureProps {
  kind: 'handed' | 'clocked' | 'confirmed';
  value: number;
  total: number;
  says: string;
}

const Figure = ({ kind, value, total, says }: FigureProps) => (
  <div class="figure">
    <dt>
      <span class={`swatch swatch-${kind}`} />
      {kind}
    </dt>
    <dd>
      <span class="figure-count">{count(value)}</span>
      <span class="figure-share">{percent(value, total)}</span>
      <span class="figure-says">{says}</span>
    </dd>
  </div>
);
