// One of several, as a labelled field; the first may stand for all of them, or for none.
import { machines } from '../state/shop';

interface Props<Value extends string> {
  label: string;
  value: Value | '';
  options: readonly (readonly [value: Value, text: string])[];
  empty?: string; // what the choice of none of them is called; without it one of them is chosen
  change: (value: Value | '') => void;
}

export const Choice = <Value extends string>({ label, value, options, empty, change }: Props<Value>) => (
  <label class="field">
    <span>{label}</span>
    <select value={value} onChange={(event) => change(event.currentTarget.value as Value | '')}>
      {empty !== undefined && <option value="">{empty}</option>}
      {options.map(([one, text]) => (
        <option key={one} value={one}>
          {text}
        </option>
      ))}
    </select>
  </label>
);

export const MachineField = (props: Omit<Props<string>, 'options'>) => <Choice {...props} options={[...machines.value.keys()].map((one) => [one, one] as const)} />;
