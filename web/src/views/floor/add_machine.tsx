// A machine from its profile, a JSON document that an administrator keeps as a file.
import { useState } from 'preact/hooks';
import { calls } from '../../api/calls';
import { t } from '../../i18n/i18n';
import { OrderDialog } from '../../parts/dialog';
import { loader } from '../../state/loader';

export function AddMachineDialog() {
  const [profile, setProfile] = useState<unknown>(null);
  const [problem, setProblem] = useState<string | null>(t('machine.no_file'));
  const take = async (file: File | undefined) => {
    if (!file) return;
    try {
      setProfile(JSON.parse(await file.text()));
      setProblem(null);
    } catch (error) {
      setProblem(t('machine.no_json', { text: error instanceof Error ? error.message : '' }));
    }
  };
  const send = async (key: string) => {
    const added = await calls.addMachine(profile, key);
    await loader.load();
    return added;
  };
  return (
    <OrderDialog title={t('machine.add')} confirm={t('machine.add_confirm')} blocked={problem} send={send}>
      <label class="field">
        <span>{t('machine.profile_file')}</span>
        <input type="file" accept=".json,application/json" onChange={(event) => void take(event.currentTarget.files?.[0])} />
      </label>
    </OrderDialog>
  );
}
