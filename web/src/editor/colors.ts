// Colors of the lines that are on the screen, and what a word means where a pointer rests on it or the cursor stands.
import { StateEffect, StateField, type Extension, type Range } from '@codemirror/state';
import { Decoration, EditorView, hoverTooltip, ViewPlugin, type DecorationSet, type ViewUpdate } from '@codemirror/view';
import { tokensOf, type Token } from './tokens';
import type { Words } from './words';

const kLongest = 2000; // a line beyond it has no colors

export const setWords = StateEffect.define<Words | null>();

const wordsField = StateField.define<Words | null>({
  create: () => null,
  update: (value, transaction) => transaction.effects.reduce((now, effect) => (effect.is(setWords) ? effect.value : now), value),
});

function colorsOf(view: EditorView): DecorationSet {
  const words = view.state.field(wordsField);
  if (!words) return Decoration.none;
  const marks: Range<Decoration>[] = [];
  for (const { from, to } of view.visibleRanges) {
    for (let at = from; at <= to; ) {
      const line = view.state.doc.lineAt(at);
      if (line.length <= kLongest)
        for (const token of tokensOf(line.text, words)) marks.push(Decoration.mark({ class: `nc-${token.sort}` }).range(line.from + token.from, line.from + token.to));
      at = line.to + 1;
    }
  }
  return Decoration.set(marks);
}

const hasNewWords = (update: ViewUpdate): boolean => update.startState.field(wordsField) !== update.state.field(wordsField);

const colors = ViewPlugin.fromClass(
  class {
    decorations: DecorationSet;
    constructor(view: EditorView) {
      this.decorations = colorsOf(view);
    }
    update(update: ViewUpdate) {
      if (update.docChanged || update.viewportChanged || hasNewWords(update)) this.decorations = colorsOf(update.view);
    }
  },
  { decorations: (plugin) => plugin.decorations },
);

// The piece at an offset, where the dialect says something of it.
export function wordAt(view: EditorView, at: number): (Token & { start: number }) | null {
  const words = view.state.field(wordsField);
  const line = view.state.doc.lineAt(at);
  if (!words?.isSure || line.length > kLongest) return null;
  const column = at - line.from;
  const found = tokensOf(line.text, words).find((token) => token.from <= column && column < token.to);
  return found?.word ? { ...found, start: line.from } : null;
}

const help = hoverTooltip((view, at) => {
  const found = wordAt(view, at);
  if (!found?.word) return null;
  const { word, reference, about } = found.word;
  return {
    pos: found.start + found.from,
    end: found.start + found.to,
    create: () => {
      const dom = document.createElement('div');
      dom.className = 'nc-help';
      const head = dom.appendChild(document.createElement('strong'));
      head.textContent = word;
      dom.append(` ${about}`);
      if (reference) {
        const source = dom.appendChild(document.createElement('small'));
        source.textContent = reference;
      }
      return { dom };
    },
  };
});

export const coloring: Extension = [wordsField, colors, help];
