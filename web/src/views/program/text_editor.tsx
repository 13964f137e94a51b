// The editor as a part of the page: loaded when a text is shown first. It holds the text; the page hears of changes.
import type { Ref } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import type { DialectWords, Fault } from '../../api/types';
import type { Editor } from '../../editor/editor';
import { spoken, t } from '../../i18n/i18n';
import { Failure } from '../../parts/failure';

interface Props {
  text: string; // where another one is given, the editor takes it
  label: string;
  readOnly: boolean;
  words: DialectWords | null;
  isSure: boolean; // the words are of the control that the text is for
  faults: readonly Fault[];
  faultsOf: string; // the text that they are of
  editor: Ref<Editor>;
  changed: (text: string) => void;
  cursorMoved: (line: number, word: string, byPerson: boolean) => void;
  opened: () => void;
}

// The editor's own words that this page shows, by their English ones.
const kPhrases: Record<string, string> = {
  Find: 'editor.find',
  Replace: 'editor.replace',
  next: 'editor.next',
  previous: 'editor.previous',
  all: 'editor.all',
  'match case': 'editor.match_case',
  'by word': 'editor.by_word',
  regexp: 'editor.regexp',
  replace: 'editor.replace_one',
  'replace all': 'editor.replace_all',
  close: 'editor.close',
  'current match': 'editor.current_match',
  'on line': 'editor.on_line',
  'replaced match on line $': 'editor.replaced_on_line',
  'replaced $ matches': 'editor.replaced_matches',
  'Go to line': 'editor.go_to_line',
  go: 'editor.go',
  Diagnostics: 'editor.diagnostics',
  'No diagnostics': 'editor.no_diagnostics',
};

function phrases(): Record<string, string> {
  return Object.fromEntries(Object.entries(kPhrases).map(([english, id]) => [english, t(id)]));
}

const kFaultWords = {
  alarm: (name: string) => t('fault.alarm', { alarm: name }),
  fix: (text: string) => (text === '' ? t('fault.remove') : t('fault.write', { text })),
  note: (line: number, text: string) => t('fault.note', { line, text }),
};

export function TextEditor(props: Props) {
  const host = useRef<HTMLDivElement>(null);
  const editor = useRef<Editor | null>(null);
  const now = useRef(props);
  now.current = props;
  // What was typed and has not come back as `text` yet. Keys are quicker than the page: an echo of an earlier one must not
  // become the text again.
  const echoes = useRef<string[]>([]);
  const [error, setError] = useState<unknown>(null);
  const [open, setOpen] = useState(false);
  const give = (to: Editor | null) => {
    editor.current = to;
    if (typeof props.editor === 'function') props.editor(to);
    else if (props.editor) props.editor.current = to;
  };
  const changed = (to: string) => {
    echoes.current.push(to);
    now.current.changed(to);
  };
  useEffect(() => {
    let over = false;
    import('../../editor/editor').then(({ openEditor }) => {
      if (over || !host.current) return;
      const { text, label, readOnly } = now.current;
      const options = { text, label, readOnly, phrases: phrases(), faultWords: kFaultWords };
      give(openEditor(host.current, { ...options, changed, cursorMoved: (...moved) => now.current.cursorMoved(...moved) }));
      setOpen(true);
    }, setError);
    return () => {
      over = true;
      editor.current?.close();
      give(null);
      setOpen(false);
    };
  }, [spoken.value.tag]);
  useEffect(() => {
    const echo = echoes.current.indexOf(props.text);
    if (echo >= 0) echoes.current.splice(0, echo + 1);
    else if (editor.current) {
      editor.current.setText(props.text);
      echoes.current = [];
    }
  }, [open, props.text]);
  useEffect(() => editor.current?.setReadOnly(props.readOnly), [open, props.readOnly]);
  useEffect(() => void (props.words && editor.current?.setWords(props.words, props.isSure)), [open, props.words, props.isSure]);
  useEffect(() => editor.current?.setFaults(props.faults, props.faultsOf), [open, props.faults, props.faultsOf]);
  useEffect(() => {
    if (open) props.opened();
  }, [open]);
  return (
    <>
      <Failure error={error} />
      <div ref={host} class="editor" data-open={open} />
    </>
  );
}
