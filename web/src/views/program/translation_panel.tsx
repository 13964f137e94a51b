// The text in another control's language, beside it: what the server translates, whether both were run and move the
// same, and what it refuses. The cursor's line is shown on both sides. Nothing is stored before a person keeps it.
import { useEffect, useRef, useState } from 'preact/hooks';
import { deskCalls } from '../../api/desk_calls';
import type { Converted, ConvertMode, Program } from '../../api/types';
import type { Editor } from '../../editor/editor';
import { dialectText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { Badge } from '../../parts/badge';
import { OrderDialog, showDialog } from '../../parts/dialog';
import { Failure } from '../../parts/failure';
import { useLoaded } from '../../parts/use_loaded';
import { Older } from '../../parts/older';
import { useAsked } from '../../parts/use_asked';
import { useNumberOf } from '../../parts/use_number_of';
import { changeQuery, goUnlessLeft, hrefs } from '../../router';
import { kDialects } from '../../rules/dialects';
import { lineFrom, originOf, sideOf, standingOf } from '../../rules/translations';
import { machines } from '../../state/shop';
import { TextEditor } from './text_editor';

interface Props {
  program: Program;
  text: string;
  machine: string; // whose control the text is for; '': the control that it looks like
  to: string;
  mode: ConvertMode;
  line: number;
  mayKeep: boolean;
  chosen: (line: number) => void;
}

const kPause_ms = 800;
const kNoFaults: never[] = [];

export function TranslationPanel(props: Props) {
  const { program, machine, to, mode } = props;
  const { text, isOlder, askNow } = useAsked(props.text, kPause_ms);
  const number = useNumberOf(text);
  const side = sideOf(to);
  const key = side && `${program.id} ${machine} ${to} ${mode} ${number}`;
  const { value, error, loading } = useLoaded<Converted>(key, () =>
    deskCalls.convert({ text, dialect: program.dialect, mode, ...(machine ? { machine } : {}), ...side }),
  );
  return (
    <section class="translation" aria-label={t('translation.title')} aria-busy={loading}>
      <h2>{t('translation.title')}</h2>
      <Choices dialect={program.dialect} to={to} mode={mode} />
      <Failure error={error} />
      {isOlder && side && <Older what={t('translation.older')} askNow={askNow} />}
      {(loading || (isOlder && !askNow)) && side && (
        <p class="hint" role="status">
          {t('translation.running')}
        </p>
      )}
      {!side && <p class="hint">{t('translation.choose')}</p>}
      {value && <Shown {...props} converted={value} isOlder={isOlder} />}
    </section>
  );
}

function Choices({ dialect, to, mode }: { dialect: string; to: string; mode: ConvertMode }) {
  const all = [...machines.value.values()];
  return (
    <div class="writing-bar">
      <label class="choice">
        <span>{t('translation.to')}</span>
        <select value={to} onChange={(event) => changeQuery('to', event.currentTarget.value || '?')}>
          <option value="?" />
          <optgroup label={t('translation.machines')}>
            {all.map(({ name, head }) => (
              <option key={name} value={`machine:${name}`}>
                {name} ({dialectText(head.value.dialect)})
              </option>
            ))}
          </optgroup>
          <optgroup label={t('translation.controls')}>
            {kDialects
              .filter((one) => one !== dialect)
              .map((one) => (
                <option key={one} value={one}>
                  {dialectText(one)}
                </option>
              ))}
          </optgroup>
        </select>
      </label>
      <label class="choice">
        <span>{t('translation.mode')}</span>
        <select value={mode} onChange={(event) => changeQuery('mode', event.currentTarget.value === 'explicit' ? 'explicit' : null)}>
          <option value="macro">{t('translation.macro')}</option>
          <option value="explicit">{t('translation.explicit')}</option>
        </select>
      </label>
    </div>
  );
}

function Shown({ program, converted, line, mayKeep, chosen, isOlder }: Props & { converted: Converted; isOlder: boolean }) {
  const editor = useRef<Editor | null>(null);
  const here = useRef(0); // the line of the translation where the cursor is
  const { value: words } = useLoaded(converted.to, () => deskCalls.words(converted.to, '', ''));
  // Not where the cursor is in that line already: it may be in the second of its lines.
  const follow = () => {
    const at = lineFrom(converted.origins, line);
    if (at !== null && originOf(converted.origins, here.current) !== line) editor.current?.show(at);
  };
  useEffect(follow, [line, converted]);
  const standing = standingOf(converted);
  return (
    <>
      <p>
        <Badge wording={{ text: t(`translation.${standing.state}`), tone: standing.tone }} />{' '}
        {converted.not_verified && <span class="quiet-text">{converted.not_verified}</span>}
      </p>
      <Findings converted={converted} chosen={chosen} />
      {converted.text !== null && (
        <TextEditor
          text={converted.text}
          label={t('translation.label', { dialect: dialectText(converted.to) })}
          readOnly
          words={words}
          isSure={false}
          faults={kNoFaults}
          faultsOf=""
          editor={editor}
          changed={() => undefined}
          cursorMoved={(at, _word, byPerson) => {
            here.current = at;
            const origin = originOf(converted.origins, at);
            if (byPerson && origin !== null) chosen(origin);
          }}
          opened={follow}
        />
      )}
      {converted.text !== null && mayKeep && (
        <button type="button" class="button" aria-disabled={isOlder} onClick={() => !isOlder && keep(program, converted)}>
          {t('translation.keep')}
        </button>
      )}
    </>
  );
}

// What the translator states of the text; each leads to its line.
function Findings({ converted, chosen }: { converted: Converted; chosen: (line: number) => void }) {
  if (converted.diagnostics.length === 0) return null;
  return (
    <ul class="faults">
      {converted.diagnostics.map((one) => (
        <li key={`${one.id} ${one.line} ${one.column}`} class={`fault ${one.severity === 'error' ? 'tone-bad' : 'tone-waiting'}`} data-fault={one.id}>
          <button type="button" class="fault-go" onClick={() => chosen(one.line)}>
            <span class="unseen">{t(`severity.${one.severity}`)}</span> {t('fault.line', { line: one.line })}
          </button>
          <p>
            {one.file !== null && `${one.file}: `}
            {one.text}
          </p>
        </li>
      ))}
      {converted.folded.map(({ id, more }) => (
        <li key={id} class="hint">
          {t('side.more', { count: more, id })}
        </li>
      ))}
    </ul>
  );
}

// A program of its own: the one that it comes from stays as it is.
function keep(program: Program, converted: Converted): void {
  const follow = goUnlessLeft();
  showDialog(<KeepDialog proposed={`${program.name} ${converted.to}`} converted={converted} kept={(made) => follow(hrefs.program(made.id))} />);
}

function KeepDialog({ proposed, converted, kept }: { proposed: string; converted: Converted; kept: (made: Program) => void }) {
  const [name, setName] = useState(proposed);
  return (
    <OrderDialog
      title={t('translation.keep_title')}
      confirm={t('translation.keep_it')}
      blocked={name.trim() === '' ? t('translation.needs_name') : null}
      send={async (key) => kept(await deskCalls.addProgram(name.trim(), converted.to, converted.text ?? '', key))}
    >
      {!converted.verified && <p class="notice tone-waiting">{t('translation.keep_unverified')}</p>}
      <label class="field">
        <span>{t('column.name')}</span>
        <input value={name} required maxLength={200} onInput={(event) => setName(event.currentTarget.value)} autocomplete="off" />
      </label>
    </OrderDialog>
  );
}
