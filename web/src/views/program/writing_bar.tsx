// What a person does with the text: save it, look at it in another form, have it rewritten.
import type { RefObject } from 'preact';
import { useMemo } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Program } from '../../api/types';
import type { Editor } from '../../editor/editor';
import { t } from '../../i18n/i18n';
import { showDialog } from '../../parts/dialog';
import { changeQuery } from '../../router';
import { machines } from '../../state/shop';
import { RewriteDialog } from './rewrite_dialog';
import type { WritingState } from './use_writing';

export const Download = ({ program, revision }: { program: Program; revision: number }) => (
  <a class="button" download={program.name} href={deskCalls.textHref(program.id, revision)}>
    {t('text.download')}
  </a>
);

// What is shown beside the text.
export interface BesideText {
  withPath: boolean;
  withFigures: boolean;
  to: string | null; // what it is translated for; null: it is not
}

interface BarProps {
  program: Program;
  writing: WritingState;
  editor: RefObject<Editor | null>;
  line: number;
  beside: BesideText;
  machine: string | null; // null: it is not chosen here
}

export const WritingBar = ({ program, writing, editor, line, beside: { withPath, withFigures, to }, machine }: BarProps) => (
  <div class="writing-bar">
    <SaveButtons program={program} writing={writing} />
    <button type="button" class="button" onClick={() => editor.current?.find()}>
      {t('text.find')}
    </button>
    <button type="button" class="button" aria-pressed={withPath} onClick={() => changeQuery('path', withPath ? null : '1')}>
      {t('path.title')}
    </button>
    {machine !== null && (
      <button type="button" class="button" aria-pressed={to !== null} onClick={() => changeQuery('to', to !== null ? null : '?')}>
        {t('translation.title')}
      </button>
    )}
    {machine !== null && (
      <button type="button" class="button" aria-pressed={withFigures} onClick={() => changeQuery('figures', withFigures ? null : '1')}>
        {t('figures.title')}
      </button>
    )}
    {machine !== null && writing.mayWrite && (
      <button type="button" class="button" onClick={() => showDialog(<RewriteDialog program={program} machine={machine} editor={editor} />)}>
        {t('rewrite.open')}
      </button>
    )}
    <Download program={program} revision={writing.base} />
    {machine !== null && <MachineChoice dialect={program.dialect} value={machine} />}
    <span class="writing-state" role="status">
      {writing.isChanged ? t('text.not_saved') : t('text.saved', { revision: writing.base })} {t('fault.line', { line })}
    </span>
  </div>
);

function SaveButtons({ program, writing }: { program: Program; writing: WritingState }) {
  const { mayWrite, isChanged, isBehind, saving, restoredAt, save, discard } = writing;
  if (!mayWrite) return null;
  return (
    <>
      <button type="button" class="button button-main" aria-disabled={!isChanged || saving || isBehind} onClick={() => void save()}>
        {saving ? t('dialog.sending') : t('text.save', { next: program.revision + 1 })}
      </button>
      {isChanged && !isBehind && restoredAt === null && (
        <button type="button" class="button" onClick={discard}>
          {t('text.discard')}
        </button>
      )}
    </>
  );
}

// For whose control the text is read; without one, for the one that it looks like.
function MachineChoice({ dialect, value }: { dialect: string; value: string }) {
  const fitting = useMemo(() => [...machines.value.values()].filter((one) => one.head.value.dialect === dialect), [machines.value, dialect]);
  return (
    <label class="choice">
      <span>{t('text.read_for')}</span>
      <select value={value} onChange={(event) => changeQuery('machine', event.currentTarget.value || null)}>
        <option value="">{t('text.read_as_it_looks')}</option>
        {fitting.map(({ name }) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
    </label>
  );
}
