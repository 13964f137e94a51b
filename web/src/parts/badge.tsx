// A state as icon and word in the colour of its tone: the colour alone never says anything.
import type { Wording } from '../format/words';
import { t } from '../i18n/i18n';
import { Icon } from './icon';

// `old`: the connection is lost, this was the last that was heard.
export const Badge = ({ wording, old = false }: { wording: Wording; old?: boolean }) => (
  <span class={`badge tone-${wording.tone}`}>
    <Icon shape={wording.tone} />
    <span class="badge-text">{old ? t('state.last_known', { state: wording.text }) : wording.text}</span>
  </span>
);
