// Texts that are being written and not saved, kept in this browser: a reload, a crash or a lost session loses none. One
// a program and the revision that it began from, of the person who wrote it.
const kName = 'dripfeed';
const kStore = 'drafts';

export interface Draft {
  person: string;
  program: number;
  base: number; // the revision that it began from
  text: string; // line ends as LF
  atMs: number;
}

let opened: Promise<IDBDatabase> | null = null;

function open(): Promise<IDBDatabase> {
  opened ??= new Promise((resolve, reject) => {
    const request = indexedDB.open(kName, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(kStore, { keyPath: ['person', 'program', 'base'] });
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
  return opened;
}

async function inStore<T>(mode: IDBTransactionMode, act: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const database = await open();
  return new Promise((resolve, reject) => {
    const transaction = database.transaction(kStore, mode);
    const request = act(transaction.objectStore(kStore));
    transaction.oncomplete = () => resolve(request.result);
    transaction.onerror = () => reject(transaction.error);
    transaction.onabort = () => reject(transaction.error);
  });
}

export const keepDraft = (draft: Draft): Promise<unknown> => inStore('readwrite', (store) => store.put(draft));

export const dropDraft = ({ person, program, base }: Pick<Draft, 'person' | 'program' | 'base'>): Promise<unknown> =>
  inStore('readwrite', (store) => store.delete([person, program, base]));

// The newest one of a person for a program; null: there is none.
export async function draftOf(person: string, program: number): Promise<Draft | null> {
  const all: Draft[] = await inStore('readonly', (store) => store.getAll(IDBKeyRange.bound([person, program, 0], [person, program, Infinity])));
  return all.sort((a, b) => b.atMs - a.atMs)[0] ?? null;
}
