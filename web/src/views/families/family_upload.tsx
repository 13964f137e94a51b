// A family from a file: a new one, or after asking the next revision of the one that has its name.
import { useRef, useState } from 'preact/hooks';
import { newOrderKey } from '../../api/client';
import { deskCalls } from '../../api/desk_calls';
import type { FamilySummary } from '../../api/types';
import { t } from '../../i18n/i18n';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { Failure } from '../../parts/failure';
import { loader } from '../../state/loader';

export function FamilyUpload({ families, done }: { families: readonly FamilySummary[]; done: () => void }) {
  const input = useRef<HTMLInputElement>(null);
  const [error, setError] = useState<unknown>(null);
  const take = async (file: File) => {
    setError(null);
    const text = await file.text();
    const [, name] = /^[ \t]*family[ \t]+(\S+)/m.exec(text) ?? [];
    const known = families.find((one) => one.name === name);
    if (known) return askRevision(known, text, done);
    try {
      await loader.order(deskCalls.addFamily(text, newOrderKey()));
      done();
    } catch (failure) {
      setError(failure);
    }
  };
  return (
    <>
      <button type="button" class="button button-main" onClick={() => input.current?.click()}>
        {t('parts.upload_family')}
      </button>
      <input
        ref={input}
        type="file"
        hidden
        onChange={(event) => {
          const [file] = event.currentTarget.files ?? [];
          if (file) void take(file);
          event.currentTarget.value = '';
        }}
      />
      <Failure error={error} />
    </>
  );
}

function askRevision({ name, revision }: FamilySummary, text: string, done: () => void): void {
  showDialog(
    <OrderDialog
      title={t('parts.family_known', { name })}
      confirm={t('parts.save', { next: revision + 1 })}
      send={async (key) => {
        await deskCalls.changeFamily(name, revision, text, key);
        done();
      }}
    >
      <p>{t('parts.family_revised')}</p>
    </OrderDialog>,
  );
}
