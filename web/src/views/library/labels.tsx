// Where a program is filed: its folder and tags, and their editing in place.
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Program } from '../../api/types';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { hrefs } from '../../router';
import { tagsOf } from '../../rules/program_files';
import { loader } from '../../state/loader';

interface Props {
  program: Program;
  may: boolean;
  changed: (program: Program) => void;
}

export function Labels({ program, may, changed }: Props) {
  const [editing, setEditing] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const wasEditing = useRef(false);
  // At once: later it could take the focus from a field into which a person types by then.
  useLayoutEffect(() => {
    if (wasEditing.current && !editing) button.current?.focus();
    wasEditing.current = editing;
  }, [editing]);
  const isFiled = program.folder !== null || program.tags.length > 0;
  if (editing) return <LabelForm program={program} done={() => setEditing(false)} changed={changed} />;
  return (
    <div class="labels">
      {program.folder && (
        <a class="folder" href={hrefs.libraryOf({ folder: program.folder })}>
          {program.folder}
        </a>
      )}
      {program.tags.map((tag) => (
        <a key={tag} class="tag" href={hrefs.libraryOf({ tag })}>
          {tag}
        </a>
      ))}
      {may && (
        <button
          ref={button}
          type="button"
          class="button button-small"
          onClick={() => setEditing(true)}
          aria-label={t(isFiled ? 'labels.edit_of' : 'labels.add_of', { name: program.name })}
        >
          {t(isFiled ? 'labels.edit' : 'labels.add')}
        </button>
      )}
    </div>
  );
}

function LabelForm({ program, done, changed }: { program: Program; done: () => void; changed: (program: Program) => void }) {
  const [folder, setFolder] = useState(program.folder ?? '');
  const [tags, setTags] = useState(program.tags.join(', '));
  const [error, setError] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const first = useRef<HTMLInputElement>(null);
  useLayoutEffect(() => first.current?.focus(), []);
  const save = async (event: Event) => {
    event.preventDefault();
    if (busy) return;
    setBusy(true);
    setError(null);
    try {
      changed(await loader.order(deskCalls.label(program.id, { folder: folder.trim(), tags: tagsOf(tags) })));
      done();
    } catch (failure) {
      setError(failure);
      setBusy(false);
    }
  };
  return (
    <form class="label-form" onSubmit={save} onKeyDown={(event) => event.key === 'Escape' && done()} aria-label={t('labels.form', { name: program.name })}>
      <label class="field">
        <span>{t('labels.folder')}</span>
        <input ref={first} value={folder} onInput={(event) => setFolder(event.currentTarget.value)} placeholder={t('labels.folder_example')} autocomplete="off" />
      </label>
      <label class="field">
        <span>{t('labels.tags')}</span>
        <input value={tags} onInput={(event) => setTags(event.currentTarget.value)} placeholder={t('labels.tags_example')} autocomplete="off" />
      </label>
      <Failure error={error} />
      <div class="dialog-buttons">
        <button type="button" class="button button-small" onClick={done}>
          {t('dialog.back')}
        </button>
        <button type="submit" class="button button-small button-main" disabled={busy}>
          {t('labels.save')}
        </button>
      </div>
    </form>
  );
}
