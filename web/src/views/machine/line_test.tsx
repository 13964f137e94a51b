// The test of a line: asked for by a person who put a loopback plug in the control's place, and what it measured.
import { calls } from '../../api/calls';
import type { LineTest, LineTestResult } from '../../api/types';
import { count } from '../../format/numbers';
import { t, wordOf } from '../../i18n/i18n';
import { OrderDialog } from '../../parts/dialog';
import { Facts } from '../../parts/facts';
import { coreOfMachine } from '../../state/shop';

// Why it cannot be tested now, or null.
function blockedBecause(name: string): string | null {
  const core = coreOfMachine(name);
  if (!core) return t('because.no_machine', { machine: name });
  if (core.needs_confirmation) return t('because.torn');
  if (core.line !== 'idle' && core.line !== 'disconnected') return t('line_test.busy');
  return core.asks_since_ms === null ? null : t('line_test.asks');
}

export const LineTestDialog = ({ name, done }: { name: string; done: (test: LineTest) => void }) => (
  <OrderDialog
    title={t('line_test.title', { machine: name })}
    confirm={t('line_test.confirm')}
    blocked={blockedBecause(name)}
    send={async (key) => done(await calls.testLine(name, key))}
  >
    <ol class="steps">
      <li>{t('line_test.step_plug')}</li>
      <li>{t('line_test.step_test')}</li>
      <li>{t('line_test.step_back')}</li>
    </ol>
    <p class="hint">{t('line_test.hint')}</p>
  </OrderDialog>
);

export const LineTestShown = ({ test }: { test: LineTest }) => (
  <section class="line-test" aria-label={t('line_test.result')}>
    <h3>{t('line_test.result')}</h3>
    {test.result ? (
      <Measured result={test.result} />
    ) : (
      <div class="notice tone-bad" role="alert">
        <p>{wordOf('line_test_fault', test.fault_id ?? '', test.fault ?? '')}</p>
        {test.fault && <p class="quiet-text">{test.fault}</p>}
      </div>
    )}
  </section>
);

const ms = (value: number): string => `${value.toFixed(2)}\u202Fms`;

const Measured = ({ result }: { result: LineTestResult }) => (
  <>
    <p class={`notice tone-${result.kept ? 'good' : 'bad'}`} role="status">
      {t(result.kept ? 'line_test.kept' : 'line_test.not_kept', { budget: result.budget.overrun })}
    </p>
    {result.latency_chars > result.budget.latency_chars && <p class="notice tone-waiting">{t('line_test.latency_more', { chars: result.latency_chars })}</p>}
    <Facts
      facts={[
        [t('line_test.char_ms'), ms(result.char_ms)],
        [t('line_test.latency'), t('line_test.median_worst', { median: ms(result.latency_ms.median), worst: ms(result.latency_ms.worst) })],
        [t('line_test.after_dc3'), t('line_test.median_worst_of', { median: result.after_dc3.median, worst: result.after_dc3.worst, holds: result.after_dc3.holds })],
        [t('line_test.characters'), t('line_test.wrong_of', { wrong: count(result.wrong), characters: count(result.characters) })],
      ]}
    />
  </>
);
