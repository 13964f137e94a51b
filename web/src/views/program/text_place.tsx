// The text: read by everybody, written by programmers. What the server finds in it stands in the margin and in the list
// beside it; a save is the next revision, and never over another one that somebody made meanwhile.
import type { RefObject } from 'preact';
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { ApiError, newOrderKey } from '../../api/client';
import { deskCalls } from '../../api/desk_calls';
import type { Program } from '../../api/types';
import type { Editor } from '../../editor/editor';
import { bytes } from '../../format/numbers';
import { clockTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { changeQuery, hrefs } from '../../router';
import { decodeProgram, lineEndOf, linesOf } from '../../rules/program_files';
import { loader } from '../../state/loader';
import { machines, person } from '../../state/shop';
import { PathPanel } from './path_panel';
import { TranslationPanel } from './translation_panel';
import type { PlaceProps } from './program_view';
import { SidePanel } from './side_panel';
import { TextEditor } from './text_editor';
import { useDiagnosis } from './use_diagnosis';
import { useDraft, type Drafting } from './use_draft';

interface Stored {
  text: string; // line ends as LF
  lineEnd: string;
  isMixed: boolean; // several kinds of line ends: a save makes them one
  isLatin1: boolean;
}

function storedOf(bytes: ArrayBuffer): Stored {
  const { text, encoding } = decodeProgram(bytes);
  const lineEnd = lineEndOf(text);
  return { text: linesOf(text).join('\n'), lineEnd: lineEnd ?? '\n', isMixed: lineEnd === null, isLatin1: encoding === 'latin-1' };
}

const kMost_bytes = 16 * 1024 * 1024; // a longer text is not shown here

export const TextPlace = (props: PlaceProps) =>
  props.program.bytes > kMost_bytes ? (
    <p class="notice tone-waiting">
      {t('text.too_large', { bytes: bytes(props.program.bytes) })} <Download program={props.program} revision={props.program.revision} />
    </p>
  ) : (
    <ShownText {...props} />
  );

const Download = ({ program, revision }: { program: Program; revision: number }) => (
  <a class="button" download={program.name} href={deskCalls.textHref(program.id, revision)}>
    {t('text.download')}
  </a>
);

function ShownText(props: PlaceProps) {
  const { program, query } = props;
  const wanted = Number(query.get('revision')) || program.revision;
  const drafting = useDraft(person().name, program.id);
  // What is being written stays as it is while others save.
  const isOld = wanted !== program.revision;
  const base = !isOld && drafting.found ? drafting.found.base : wanted;
  const [opened, setOpened] = useState<number | null>(null);
  const shown = isOld ? wanted : (opened ?? (drafting.ready ? base : null));
  useEffect(() => {
    if (drafting.ready) setOpened(isOld ? null : base);
  }, [drafting.ready, isOld]);
  const { value: stored, error } = useLoaded(shown === null ? null : `${program.id}.${shown}`, async () =>
    storedOf(await deskCalls.programBytes(program.id, shown ?? 0)),
  );
  if (error !== null) return <Failure error={error} />;
  if (!stored || shown === null || !drafting.ready)
    return (
      <p class="waiting" role="status">
        {t('page.loading')}
      </p>
    );
  return <Writing key={`${shown} ${isOld}`} {...props} base={shown} isOld={isOld} stored={stored} drafting={drafting} moveTo={setOpened} />;
}

interface WritingProps extends PlaceProps {
  base: number; // the revision that is shown, and that a save follows
  isOld: boolean; // an earlier one, to read
  stored: Stored;
  drafting: Drafting;
  moveTo: (base: number) => void;
}

// What is written, what it began from, and what a person may do with it.
function useWriting(props: WritingProps) {
  const { program, isOld, drafting, changed, again, moveTo } = props;
  const draft = !isOld && drafting.found?.base === props.base ? drafting.found : null;
  const [text, setText] = useState(draft?.text ?? props.stored.text);
  const [restoredAt, setRestoredAt] = useState(draft && draft.text !== props.stored.text ? draft.atMs : null);
  const [saved, setSaved] = useState<{ base: number; text: string } | null>(null); // since it was opened
  const [saving, setSaving] = useState(false);
  const [error, setError] = useState<unknown>(null);
  const [key, setKey] = useState(newOrderKey);
  const base = saved?.base ?? props.base;
  const stored: Stored = saved ? { ...props.stored, text: saved.text, isMixed: false } : props.stored;
  const mayWrite = props.may && !isOld && !stored.isLatin1;
  const isChanged = text !== stored.text;
  const isBehind = !isOld && program.revision > base;
  useEffect(() => {
    if (isBehind && !isChanged) moveTo(program.revision);
  }, [isBehind, isChanged]);

  const edit = (to: string) => {
    setText(to);
    setKey(newOrderKey());
    if (to === stored.text) void drafting.drop(base);
    else drafting.keep(base, to);
  };
  const discard = () => {
    void drafting.drop(base);
    setText(stored.text);
    setRestoredAt(null);
    if (isBehind) moveTo(program.revision);
  };
  const save = async () => {
    if (saving || !isChanged || !mayWrite || isBehind) return;
    setSaving(true);
    setError(null);
    try {
      const next = await loader.order(deskCalls.addRevision(program.id, base, text.split('\n').join(stored.lineEnd), key));
      await drafting.drop(base);
      setSaved({ base: next.revision, text });
      setRestoredAt(null);
      setKey(newOrderKey());
      changed(next);
    } catch (failure) {
      if (failure instanceof ApiError && failure.status === 412) again(); // who saved, and what
      else setError(failure);
    }
    setSaving(false);
  };
  // The text as it is goes on from the newest revision; what that one changed is the person's to put in.
  const rebase = async () => {
    await drafting.move(base, program.revision, text);
    moveTo(program.revision);
  };
  return { text, base, stored, mayWrite, isChanged, isBehind, restoredAt, saving, error, edit, discard, save, rebase };
}

type WritingState = ReturnType<typeof useWriting>;

function Writing(props: WritingProps) {
  const { program, query, isProgrammer } = props;
  const writing = useWriting(props);
  const { text, mayWrite } = writing;
  const [{ line, word }, setCursor] = useState({ line: 1, word: '' });
  const editor = useRef<Editor | null>(null);
  const machine = query.get('machine') ?? '';
  const diagnosis = useDiagnosis(isProgrammer ? text : null, program.dialect, machine);
  const kind = diagnosis.found?.control.kind ?? '';
  const gSystem = diagnosis.found?.control.g_system ?? '';
  const { value: words } = useLoaded(`${program.dialect} ${kind} ${gSystem}`, () => deskCalls.words(program.dialect, kind, gSystem));
  useLeaving(writing.isChanged);
  useSaveKey(writing.save);
  const seekLine = useLineOfQuery(query.get('line'), editor);
  const withPath = query.get('path') === '1';
  const to = isProgrammer ? query.get('to') : null;
  return (
    <div class={withPath || to ? 'writing writing-beside' : 'writing'}>
      <div class="writing-main">
        <Notices program={program} isOld={props.isOld} writing={writing} />
        <Failure error={writing.error} />
        <WritingBar program={program} writing={writing} editor={editor} line={line} withPath={withPath} withTranslation={to !== null} machine={isProgrammer ? machine : null} />
        <p class="word-help">{word}</p>
        <TextEditor
          text={text}
          label={t('text.label', { name: program.name })}
          readOnly={!mayWrite}
          words={words}
          isSure={kind !== ''}
          faults={diagnosis.found?.faults ?? kNoFaults}
          faultsOf={diagnosis.of}
          editor={editor}
          changed={writing.edit}
          cursorMoved={(at, means) => setCursor({ line: at, word: means })}
          opened={seekLine}
        />
      </div>
      <Beside {...props} writing={writing} machine={machine} line={line} withPath={withPath} to={to} chosen={(at) => editor.current?.show(at)} />
      {isProgrammer && <SidePanel diagnosis={diagnosis} isFixable={mayWrite && diagnosis.of === text} editor={editor} line={line} />}
    </div>
  );
}

interface BesideProps extends WritingProps {
  writing: WritingState;
  machine: string;
  line: number;
  withPath: boolean;
  to: string | null; // what it is translated for; null: it is not
  chosen: (line: number) => void;
}

const Beside = ({ program, query, isProgrammer, writing, machine, line, withPath, to, chosen }: BesideProps) => (
  <>
    {withPath && (
      <PathPanel
        program={program}
        revision={writing.base}
        written={writing.isChanged && isProgrammer ? writing.text : null}
        machine={machine}
        line={line}
        chosen={chosen}
      />
    )}
    {to !== null && (
      <TranslationPanel
        program={program}
        text={writing.text}
        machine={machine}
        to={to}
        mode={query.get('mode') === 'explicit' ? 'explicit' : 'macro'}
        line={line}
        mayKeep={isProgrammer}
        chosen={chosen}
      />
    )}
  </>
);

interface BarProps {
  program: Program;
  writing: WritingState;
  editor: RefObject<Editor | null>;
  line: number;
  withPath: boolean;
  withTranslation: boolean;
  machine: string | null; // null: it is not chosen here
}

const WritingBar = ({ program, writing, editor, line, withPath, withTranslation, machine }: BarProps) => (
  <div class="writing-bar">
    <SaveButtons program={program} writing={writing} />
    <button type="button" class="button" onClick={() => editor.current?.find()}>
      {t('text.find')}
    </button>
    <button type="button" class="button" aria-pressed={withPath} onClick={() => changeQuery('path', withPath ? null : '1')}>
      {t('path.title')}
    </button>
    {machine !== null && (
      <button type="button" class="button" aria-pressed={withTranslation} onClick={() => changeQuery('to', withTranslation ? null : '?')}>
        {t('translation.title')}
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

const kNoFaults: never[] = [];

function Notices({ program, isOld, writing }: { program: Program; isOld: boolean; writing: WritingState }) {
  const { stored, base, restoredAt, isBehind, discard, rebase } = writing;
  return (
    <>
      {isOld && (
        <p class="notice tone-waiting">
          {t('text.old', { revision: base, newest: program.revision })} <a href={hrefs.program(program.id)}>{t('text.to_newest')}</a>{' '}
          <a href={hrefs.program(program.id, 'compare', { revision: String(base), with_revision: String(program.revision) })}>{t('text.compare')}</a>
        </p>
      )}
      {stored.isLatin1 && <p class="notice tone-waiting">{t('text.latin1')}</p>}
      {stored.isMixed && <p class="notice tone-waiting">{t('text.mixed')}</p>}
      {isBehind && (
        <div class="notice tone-bad conflict" role="alert">
          <p>
            <strong>{t('text.conflict', { revision: program.revision, name: program.created_by, base })}</strong> {t('text.conflict_kept')}
          </p>
          <div class="dialog-buttons">
            <a class="button" target="_blank" rel="noreferrer" href={hrefs.program(program.id, 'compare', { revision: String(base), with_revision: String(program.revision) })}>
              {t('text.conflict_look', { base, revision: program.revision })}
            </a>
            <button type="button" class="button" onClick={() => void rebase()}>
              {t('text.conflict_mine', { revision: program.revision })}
            </button>
            <button type="button" class="button button-danger" onClick={discard}>
              {t('text.conflict_theirs', { revision: program.revision })}
            </button>
          </div>
        </div>
      )}
      {restoredAt !== null && !isBehind && (
        <p class="notice tone-active" role="status">
          {t('text.restored', { at: clockTime(restoredAt) })}{' '}
          <button type="button" class="button button-small" onClick={discard}>
            {t('text.discard')}
          </button>
        </p>
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

// The browser asks before the tab is closed. What is typed is kept all the same.
function useLeaving(isChanged: boolean): void {
  useEffect(() => {
    if (!isChanged) return;
    const ask = (event: BeforeUnloadEvent) => event.preventDefault();
    addEventListener('beforeunload', ask);
    return () => removeEventListener('beforeunload', ask);
  }, [isChanged]);
}

function useSaveKey(save: () => Promise<void>): void {
  const latest = useRef(save);
  latest.current = save;
  useEffect(() => {
    const press = (event: KeyboardEvent) => {
      if (event.key !== 's' || !(event.ctrlKey || event.metaKey) || event.altKey) return;
      event.preventDefault();
      void latest.current();
    };
    addEventListener('keydown', press);
    return () => removeEventListener('keydown', press);
  }, []);
}

// ?line=: goes there once the editor is open, and whenever another one is asked for.
function useLineOfQuery(wanted: string | null, editor: { current: Editor | null }): () => void {
  const seek = () => {
    const line = Number(wanted);
    if (line > 0) editor.current?.goTo(line);
  };
  useEffect(seek, [wanted]);
  return seek;
}
