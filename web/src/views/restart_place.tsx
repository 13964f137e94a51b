// A restart of an ended job's program: where, what would be sent, and then step by step to a job of its own. Each step is
// a person's; nothing here sends anything.
import { useState } from 'preact/hooks';
import { calls } from '../api/calls';
import { newOrderKey } from '../api/client';
import { deskCalls } from '../api/desk_calls';
import type { Job, Release, RestartPreview } from '../api/types';
import { shortHash } from '../format/numbers';
import { releaseText } from '../format/words';
import { t } from '../i18n/i18n';
import { Failure } from '../parts/failure';
import { atLeast } from '../rules/roles';
import { lineOfEnd, shownLines, stepOf } from '../rules/restarts';
import { hrefs } from '../router';
import { isLive, roleOn } from '../state/shop';
import { loader } from '../state/loader';

const kShownOfRest = 6;

export function RestartPlace({ job }: { job: Job }) {
  const [line, setLine] = useState(() => String(lineOfEnd(job) ?? ''));
  const [preview, setPreview] = useState<{ line: number; of: RestartPreview } | null>(null);
  const [release, setRelease] = useState<Release | null>(null);
  const [error, setError] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const run = async (work: () => Promise<void>) => {
    if (busy) return;
    setBusy(true);
    setError(null);
    try {
      await work();
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  const show = (at: number) =>
    run(async () => {
      setLine(String(at));
      setRelease(null);
      setPreview(null);
      setPreview({ line: at, of: await loader.order(deskCalls.previewRestart(job.release, at)) });
    });
  const wanted = Number(line);
  const isLine = Number.isInteger(wanted) && wanted > 0;
  return (
    <section class="card restart" aria-label={t('restart.title')} aria-busy={busy}>
      <h2>{t('restart.title')}</h2>
      <p class="lead">{t('restart.lead')}</p>
      <form
        class="restart-form"
        onSubmit={(event) => {
          event.preventDefault();
          if (isLine) void show(wanted);
        }}
      >
        <label class="field">
          <span>{t('restart.line')}</span>
          <input type="number" min="1" value={line} onInput={(event) => setLine(event.currentTarget.value)} />
        </label>
        <button type="submit" class="button" aria-disabled={!isLine || busy || !isLive.value}>
          {t('restart.show')}
        </button>
      </form>
      {lineOfEnd(job) !== null && <p class="hint">{t('restart.proposed', { line: lineOfEnd(job) ?? 0 })}</p>}
      <Failure error={error} />
      {preview && <Shown preview={preview.of} show={(at) => void show(at)} />}
      {preview?.of.possible && !release && (
        <MakeIt job={job} line={preview.line} preview={preview.of} busy={busy} run={run} made={setRelease} />
      )}
      {release && <Steps release={release} busy={busy} run={run} moved={setRelease} />}
    </section>
  );
}

type Run = (work: () => Promise<void>) => Promise<void>;

function Shown({ preview, show }: { preview: RestartPreview; show: (line: number) => void }) {
  return (
    <>
      {preview.diagnostics.map((one) => (
        <p key={one.text} class="notice tone-bad" role="alert">
          {t('restart.refused', { text: one.text })}
        </p>
      ))}
      {preview.text === null && (
        <p class="restart-near">
          {preview.safe_before === null && preview.safe_after === null && t('restart.none_near')}
          {[preview.safe_before, preview.safe_after].map(
            (line) =>
              line !== null && (
                <button key={line} type="button" class="button" onClick={() => show(line)}>
                  {t('restart.near', { line })}
                </button>
              ),
          )}
        </p>
      )}
      {preview.text !== null && <Text preview={preview} />}
    </>
  );
}

function Text({ preview }: { preview: RestartPreview }) {
  return (
    <>
      <h3>{t('restart.text')}</h3>
      <pre class="text-box restart-text" tabIndex={0} aria-label={t('restart.text')}>
        {shownLines(preview, kShownOfRest).map(({ number, text, isNew }) => (
          <span key={number} class={isNew ? 'restart-new' : 'restart-rest'}>
            {`${String(number).padStart(5)}  ${text}\n`}
          </span>
        ))}
      </pre>
      <p class="hint">{t('restart.same', { moves: preview.compared_moves })}</p>
      <details>
        <summary>{t('restart.whole')}</summary>
        <pre class="text-box" tabIndex={0} aria-label={t('restart.whole')}>
          {preview.text}
        </pre>
      </details>
      <h3>{t('restart.assumes')}</h3>
      <ul class="restart-assumptions">
        {preview.assumptions.map((one) => (
          <li key={one}>{one}</li>
        ))}
      </ul>
      {preview.not_held !== null && <p class="notice">{t('restart.not_held', { why: preview.not_held })}</p>}
      {preview.findings.map((one) => (
        <p key={`${one.line} ${one.text}`} class="notice tone-bad">
          {t('restart.finding', { line: one.line, text: one.text })}
        </p>
      ))}
    </>
  );
}

interface MakeProps {
  job: Job;
  line: number;
  preview: RestartPreview;
  busy: boolean;
  run: Run;
  made: (release: Release) => void;
}

function MakeIt({ job, line, preview, busy, run, made }: MakeProps) {
  const [isRead, setRead] = useState(false);
  if (!atLeast(roleOn(job.machine), 'programmer')) return <p class="hint">{t('restart.needs_programmer')}</p>;
  return (
    <div class="restart-make">
      <label class="check">
        <input type="checkbox" checked={isRead} onInput={(event) => setRead(event.currentTarget.checked)} />
        <span>{t('restart.is_read', { sha: shortHash(preview.sha256 ?? '') })}</span>
      </label>
      <button
        type="button"
        class="button button-main"
        aria-disabled={!isRead || busy}
        onClick={() =>
          isRead &&
          void run(async () =>
            made(await loader.order(deskCalls.makeRestart(job.release, line, preview.sha256 ?? '', newOrderKey()))),
          )
        }
      >
        {t('restart.make')}
      </button>
    </div>
  );
}

function Steps({ release, busy, run, moved }: { release: Release; busy: boolean; run: Run; moved: (release: Release) => void }) {
  const [queued, setQueued] = useState<Job | null>(null);
  const role = roleOn(release.machine);
  const step = stepOf(release);
  return (
    <div class="restart-steps" role="status">
      <p>{t('restart.made', { release: release.id, state: releaseText(release.state) })}</p>
      {step === 'clear' && <a href={hrefs.program(release.program, 'checks')}>{t('restart.clear')}</a>}
      {step === 'release' && !atLeast(role, 'approver') && <p class="hint">{t('restart.needs_approver')}</p>}
      {step === 'release' && atLeast(role, 'approver') && (
        <button
          type="button"
          class="button button-main"
          aria-disabled={busy}
          onClick={() => void run(async () => moved(await loader.order(deskCalls.releaseRestart(release.id, release.sha256, newOrderKey()))))}
        >
          {t('restart.release')}
        </button>
      )}
      {step === 'queue' && !queued && (
        <button
          type="button"
          class="button button-main"
          aria-disabled={busy}
          onClick={() => void run(async () => setQueued(await loader.order(calls.addJob(release.id))))}
        >
          {t('restart.queue')}
        </button>
      )}
      {queued && (
        <p class="notice tone-good">
          {t('releases.queued', { job: queued.id })} <a href={hrefs.machine(queued.machine)}>{t('releases.go', { machine: queued.machine })}</a>
        </p>
      )}
    </div>
  );
}
