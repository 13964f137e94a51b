// The text of a program in CodeMirror. It stands in a shadow root: there its styles are constructed sheets, which the
// page's policy allows, and none of them touches the page. It asks the server for nothing.
import { defaultKeymap, history, historyKeymap, isolateHistory } from '@codemirror/commands';
import { lintGutter, lintKeymap, nextDiagnostic, setDiagnostics, type Diagnostic } from '@codemirror/lint';
import { highlightSelectionMatches, openSearchPanel, search, searchKeymap } from '@codemirror/search';
import { Compartment, EditorSelection, EditorState } from '@codemirror/state';
import { drawSelection, getDialog, EditorView, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers } from '@codemirror/view';
import type { DialectWords, Fault } from '../api/types';
import { columnOffset } from '../rules/program_files';

import { lineChanges } from './changes';
import { coloring, setWords, wordAt } from './colors';
import { look } from './theme';
import { Words } from './words';

export interface EditorOptions {
  text: string; // line ends as LF
  label: string;
  readOnly: boolean;
  phrases: Record<string, string>; // the editor's own words in the language of the page
  faultWords: { alarm: (name: string) => string; fix: (text: string) => string; note: (line: number, text: string) => string };
  changed: (text: string) => void;
  // And what the word there means, '' where nothing is known of it; and whether a person moved it, or the page did.
  cursorMoved: (line: number, word: string, byPerson: boolean) => void;
}

export interface Editor {
  text: () => string;
  setText: (text: string) => void;
  // The text of `of` becomes `to`, as one step that can be undone; false: it is another text by now.
  rewrite: (to: string, of: string) => boolean;
  setReadOnly: (readOnly: boolean) => void;
  setWords: (words: DialectWords, isSure: boolean) => void; // isSure: of the control that the text is for
  // Of the text as it stood when it was asked about; null where it has changed since.
  setFaults: (faults: readonly Fault[], of: string) => void;
  goTo: (line: number) => void;
  show: (line: number) => void; // as goTo, and the keyboard stays where it is
  find: () => void;
  nextFault: () => void;
  applyFix: (fault: Fault) => void;
  close: () => void;
}

type Place = Pick<Fault, 'line' | 'column_chars' | 'end_line' | 'end_column_chars'>;

function rangeOf(state: EditorState, place: Place): { from: number; to: number } {
  const at = (number: number, column: number): number => {
    const line = state.doc.line(Math.min(Math.max(number, 1), state.doc.lines));
    return line.from + Math.min(columnOffset(line.text, column), line.length);
  };
  const from = at(place.line, place.column_chars);
  return { from, to: Math.max(from, at(place.end_line, place.end_column_chars)) };
}

const kSeverities = { error: 'error', warning: 'warning', note: 'info' } as const;

function textOfFault(fault: Fault, words: EditorOptions['faultWords']): Node {
  const dom = document.createElement('div');
  dom.append(fault.text);
  const line = (name: string, text: string) => {
    const one = dom.appendChild(document.createElement('span'));
    one.className = name;
    one.textContent = text;
  };
  if (fault.alarm) line('fault-alarm', words.alarm(fault.alarm));
  line('fault-help', fault.help);
  for (const note of fault.notes) line('fault-note', words.note(note.line, note.text));
  return dom;
}

function applyFix(view: EditorView, fault: Fault): void {
  if (!fault.fix) return;
  const { from, to } = rangeOf(view.state, fault.fix);
  view.dispatch({ changes: { from, to, insert: fault.fix.text }, selection: EditorSelection.cursor(from + fault.fix.text.length), userEvent: 'input.fix', scrollIntoView: true });
  view.focus();
}

function diagnosticOf(state: EditorState, fault: Fault, words: EditorOptions['faultWords']): Diagnostic {
  const base = { ...rangeOf(state, fault), severity: kSeverities[fault.severity], message: fault.text, renderMessage: () => textOfFault(fault, words) };
  if (!fault.fix) return base;
  return { ...base, actions: [{ name: words.fix(fault.fix.text), apply: (view) => applyFix(view, fault) }] };
}

