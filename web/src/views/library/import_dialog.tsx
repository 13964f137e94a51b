// A folder with programs, as it becomes a part of the library. A person sees what would become of each file first.
import { useEffect, useRef, useState } from 'preact/hooks';
import type { ImportRow } from '../../api/types';
import { localText } from '../../format/local_text';
import { dialectText, type Wording } from '../../format/words';
import type { Tone } from '../../format/tones';
import { t, wordOf } from '../../i18n/i18n';
import { Badge } from '../../parts/badge';
import { BackButton, Dialog } from '../../parts/dialog';
import { Failure } from '../../parts/failure';
import { Table, type Column } from '../../parts/table';
import { loader } from '../../state/loader';
import { importFiles, kOutcomes, type Imported } from './importing';

const kShownRows = 500; // of a table; what failed comes first

type Outcome = ImportRow['outcome'];
const kTones: Record<Outcome, Tone> = { added: 'good', revised: 'active', same: 'quiet', skipped: 'waiting', failed: 'bad' };
const importWording = (outcome: Outcome): Wording => ({ text: wordOf('import_outcome', outcome), tone: kTones[outcome] });

interface Props {
  files: readonly File[];
  folder: string;
  changed: () => void;
}

type Step = 'looking' | 'looked' | 'sending' | 'done';

export function ImportDialog({ files, folder, changed }: Props) {
  const [plan, setPlan] = useState({ folder, known: 'revise' as 'revise' | 'skip' });
  const [step, setStep] = useState<Step>('looking');
  const [isOld, setOld] = useState(false); // the rows belong to another plan
  const [done, setDone] = useState(0);
  const [found, setFound] = useState<Imported | null>(null);
  const [error, setError] = useState<unknown>(null);
  const isOpen = useRef(true);
  const run = async (onlyLook: boolean) => {
    setStep(onlyLook ? 'looking' : 'sending');
    setError(null);
    const passed = (count: number) => {
      setDone(count);
      return isOpen.current;
    };
    try {
      setFound(await loader.order(importFiles(files, { ...plan, folder: plan.folder.trim(), onlyLook }, passed)));
      setOld(false);
      setStep(onlyLook ? 'looked' : 'done');
    } catch (failure) {
      setError(failure);
      setOld(true);
      setStep('looked');
    }
    if (!onlyLook) changed();
  };
  useEffect(() => {
    void run(true);
    return () => {
      isOpen.current = false;
    };
  }, []);
  const change = (by: Partial<typeof plan>) => {
    setPlan((before) => ({ ...before, ...by }));
    setOld(true);
  };
  const busy = step === 'looking' || step === 'sending';
  const count = found && !isOld ? found.sums.added + found.sums.revised : 0;
  const send = (event: Event) => {
    event.preventDefault();
    if (!busy) void run(isOld);
  };
  return (
    <Dialog title={t('import.title', { count: files.length })} wide>
      <form onSubmit={send} class="upload">
        <p class="hint">{t('import.hint')}</p>
        <fieldset class="upload-fields" disabled={busy || step === 'done'}>
          <label class="field">
            <span>{t('import.under')}</span>
            <input value={plan.folder} onInput={(event) => change({ folder: event.currentTarget.value })} placeholder={t('labels.folder_example')} autocomplete="off" />
          </label>
          <label class="field">
            <span>{t('import.known')}</span>
            <select value={plan.known} onChange={(event) => change({ known: event.currentTarget.value === 'skip' ? 'skip' : 'revise' })}>
              <option value="revise">{t('import.known_revise')}</option>
              <option value="skip">{t('import.known_skip')}</option>
            </select>
          </label>
        </fieldset>
        <Failure error={error} />
        {busy && <p role="status">{t(step === 'looking' ? 'import.looking' : 'import.sending', { done: done + 1, count: files.length })}</p>}
        {step === 'done' && <p role="status">{t('import.done')}</p>}
        {found && !busy && !isOld && <Found found={found} />}
        <div class="dialog-buttons">
          <BackButton />
          {!busy && isOld && (
            <button type="submit" class="button button-main">
              {t('import.look')}
            </button>
          )}
          {step === 'looked' && !isOld && (
            <button type="submit" class="button button-main" disabled={count === 0}>
              {count === 0 ? t('import.nothing') : t('import.send', { count })}
            </button>
          )}
        </div>
      </form>
    </Dialog>
  );
}

const columns: readonly Column<ImportRow>[] = [
  { id: 'outcome', head: t('column.state'), cell: (row) => <Badge wording={importWording(row.outcome)} /> },
  { id: 'file', head: t('column.file'), cell: (row) => row.file },
  { id: 'becomes', head: t('column.program'), cell: (row) => <Becomes row={row} /> },
  { id: 'dialect', head: t('column.dialect'), cell: (row) => (row.dialect === null ? '–' : dialectText(row.dialect)) },
];

const Becomes = ({ row }: { row: ImportRow }) => (
  <>
    {[row.folder, row.name].filter((one) => one !== null).join('/')}
    {row.why !== null && <span class="quiet-text"> {localText(row.why_said, row.why)}</span>}
  </>
);

function Found({ found: { rows, sums } }: { found: Imported }) {
  return (
    <>
      <p class="import-sums">
        {kOutcomes.filter((outcome) => sums[outcome] > 0).map((outcome) => (
          <span key={outcome}>
            {sums[outcome]} {importWording(outcome).text}
          </span>
        ))}
      </p>
      <Table label={t('import.rows')} columns={columns} rows={rows.slice(0, kShownRows)} keyOf={(row) => `${row.file} ${row.folder ?? ''} ${row.name ?? ''}`} />
      {rows.length > kShownRows && <p class="quiet-text">{t('import.more', { count: rows.length - kShownRows })}</p>}
    </>
  );
}
