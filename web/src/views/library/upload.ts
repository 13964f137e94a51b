// Files of a person's disk that are uploaded into the library: what each would become, and the sending, one after the other.
import { deskCalls } from '../../api/desk_calls';
import { newOrderKey } from '../../api/client';
import type { Program, SplitProgram } from '../../api/types';
import { decodeProgram, nameOfFile } from '../../rules/program_files';

const kHead_chars = 64 * 1024; // enough to see which dialect a text is in

export type UploadState = 'waiting' | 'sending' | 'done' | 'failed';

export interface Upload {
  file: string;
  bytes: number;
  text: string;
  isLatin1: boolean;
  parts: readonly SplitProgram[]; // the programs that it holds, where they are several
  key: string; // of the order: a repeated one does nothing twice
  name: string;
  dialect: string; // '' : not chosen yet
  same: readonly Program[]; // programs of this name
  revise: number | null; // the one of them that gets a new revision; null: a new program
  state: UploadState;
  error: unknown;
  program: Program | null; // what it became
}

export async function readUpload(file: File): Promise<Upload> {
  const { text, encoding } = decodeProgram(await file.arrayBuffer());
  const name = nameOfFile(file.name);
  const [same, dialect, parts] = await Promise.all([sameName(name), dialectOf(text), partsOf(text)]);
  return {
    file: file.name,
    bytes: file.size,
    text,
    isLatin1: encoding === 'latin-1',
    parts,
    key: newOrderKey(),
    name,
    dialect: same[0]?.dialect ?? dialect,
    same,
    revise: same[0]?.id ?? null,
    state: 'waiting',
    error: null,
    program: null,
  };
}

// The server's word on it; where it has none a person chooses.
const dialectOf = (text: string): Promise<string> =>
  deskCalls.diagnose({ text: text.slice(0, kHead_chars) }).then(
    ({ dialect }) => dialect,
    () => '',
  );

// Of a file that the server does not take apart, what is wrong with it is stated when it is sent.
const partsOf = (text: string): Promise<SplitProgram[]> =>
  deskCalls.split(text).then(
    (parts) => (parts.length > 1 ? parts : []),
    () => [],
  );

// Each program of a file by itself; they are looked up one after the other, as there may be hundreds.
export async function apart(upload: Upload): Promise<Upload[]> {
  const all: Upload[] = [];
  for (const [i, { name: given, text }] of upload.parts.entries()) {
    const name = given ?? `${upload.name} ${i + 1}`;
    const same = await sameName(name);
    const bytes = new TextEncoder().encode(text).length;
    all.push({ ...upload, bytes, text, parts: [], key: newOrderKey(), name, dialect: same[0]?.dialect ?? upload.dialect, same, revise: same[0]?.id ?? null });
  }
  return all;
}

export const sameName = (name: string): Promise<Program[]> => (name === '' ? Promise.resolve([]) : deskCalls.programsNamed(name));

export async function sendUpload(upload: Upload, folder: string): Promise<Program> {
  const base = upload.same.find((program) => program.id === upload.revise);
  if (base) return deskCalls.addRevision(base.id, base.revision, upload.text, upload.key);
  const program = await deskCalls.addProgram(upload.name, upload.dialect, upload.text, upload.key);
  return folder === '' ? program : deskCalls.label(program.id, { folder });
}
