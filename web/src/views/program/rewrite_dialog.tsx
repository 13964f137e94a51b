// The text rewritten by the server: block numbers, blanks, letters. It comes into the editor as one step that can be
// undone, or not at all: then the lines are shown that stand against it.
import type { RefObject } from 'preact';
import { useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Program, Rewriting, Rewritten } from '../../api/types';
import type { Editor } from '../../editor/editor';
import { t } from '../../i18n/i18n';
import { BackButton, closeDialog, Dialog } from '../../parts/dialog';
import { Failure } from '../../parts/failure';
import { kMostStep, kRewrites, orderOf, takesNumbers, type RewriteChoice } from '../../rules/rewrites';
import { loader } from '../../state/loader';

interface Props {
  program: Program;
  machine: string; // whose control the text is for; '': the control that it looks like
  editor: RefObject<Editor | null>;
}

type Outcome = { refused: Rewritten['refused'] } | 'same' | 'moved_on' | null;

export function RewriteDialog({ program, machine, editor }: Props) {
  const [choice, setChoice] = useState<RewriteChoice>('renumber');
  const [first, setFirst] = useState(10);
  const [step, setStep] = useState(10);
  const [busy, setBusy] = useState(false);
  const [error, setError] = useState<unknown>(null);
  const [outcome, setOutcome] = useState<Outcome>(null);

  const ask = async (text: string): Promise<Outcome | 'done'> => {
    const order: Rewriting = { text, dialect: program.dialect, ...(machine ? { machine } : {}), ...orderOf(choice, first, step) };
    const made = await loader.order(deskCalls.rewrite(order));
    if (made.text === null) return { refused: made.refused };
    if (made.text === text) return 'same';
    return editor.current?.rewrite(made.text, text) ? 'done' : 'moved_on';
  };
  const submit = async (event: Event) => {
    event.preventDefault();
    const text = editor.current?.text();
    if (busy || text === undefined) return;
    setBusy(true);
    setError(null);
    setOutcome(null);
    try {
      const came = await ask(text);
      if (came === 'done') closeDialog();
      else setOutcome(came);
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  return (
    <Dialog title={t('rewrite.title')}>
      <form onSubmit={submit}>
        <label class="field">
          <span>{t('rewrite.what')}</span>
          <select value={choice} onChange={(event) => setChoice(event.currentTarget.value as RewriteChoice)}>
            {kRewrites.map(({ id }) => (
              <option key={id} value={id}>
                {t(`rewrite.${id}`)}
              </option>
            ))}
          </select>
        </label>
        {takesNumbers(choice) && (
          <>
            <StepField label={t('rewrite.first')} value={first} set={setFirst} />
            <StepField label={t('rewrite.step')} value={step} set={setStep} />
          </>
        )}
        <p class="hint">{t(`rewrite_hint.${choice}`)}</p>
        <OutcomeText outcome={outcome} editor={editor} />
        <Failure error={error} />
        <div class="dialog-buttons">
          <BackButton />
          <button type="submit" class="button button-main" disabled={busy}>
            {t(busy ? 'dialog.sending' : 'rewrite.confirm')}
          </button>
        </div>
      </form>
    </Dialog>
  );
}

const StepField = ({ label, value, set }: { label: string; value: number; set: (value: number) => void }) => (
  <label class="field">
    <span>{label}</span>
    <input type="number" required min={1} max={kMostStep} value={value} onInput={(event) => set(event.currentTarget.valueAsNumber)} />
  </label>
);

function OutcomeText({ outcome, editor }: { outcome: Outcome; editor: RefObject<Editor | null> }) {
  if (outcome === null) return null;
  if (typeof outcome === 'string')
    return (
      <p class="notice tone-waiting" role="status">
        {t(`rewrite.${outcome}`)}
      </p>
    );
  return (
    <div class="notice tone-bad" role="alert">
      <p>{t('rewrite.refused')}</p>
      <ul>
        {outcome.refused.map(({ line, text }) => (
          <li key={`${line} ${text}`}>
            {line !== null && (
              <button
                type="button"
                class="button button-small"
                onClick={() => {
                  closeDialog();
                  requestAnimationFrame(() => editor.current?.goTo(line));
                }}
              >
                {t('fault.line', { line })}
              </button>
            )}{' '}
            {text}
          </li>
        ))}
      </ul>
    </div>
  );
}
