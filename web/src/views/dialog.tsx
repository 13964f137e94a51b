// A modal dialog that sends one order: what it says, an optional reason, the answer's error where it failed. The
// browser's own <dialog> keeps the focus inside and closes on Escape.
import type { ComponentChildren } from 'preact';
import { useEffect, useId, useRef, useState } from 'preact/hooks';
import { ApiError, newOrderKey } from '../api/client';
import { textOf } from '../state/sync';
import { useDesk } from './context';

export interface OrderDialogProps {
  title: string;
  confirm: string;
  danger?: boolean;
  reason?: string; // the label of the reason that is asked for
  blocked?: string | null; // why it cannot be sent now
  send: (key: string, reason: string) => Promise<unknown>;
  close: () => void;
  children: ComponentChildren;
}

export function OrderDialog(props: OrderDialogProps) {
  const { sync } = useDesk();
  const dialog = useRef<HTMLDialogElement>(null);
  const [reason, setReason] = useState('');
  const [busy, setBusy] = useState(false);
  const [error, setError] = useState<unknown>(null);
  const [key, setKey] = useState(newOrderKey);
  const id = useId();
  useEffect(() => dialog.current?.showModal(), []);

  const missing = props.reason !== undefined && reason.trim() === '';
  const submit = async (event: Event) => {
    event.preventDefault();
    if (busy || missing || props.blocked) return;
    setBusy(true);
    setError(null);
    try {
      await sync.order(props.send(key, reason.trim()));
      props.close();
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
    <dialog ref={dialog} class="dialog" aria-labelledby={`${id}-title`} onClose={props.close}>
      <form onSubmit={submit}>
        <h2 id={`${id}-title`}>{props.title}</h2>
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
          <button type="button" class="button" onClick={() => dialog.current?.close()}>
            Back
          </button>
          <button
            type="submit"
            class={`button ${props.danger ? 'button-danger' : 'button-main'}`}
            disabled={busy || missing || Boolean(props.blocked)}
          >
            {busy ? 'Sending…' : props.confirm}
          </button>
        </div>
      </form>
    </dialog>
  );
}

// The sentence of the server, and its places.
export function Failure({ error }: { error: unknown }) {
  if (error === null) return null;
  const details = error instanceof ApiError ? error.details : [];
  return (
    <div class="notice tone-bad" role="alert">
      <p>{textOf(error)}</p>
      {details.length > 0 && (
        <ul>
          {details.map((line) => (
            <li key={line}>{line}</li>
          ))}
        </ul>
      )}
    </div>
  );
}
