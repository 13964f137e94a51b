// A text that is being written: what it began from, what is kept of it, and what a person may do with it.
import { useEffect, useState } from 'preact/hooks';
import { ApiError, newOrderKey } from '../../api/client';
import { deskCalls } from '../../api/desk_calls';
import { decodeProgram, lineEndOf, linesOf } from '../../rules/program_files';
import { loader } from '../../state/loader';
import type { PlaceProps } from './program_view';
import type { Drafting } from './use_draft';

export interface Stored {
  text: string; // line ends as LF
  lineEnd: string;
  isMixed: boolean; // several kinds of line ends: a save makes them one
  isLatin1: boolean;
}

export function storedOf(bytes: ArrayBuffer): Stored {
  const { text, encoding } = decodeProgram(bytes);
  const lineEnd = lineEndOf(text);
  return { text: linesOf(text).join('\n'), lineEnd: lineEnd ?? '\n', isMixed: lineEnd === null, isLatin1: encoding === 'latin-1' };
}

export interface WritingProps extends PlaceProps {
  base: number; // the revision that is shown, and that a save follows
  isOld: boolean; // an earlier one, to read
  stored: Stored;
  drafting: Drafting;
  moveTo: (base: number) => void;
}

export function useWriting(props: WritingProps) {
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

export type WritingState = ReturnType<typeof useWriting>;
