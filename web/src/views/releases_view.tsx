// A new job: what is released for a machine, each with a button that queues it. Queueing sends nothing.
import { useEffect, useState } from 'preact/hooks';
import { calls } from '../api/calls';
import type { Release } from '../api/types';
import { shortHash } from '../format/numbers';
import { dateTime } from '../format/times';
import { deliveryText, releaseText } from '../format/words';
import { hrefOf } from '../route';
import { isReleased, mayBeQueued } from '../rules/releases';
import { atLeast } from '../rules/roles';
import { isLive, programName } from '../state/select';
import { useDesk } from './context';
import { Failure } from './dialog';

export function ReleasesView() {
  const { state, sync, session } = useDesk();
  const [error, setError] = useState<unknown>(null);
  const [queued, setQueued] = useState<{ release: number; job: number } | null>(null);
  const [busy, setBusy] = useState(false);
  const live = isLive(state);
  useEffect(() => {
    if (live) void sync.order(sync.loadReleases()).catch(setError);
  }, [live]);

  const queue = async (release: Release) => {
    setBusy(true);
    setError(null);
    setQueued(null);
    try {
      const job = await sync.order(calls.addJob(release.id));
      setQueued({ release: release.id, job: job.id });
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  const usable = state.releases.filter(isReleased);
  const may = atLeast(session.role, 'operator');
  return (
    <>
      <h1 tabIndex={-1}>New job</h1>
      <p class="lead">Programs that are released for a machine. To queue one sends nothing: a person arms it at its machine.</p>
      <Failure error={error} />
      {queued && (
        <p class="notice tone-good" role="status">
          Queued as <a href={hrefOf({ view: 'job', id: queued.job })}>job {queued.job}</a>.{' '}
          <a href={hrefOf({ view: 'machines' })}>Go to the machines</a> to arm it.
        </p>
      )}
      {usable.length === 0 && <p class="empty">Nothing is proving or approved at the moment.</p>}
      {usable.length > 0 && (
        <table class="table">
          <thead>
            <tr>
              <th scope="col">Release</th>
              <th scope="col">Program</th>
              <th scope="col">Machine</th>
              <th scope="col">Delivery</th>
              <th scope="col">State</th>
              {may && <th scope="col">Orders</th>}
            </tr>
          </thead>
          <tbody>
            {usable.map((release) => (
              <tr key={release.id}>
                <td data-label="Release">{release.id}</td>
                <td data-label="Program">
                  <strong>{programName(state, release.program)}</strong>{' '}
                  <span class="quiet-text">
                    rev. {release.revision}, <code title={release.sha256}>{shortHash(release.sha256)}…</code>
                  </span>
                </td>
                <td data-label="Machine">{release.machine}</td>
                <td data-label="Delivery">{deliveryText(release.delivery)}</td>
                <td data-label="State">
                  <Standing release={release} />
                </td>
                {may && (
                  <td data-label="Orders" class="orders">
                    {mayBeQueued(release) && (
                      <button
                        type="button"
                        class="button button-main"
                        disabled={busy || !live}
                        onClick={() => void queue(release)}
                        aria-label={`Queue release ${release.id}`}
                      >
                        Queue
                      </button>
                    )}
                  </td>
                )}
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </>
  );
}

function Standing({ release }: { release: Release }) {
  return (
    <>
      {releaseText(release.state)}
      <span class="reason">
        {release.state === 'proving'
          ? `${release.transfers_done} of ${release.transfers_allowed} transfers used`
          : `by ${release.approved_by ?? 'somebody'}, ${dateTime(release.changed_at_ms)}`}
      </span>
    </>
  );
}
