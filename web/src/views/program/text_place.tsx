// The text: read by every person, written by programmers. What the server finds in it stands in the margin and in the list
// next to it; a save is the next revision, and never overwrites one that another person made meanwhile.
import { useEffect, useRef, useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Program } from '../../api/types';
import type { Editor } from '../../editor/editor';
import { bytes } from '../../format/numbers';
import { clockTime } from '../../format/times';
import { t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';
import { useLeaving } from '../../parts/use_leaving';
import { useLoaded } from '../../parts/use_loaded';
import { hrefs } from '../../router';
import { person } from '../../state/shop';
import { FiguresPanel } from './figures_panel';
import { PathPanel } from './path_panel';
import { TranslationPanel } from './translation_panel';
import type { PlaceProps } from './program_view';
import { SidePanel } from './side_panel';
import { TextEditor } from './text_editor';
import { useDiagnosis } from './use_diagnosis';
import { useDraft } from './use_draft';
import { storedOf, useWriting, type WritingProps, type WritingState } from './use_writing';
import { Download, WritingBar, type BesideText } from './writing_bar';

const kMost_bytes = 16 * 1024 * 1024; // a longer text is not shown here

export const TextPlace = (props: PlaceProps) =>
  props.program.bytes > kMost_bytes ? (
    <p class="notice tone-waiting">
      {t('text.too_large', { bytes: bytes(props.program.bytes) })} <Download program={props.program} revision={props.program.revision} />
    </p>
  ) : (
    <ShownText {...props} />
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
  const beside = besideOf(query, isProgrammer);
  return (
    <div class={isAnyBeside(beside) ? 'writing writing-beside' : 'writing'}>
      <div class="writing-main">
        <Notices program={program} isOld={props.isOld} writing={writing} />
        <Failure error={writing.error} />
        <WritingBar program={program} writing={writing} editor={editor} line={line} beside={beside} machine={isProgrammer ? machine : null} />
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
      <Beside {...props} writing={writing} machine={machine} line={line} beside={beside} chosen={(at) => editor.current?.show(at)} />
      {isProgrammer && <SidePanel diagnosis={diagnosis} isFixable={mayWrite && diagnosis.of === text} editor={editor} line={line} />}
    </div>
  );
}

const besideOf = (query: URLSearchParams, isProgrammer: boolean): BesideText => ({
  withPath: query.get('path') === '1',
  withFigures: isProgrammer && query.get('figures') === '1',
  to: isProgrammer ? query.get('to') : null,
});

const isAnyBeside = ({ withPath, withFigures, to }: BesideText): boolean => withPath || withFigures || to !== null;

interface BesideProps extends WritingProps {
  writing: WritingState;
  machine: string;
  line: number;
  beside: BesideText;
  chosen: (line: number) => void;
}

const Beside = ({ program, query, isProgrammer, writing, machine, line, beside: { withPath, withFigures, to }, chosen }: BesideProps) => (
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
    {withFigures && (
      <FiguresPanel
        program={program}
        base={writing.base}
        stored={writing.stored.text}
        written={writing.isChanged ? writing.text : null}
        machine={machine}
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
