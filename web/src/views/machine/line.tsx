// A machine's line: how it is set, what it counted of faults, a look at what passes, and its test.
import { useState } from 'preact/hooks';
import type { LineTest, MachineWhole } from '../../api/types';
import { count } from '../../format/numbers';
import { localText } from '../../format/local_text';
import { settingText, settingValue } from '../../format/settings';
import { t, wordOf } from '../../i18n/i18n';
import { showDialog } from '../../parts/dialog';
import { Empty } from '../../parts/empty';
import { Facts } from '../../parts/facts';
import { lazyView } from '../../parts/lazy';
import { atLeast } from '../../rules/roles';
import { changeQuery, route } from '../../router';
import { isLive, roleOn, type Machine } from '../../state/shop';

const WireTerminal = lazyView(() => import('./wire_terminal').then((file) => file.WireTerminal));
const TestDialog = lazyView(() => import('./line_test').then((file) => file.LineTestDialog));
const TestResult = lazyView(() => import('./line_test').then((file) => file.LineTestShown));

// Links that carry single characters: what passes on others is not a stream of them.
const kCharacters = /^(?:serial|tcp|tcp-listen|rfc2217|pty|com):/;

export function LinePart({ machine, whole }: { machine: Machine; whole: MachineWhole | null }) {
  const [tested, setTested] = useState<LineTest | null>(null);
  const status = machine.status.value;
  const link = (whole?.profile.link ?? {}) as Record<string, unknown>;
  const errors = Object.entries(status.line_errors).filter(([, seen]) => seen > 0);
  const carries = kCharacters.test(machine.head.value.link);
  const isOpen = route.value.query.get('wire') === '1';
  return (
    <section class="card line-part" aria-label={t('line.title')}>
      <h2>{t('line.title')}</h2>
      {status.link_error && <p class="notice tone-bad">{localText(status.link_error_said, status.link_error)}</p>}
      {status.link_note && <p class="notice tone-waiting">{status.link_note}</p>}
      <Facts
        facts={[
          ...Object.entries(link)
            .filter(([, value]) => typeof value !== 'object')
            .map(([name, value]): [string, string] => [settingText(name), settingValue(name, value)]),
          [t('fact.revision'), machine.head.value.revision],
          [t('line.errors'), errors.length === 0 ? null : errors.map(([name, seen]) => `${count(seen)} × ${wordOf('line_error', name)}`).join(', ')],
        ]}
      />
      {whole === null && <Empty>{t('line.unknown')}</Empty>}
      {carries && (
        <div class="line-buttons">
          <button type="button" class="button" aria-expanded={isOpen} onClick={() => changeQuery('wire', isOpen ? null : '1')}>
            {t(isOpen ? 'terminal.close' : 'terminal.open')}
          </button>
          {atLeast(roleOn(machine.name), 'operator') && isLive.value && (
            <button type="button" class="button" onClick={() => showDialog(<TestDialog name={machine.name} done={setTested} />)}>
              {t('line_test.open')}
            </button>
          )}
        </div>
      )}
      {tested && <TestResult test={tested} />}
      {carries && isOpen && <WireTerminal name={machine.name} />}
    </section>
  );
}
