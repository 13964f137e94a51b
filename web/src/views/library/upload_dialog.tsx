// What dropped files become. Nothing is sent before a person has seen the names; a name that is there already is asked
// about; each file that the server refuses says why, beside its name.
import { useEffect, useState } from 'preact/hooks';
import type { Program } from '../../api/types';
import { bytes } from '../../format/numbers';
import { dialectText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { closeDialog, BackButton, Dialog } from '../../parts/dialog';
import { Failure } from '../../parts/failure';
import { Icon } from '../../parts/icon';
import { hrefs } from '../../router';
import { loader } from '../../state/loader';
import { kDialects } from '../../rules/dialects';
import { apart, readUpload, sameName, sendUpload, type Upload } from './upload';

interface Props {
  files: readonly File[];
  folder: string;
  changed: (program: Program) => void;
}

export function UploadDialog({ files, folder: given, changed }: Props) {
  const [uploads, setUploads] = useState<Upload[] | null>(null);
  const [error, setError] = useState<unknown>(null);
  const [folder, setFolder] = useState(given);
  const [busy, setBusy] = useState(false);
  useEffect(() => {
    loader.order(Promise.all(files.map(readUpload))).then(setUploads, setError);
  }, []);
  const change = (index: number, by: Partial<Upload>) =>
    setUploads((before) => before && before.map((one, i) => (i === index ? { ...one, ...by } : one)));
  const takeApart = async (upload: Upload) => {
    setBusy(true);
    try {
      const parts = await loader.order(apart(upload));
      setUploads((before) => before && before.flatMap((one) => (one.key === upload.key ? parts : [one])));
    } catch (failure) {
      setError(failure);
    }
    setBusy(false);
  };
  const open = uploads?.filter((one) => one.state !== 'done') ?? [];
  const isReady = open.length > 0 && open.every((one) => one.name.trim() !== '' && one.dialect !== '');
  const send = async (event: Event) => {
    event.preventDefault();
    if (busy || !isReady || !uploads) return;
    setBusy(true);
    for (const [index, one] of uploads.entries()) {
      if (one.state === 'done') continue;
      change(index, { state: 'sending', error: null });
      try {
        const program = await loader.order(sendUpload(one, folder.trim()));
        change(index, { state: 'done', program });
        changed(program);
      } catch (failure) {
        change(index, { state: 'failed', error: failure, same: await sameName(one.name).catch(() => one.same) });
      }
    }
    setBusy(false);
  };
  return (
    <Dialog title={t('upload.title', { count: files.length })}>
      <form onSubmit={send} class="upload">
        <Failure error={error} />
        {!uploads && error === null && <p role="status">{t('upload.reading')}</p>}
        {uploads && (
          <ol class="upload-list">
            {uploads.map((one, index) => (
              <UploadRow key={one.key} upload={one} off={busy || one.state === 'done'} change={(by) => change(index, by)} apart={() => void takeApart(one)} />
            ))}
          </ol>
        )}
        {open.some((one) => one.revise === null) && (
          <label class="field">
            <span>{t('upload.folder')}</span>
            <input value={folder} onInput={(event) => setFolder(event.currentTarget.value)} placeholder={t('labels.folder_example')} autocomplete="off" />
          </label>
        )}
        <div class="dialog-buttons">
          <BackButton />
          {(open.length > 0 || !uploads) && (
            <button type="submit" class="button button-main" disabled={busy || !isReady}>
              {busy ? t('dialog.sending') : t('upload.send', { count: open.length })}
            </button>
          )}
        </div>
      </form>
    </Dialog>
  );
}

const kShownParts = 4;
const partText = ({ name, comment }: Upload['parts'][number]): string => (comment === null ? (name ?? '–') : `${name ?? '–'} (${comment})`);

interface RowProps {
  upload: Upload;
  off: boolean;
  change: (by: Partial<Upload>) => void;
  apart: () => void;
}

function UploadRow({ upload, off, change, apart: takeApart }: RowProps) {
  // Another name may be another program's.
  const rename = (name: string) => {
    change({ name });
    void sameName(name.trim()).then((same) => change({ same, revise: same[0]?.id ?? null }), () => undefined);
  };
  if (upload.program)
    return (
      <li class="upload-row" data-state="done">
        <p>
          <Icon shape="good" /> <a href={hrefs.program(upload.program.id)} onClick={closeDialog}>{upload.program.name}</a>{' '}
          <span class="quiet-text">{t('job.revision', { revision: upload.program.revision })}</span>
        </p>
      </li>
    );
  return (
    <li class="upload-row" data-state={upload.state}>
      <p class="quiet-text">
        {upload.file}, {bytes(upload.bytes)}
      </p>
      <div class="upload-fields">
        <label class="field">
          <span>{t('column.name')}</span>
          <input value={upload.name} required disabled={off} onInput={(event) => rename(event.currentTarget.value)} autocomplete="off" />
        </label>
        <label class="field">
          <span>{t('column.dialect')}</span>
          <select value={upload.dialect} required disabled={off || upload.revise !== null} onChange={(event) => change({ dialect: event.currentTarget.value })}>
            <option value="" />
            {kDialects.map((name) => (
              <option key={name} value={name}>
                {dialectText(name)}
              </option>
            ))}
          </select>
        </label>
      </div>
      {upload.parts.length > 0 && (
        <p class="hint">
          {t('upload.holds', { count: upload.parts.length, names: upload.parts.slice(0, kShownParts).map(partText).join(', ') })}
          {upload.parts.length > kShownParts && ', …'}{' '}
          <button type="button" class="button button-small" disabled={off} onClick={takeApart}>
            {t('upload.take_apart')}
          </button>
        </p>
      )}
      {upload.same.length > 0 && <SameName upload={upload} off={off} change={change} />}
      {upload.isLatin1 && <p class="hint">{t('upload.latin1')}</p>}
      <Failure error={upload.error} />
    </li>
  );
}

function SameName({ upload, off, change }: { upload: Upload; off: boolean; change: (by: Partial<Upload>) => void }) {
  return (
    <fieldset class="choices" disabled={off}>
      <legend>{t('upload.same_name', { name: upload.name.trim() })}</legend>
      {upload.same.map((program) => (
        <label key={program.id} class="choice">
          <input
            type="radio"
            name={upload.key}
            checked={upload.revise === program.id}
            onChange={() => change({ revise: program.id, dialect: program.dialect })}
          />
          {t('upload.as_revision', { next: program.revision + 1, id: program.id, by: program.created_by })}
        </label>
      ))}
      <label class="choice">
        <input type="radio" name={upload.key} checked={upload.revise === null} onChange={() => change({ revise: null })} />
        {t('upload.as_new')}
      </label>
    </fieldset>
  );
}
