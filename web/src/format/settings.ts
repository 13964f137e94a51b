// The settings of a line as words: the profile's member with its unit. One that no catalogue has is shown as it is
// called in the profile.
import { t, wordOf } from '../i18n/i18n';

const kUnits: Record<string, string> = {
  baud: 'bit/s',
  char_delay_ms: 'ms',
  line_delay_ms: 'ms',
  end_by_quiet_s: 's',
  answer_s: 's',
  arming_minutes: 'min',
};

export const settingText = (name: string): string => wordOf('setting', name, name);

export function settingValue(name: string, value: unknown): string {
  if (typeof value === 'boolean') return t(value ? 'setting_value.yes' : 'setting_value.no');
  const unit = kUnits[name];
  return unit ? `${String(value)}\u202F${unit}` : String(value);
}
