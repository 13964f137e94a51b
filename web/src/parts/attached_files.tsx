// The files of a program, family, part or order: setup sheets, drawings, pictures. They are added by a button or dropped,
// saved by a click, and removed with a reason. Pictures are shown; nothing else of a file is ever run or shown.
import { useRef, useState } from 'preact/hooks';
import { newOrderKey } from '../api/client';
import { deskCalls, type FileOwner } from '../api/desk_calls';
import type { Attachment } from '../api/types';
import { bytes } from '../format/numbers';
import { dateTime } from '../format/times';
import { t } from '../i18n/i18n';
import { loader } from '../state/loader';
import { textOf } from '../state/shop';
import { OrderDialog, showDialog } from './dialog';
import { Failure } from './failure';
import { useLoaded } from './use_loaded';

const kPictures = ['image/png', 'image/jpeg', 'image/webp', 'image/gif'];

interface Props {
  owner: FileOwner;
  may: boolean; // add and remove
}

export function AttachedFiles({ owner, may }: Props) {
  const { value: files, error, set } = useLoaded(JSON.stringify(owner), () => deskCalls.attachments(owner));
  const [refused, setRefused] = useState<string[]>([]);
  const [sending, setSending] = useState('');
  const [isOver, setOver] = useState(false);
  const input = useRef<HTMLInputElement>(null);
  // One after the other; what is refused does not keep the rest.
  const add = async (given: readonly File[]) => {
    const failed: string[] = [];
    let now = files ?? [];
    for (const file of given) {
      setSending(file.name);
      try {
        now = [await loader.order(deskCalls.attach(owner, file, newOrderKey())), ...now];
        set(now);
      } catch (failure) {
        failed.push(`${file.name}: ${textOf(failure)}`);
      }
    }
    setSending('');
    setRefused(failed);
  };
  const drop = (event: DragEvent) => {
    event.preventDefault();
    setOver(false);
    void add([...(event.dataTransfer?.files ?? [])]);
  };
  const removed = (gone: Attachment) => set((files ?? []).filter(({ id }) => id !== gone.id));
  return (
    <section
      class={isOver ? 'card drop-here' : 'card'}
      aria-label={t('files.title')}
      onDragOver={(event) => {
        if (!may) return;
        event.preventDefault();
        setOver(true);
      }}
      onDragLeave={() => setOver(false)}
      onDrop={(event) => may && drop(event)}
    >
      <h2>{t('files.title')}</h2>
      <Failure error={error} />
      {files?.length === 0 && <p class="quiet-text">{t(may ? 'files.none_yet' : 'files.none')}</p>}
      <ul class="attached">
        {files?.map((file) => (
          <AttachedFile key={file.id} file={file} may={may} removed={removed} />
        ))}
      </ul>
      {refused.map((text) => (
        <p key={text} class="notice tone-bad" role="alert">
          {text}
        </p>
      ))}
      {sending !== '' && (
        <p class="hint" role="status">
          {t('files.sending', { name: sending })}
        </p>
      )}
      {may && (
        <>
          <button type="button" class="button" aria-disabled={sending !== ''} onClick={() => sending === '' && input.current?.click()}>
            {t('files.add')}
          </button>
          <input
            ref={input}
            type="file"
            multiple
            hidden
            onChange={(event) => {
              void add([...(event.currentTarget.files ?? [])]);
              event.currentTarget.value = '';
            }}
          />
        </>
      )}
    </section>
  );
}

function AttachedFile({ file, may, removed }: { file: Attachment; may: boolean; removed: (gone: Attachment) => void }) {
  const href = deskCalls.attachmentHref(file.id);
  const ask = () =>
    showDialog(
      <OrderDialog
        title={t('files.remove_title', { name: file.name })}
        confirm={t('files.remove')}
        danger
        reason={t('files.remove_reason')}
        send={async (key, reason) => removed(await deskCalls.detach(file.id, reason, key))}
      >
        <p>{t('files.remove_text')}</p>
      </OrderDialog>,
    );
  return (
    <li data-file={file.name}>
      {kPictures.includes(file.media_type) && <img src={href} alt={t('files.picture', { name: file.name })} loading="lazy" />}
      <span>
        <a href={href} download={file.name}>
          {file.name}
        </a>{' '}
        <span class="quiet-text">
          {bytes(file.bytes)}, {t('library.changed', { name: file.added_by, at: dateTime(file.added_at_ms) })}
        </span>
      </span>
      {may && (
        <button type="button" class="button button-small" onClick={ask} aria-label={t('files.remove_of', { name: file.name })}>
          {t('files.remove')}
        </button>
      )}
    </li>
  );
}