// The gutter shows marks alone; a diagnostic's text is its tooltip's, and the page's list of faults has it, too.
// A text of 100,000 lines is joined once for each change, however many ask for it.
function joined(): (doc: EditorState['doc']) => string {
  let last: { doc: EditorState['doc']; text: string } | null = null;
  return (doc) => {
    if (last?.doc !== doc) last = { doc, text: doc.toString() };
    return last.text;
  };
}

export function openEditor(host: HTMLElement, options: EditorOptions): Editor {
  const textOf = joined();
  const root = host.shadowRoot ?? host.attachShadow({ mode: 'open' });
  const writable = new Compartment();
  const readOnly = (is: boolean) => [EditorState.readOnly.of(is), EditorView.editable.of(!is)];
  const listener = EditorView.updateListener.of((update) => {
    if (update.docChanged) options.changed(textOf(update.state.doc));
    if (update.selectionSet || update.docChanged) {
      const { head } = update.state.selection.main;
      const word = wordAt(update.view, head)?.word;
      const byPerson = update.transactions.some((one) => one.isUserEvent('select'));
      options.cursorMoved(update.state.doc.lineAt(head).number, word ? `${word.word}: ${word.about}` : '', byPerson);
    }
  });
  // The field for a line number gives the keyboard back only outside of a shadow root: what closes it does so here.
  let asksForLine = false;
  const afterLine = EditorView.updateListener.of(({ view: of }) => {
    const asks = getDialog(of, 'cm-goto-line') !== null;
    if (asksForLine && !asks && root.activeElement === null) of.focus();
    asksForLine = asks;
  });
  const view = new EditorView({
    root,
    parent: root,
    state: EditorState.create({
      doc: options.text,
      extensions: [
        lineNumbers(),
        lintGutter(),
        highlightActiveLine(),
        highlightActiveLineGutter(),
        drawSelection(),
        history(),
        search({ top: true }),
        highlightSelectionMatches(),
        coloring,
        look,
        keymap.of([...searchKeymap, ...historyKeymap, ...lintKeymap, ...defaultKeymap]),
        EditorState.phrases.of(options.phrases),
        // The keyboard reaches a text that is only read, too, and scrolls it.
        EditorView.contentAttributes.of({ tabindex: '0', 'aria-label': options.label, spellcheck: 'false', autocapitalize: 'off', autocorrect: 'off' }),
        writable.of(readOnly(options.readOnly)),
        listener,
        afterLine,
      ],
    }),
  });
  const show = (number: number) => {
    const line = view.state.doc.line(Math.min(Math.max(number, 1), view.state.doc.lines));
    view.dispatch({ selection: EditorSelection.cursor(line.from), effects: EditorView.scrollIntoView(line.from, { y: 'center' }) });
  };
  return {
    text: () => textOf(view.state.doc),
    setText: (text) => {
      if (text !== textOf(view.state.doc)) view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } });
    },
    rewrite: (to, of) => {
      if (of !== textOf(view.state.doc)) return false;
      view.dispatch({ changes: lineChanges(view.state.doc, to), annotations: isolateHistory.of('full'), userEvent: 'input.rewrite' });
      return true;
    },
    setReadOnly: (is) => view.dispatch({ effects: writable.reconfigure(readOnly(is)) }),
    setWords: (words, isSure) => view.dispatch({ effects: setWords.of(new Words(words, isSure)) }),
    setFaults: (faults, of) => {
      if (of === textOf(view.state.doc))
        view.dispatch(setDiagnostics(view.state, faults.map((fault) => diagnosticOf(view.state, fault, options.faultWords))));
    },
    show,
    goTo: (number) => {
      show(number);
      view.focus();
    },
    find: () => openSearchPanel(view),
    nextFault: () => void nextDiagnostic(view),
    applyFix: (fault) => applyFix(view, fault),
    close: () => view.destroy(),
  };
}
