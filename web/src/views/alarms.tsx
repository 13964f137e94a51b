// What machines reported that asks for a look; each stays until a person puts it away.
import { clockTime } from '../format/times';
import { Icon } from './badge';
import { useDesk } from './context';

export function Alarms({ seen }: { seen: (key: number) => void }) {
  const { alarms } = useDesk().state;
  if (alarms.length === 0) return null;
  return (
    <ul class="alarms" aria-label="Alarms" aria-live="polite">
      {alarms.map((alarm) => (
        <li key={alarm.key} class="notice tone-waiting">
          <Icon tone="bad" />
          <span>
            {clockTime(alarm.at)} <strong>{alarm.machine}</strong>: {alarm.text}
          </span>
          <button type="button" class="button button-small" onClick={() => seen(alarm.key)}>
            Seen
          </button>
        </li>
      ))}
    </ul>
  );
}
