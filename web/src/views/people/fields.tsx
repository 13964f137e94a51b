// Fields that the forms about people share.
import type { Role } from '../../api/types';
import { t } from '../../i18n/i18n';
import { kRoles } from '../../rules/roles';

export const RoleField = ({ label, value, change }: { label: string; value: Role; change: (role: Role) => void }) => (
  <label class="field">
    <span>{label}</span>
    <select value={value} onChange={(event) => change(kRoles.find((one) => one === event.currentTarget.value) ?? 'viewer')}>
      {kRoles.map((role) => (
        <option key={role} value={role}>
          {t(`role.${role}`)}
        </option>
      ))}
    </select>
  </label>
);

interface TextProps {
  label: string;
  value: string;
  change: (value: string) => void;
  hint?: string;
  required?: boolean;
}

export const TextField = ({ label, value, change, hint, required = false }: TextProps) => (
  <label class="field">
    <span>{label}</span>
    <input type="text" autocomplete="off" spellcheck={false} maxLength={200} required={required} value={value} onInput={(event) => change(event.currentTarget.value)} />
    {hint && <small class="quiet-text">{hint}</small>}
  </label>
);

interface Choices {
  label: string;
  all: readonly string[];
  chosen: readonly string[];
  change: (chosen: string[]) => void;
  name?: (one: string) => string;
}

export const Choices = ({ label, all, chosen, change, name = (one) => one }: Choices) => (
  <fieldset class="field choices">
    <legend>{label}</legend>
    {all.map((one) => (
      <label key={one}>
        <input
          type="checkbox"
          checked={chosen.includes(one)}
          onChange={(event) => change(event.currentTarget.checked ? [...chosen, one] : chosen.filter((other) => other !== one))}
        />{' '}
        {name(one)}
      </label>
    ))}
  </fieldset>
);
