// Modal dialogs. One place of the page shows them, so that none vanishes because the card or row that asked for it was
// redrawn. The browser's own <dialog> keeps the focus inside and closes on Escape; afterwards the focus goes back to
// where it was, or to the heading where that is gone.
import { signal } from '@preact/signals';
import type { ComponentChildren, VNode } from 'preact';
import { useEffect, useId, useRef, useState } from 'preact/hooks';
import { ApiError, newOrderKey } from '../api/client';
import { t } from '../i18n/i18n';
import { loader } from '../state/loader';
import { Failure } from './failure';

const shown = signal<VNode | null>(null);
let opener: Element | null = null;

export function showDialog(dialog: VNode): void {
  opener = document.activeElement;
  shown.value = dialog;
}

export function closeDialog(): void {
  if (shown.peek() === null) return;
  shown.value = null;
  const before = opener;
  opener = null;
  // After the dialog is gone: while it is modal nothing outside takes the focus.
  requestAnimationFrame(() => {
    if (before instanceof HTMLElement && before.isConnected) before.focus();
    if (document.activeElement === document.body) document.querySelector<HTMLElement>('main h1')?.focus();
  });
}

export const DialogHost = () => shown.value;

interface FrameProps {
  title: string;
  wide?: boolean; // it has a table
  children: ComponentChildren;
}

// The frame: a title, and closing.
export function Dialog({ title, wide = false, children }: FrameProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  const id = useId();
  useEffect(() => dialog.current?.showModal(), []);
  return (
    <dialog ref={dialog} class={wide ? 'dialog dialog-wide' : 'dialog'} aria-labelledby={id} onClose={closeDialog}>
      <h2 id={id}>{title}</h2>
      {children}
    </dialog>
  );
}

export const BackButton = () => (
  <button type="button" class="button" onClick={(event) => event.currentTarget.closest('dialog')?.close()}>
    {t('dialog.back')}
  </button>
);

export interface OrderDialogProps {
  title: string;
  confirm: string;
  danger?: boolean;
  reason?: string; // the label of the reason that is asked for
  blocked?: string | null; // why it cannot be sent now
  send: (key: string, reason: string) => Promise<unknown>;
  children: ComponentChildren;
}

// Sends one order of a person: what it says, an optional reason, the answer's error where it failed.
export function OrderDialog(props: OrderDialogProps) {
  const [reason, setReason] = useState('');
  const [busy, setBusy] = useState(false);
  const [error, setError] = useState<unknown>(null);
  const [key, setKey] = useState(newOrderKey);
  const missing = props.reason !== undefined && reason.trim() === '';
  const submit = async (event: Event) => {
    event.preventDefault();
    if (busy || missing || props.blocked) return;
    setBusy(true);
    setError(null);
    try {
      await loader.order(props.send(key, reason.trim()));
      closeDialog();
    } catch (failure) {
      // Without an answer the same order may be repeated under its key; after an answer the next try is a new one.
      if (failure instanceof ApiError && failure.status !== 0) setKey(newOrderKey());
      setError(failure);
      setBusy(false);
    }
  };
  const changeReason = (text: string) => {
    setReason(text);
    setKey(newOrderKey());
  };
  return (
    <Dialog title={props.title}>
      <form onSubmit={submit}>
        {props.children}
        {props.reason !== undefined && (
          <label class="field">
            <span>{props.reason}</span>
            <input
              type="text"
              required
              maxLength={500}
              autocomplete="off"
              value={reason}
              onInput={(event) => changeReason(event.currentTarget.value)}
            />
          </label>
        )}
        {props.blocked && (
          <p class="notice tone-waiting" role="status">
            {props.blocked}
          </p>
        )}
        <Failure error={error} />
        <div class="dialog-buttons">
          <BackButton />
          <button
            type="submit"
            class={`button ${props.danger ? 'button-danger' : 'button-main'}`}
            disabled={busy || missing || Boolean(props.blocked)}
          >
            {busy ? t('dialog.sending') : props.confirm}
          </button>
        </div>
      </form>
    </Dialog>
  );
}
