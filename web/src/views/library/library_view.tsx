// The library: every program of the shop, found by words as one types, or by where it is filed. Files are dropped
// anywhere on it. What is looked for stands in the address, so that it can be kept and given to others.
import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import type { Program } from '../../api/types';
import { bytes, count } from '../../format/numbers';
import { shortTime } from '../../format/times';
import { dialectText } from '../../format/words';
import { t } from '../../i18n/i18n';
import { minutes } from '../../parts/clock';
import { showDialog } from '../../parts/dialog';
import { CsvButton } from '../../parts/csv_button';
import { Empty } from '../../parts/empty';
import { Failure } from '../../parts/failure';
import { Table } from '../../parts/table';
import { isoTime, type CsvColumn } from '../../rules/csv';
import { atLeast } from '../../rules/roles';
import { changeQuery, go, hrefs, route } from '../../router';
import { person } from '../../state/shop';
import { useFound, type Found } from './found';
import { ImportDialog } from './import_dialog';
import { Labels } from './labels';
import { ArchiveButton } from './orders';
import { Thumbnail } from './thumbnail';
import { UploadDialog } from './upload_dialog';

const kTypingMs = 250;
const kFilters = ['folder', 'tag', 'part'] as const;
const kShelves = ['in_use', 'archived', 'all'] as const;

function soughtIn(query: URLSearchParams) {
  const filter: Record<string, string> = {};
  for (const name of [...kFilters, 'shelf']) {
    const value = query.get(name);
    if (value) filter[name] = value;
  }
  return { words: query.get('q') ?? '', filter };
}

export function LibraryView() {
  const { words, filter } = soughtIn(route.value.query);
  const found = useFound({ words, filter });
  const may = atLeast(person().role, 'programmer');
  const upload = (files: readonly File[]) => {
    if (files.length > 0) showDialog(<UploadDialog files={files} folder={filter.folder ?? ''} changed={found.take} />);
  };
  const importFolder = (files: readonly File[]) => {
    if (files.length > 0) showDialog(<ImportDialog files={files} folder={filter.folder ?? ''} changed={found.again} />);
  };
  const drop = useDrop(may ? upload : null);
  return (
    <div class={drop.isOver ? 'library drop-here' : 'library'} {...drop.handlers}>
      <div class="floor-head">
        <h1 tabIndex={-1}>{t('nav.library')}</h1>
        {may && <FilesButton label={t('library.upload')} take={upload} main />}
        {may && <FilesButton label={t('import.folder')} take={importFolder} folder />}
      </div>
      <SearchLine words={words} filter={filter} items={found.shown?.items ?? []} />
      {drop.isOver && (
        <p class="notice tone-active" role="status">
          {t('library.drop')}
        </p>
      )}
      <Failure error={found.error} />
      <FoundPrograms found={found} words={words} may={may} nothing={isAll(words, filter) ? <NoProgram may={may} upload={upload} /> : <NothingFound />} />
    </div>
  );
}

const isAll = (words: string, filter: Record<string, string>): boolean => words === '' && Object.keys(filter).length === 0;

interface FoundProgramsProps {
  found: ReturnType<typeof useFound>;
  words: string;
  may: boolean;
  nothing: ComponentChildren; // where there is none
}

function FoundPrograms({ found, words, may, nothing }: FoundProgramsProps) {
  const { shown, isOld, error, more, take, again } = found;
  if (!shown)
    return error === null ? (
      <p class="waiting" role="status">
        {t('page.loading')}
      </p>
    ) : null;
  const changed = (program: Program) => {
    take(program);
    again();
  };
  return (
    <>
      {shown.waiting > 0 && words !== '' && <p class="hint">{t('library.waiting', { count: shown.waiting })}</p>}
      {shown.items.length > 0 && <Programs items={shown.items} isOld={isOld} may={may} changed={changed} />}
      {shown.items.length === 0 && !isOld && nothing}
      {more && (
        <button type="button" class="button" onClick={more}>
          {t('list.more')}
        </button>
      )}
    </>
  );
}

const NoProgram = ({ may, upload }: { may: boolean; upload: (files: readonly File[]) => void }) => (
  <Empty action={may && <FilesButton label={t('library.upload')} take={upload} main />}>{t(may ? 'library.empty' : 'library.empty_viewer')}</Empty>
);

const NothingFound = () => (
  <Empty
    action={
      <button type="button" class="button" onClick={() => go(hrefs.library)}>
        {t('library.show_all')}
      </button>
    }
  >
    {t('library.nothing_found')}
  </Empty>
);

interface FilesButtonProps {
  label: string;
  take: (files: readonly File[]) => void;
  main?: boolean;
  folder?: boolean; // with all that is in it
}

function FilesButton({ label, take, main = false, folder = false }: FilesButtonProps) {
  const input = useRef<HTMLInputElement>(null);
  // What all browsers call it.
  useEffect(() => void input.current?.toggleAttribute('webkitdirectory', folder), [folder]);
  return (
    <>
      <button type="button" class={main ? 'button button-main' : 'button'} onClick={() => input.current?.click()}>
        {label}
      </button>
      <input
        ref={input}
        type="file"
        multiple
        hidden
        onChange={(event) => {
          take([...(event.currentTarget.files ?? [])]);
          event.currentTarget.value = '';
        }}
      />
    </>
  );
}

// Files that are dragged over the view. Leaving one element for another inside it is no leaving.
function useDrop(take: ((files: readonly File[]) => void) | null) {
  const [depth, setDepth] = useState(0);
  const hasFiles = (event: DragEvent) => take !== null && (event.dataTransfer?.types.includes('Files') ?? false);
  const handlers = {
    onDragEnter: (event: DragEvent) => hasFiles(event) && setDepth((before) => before + 1),
    onDragLeave: (event: DragEvent) => hasFiles(event) && setDepth((before) => Math.max(0, before - 1)),
    onDragOver: (event: DragEvent) => hasFiles(event) && event.preventDefault(),
    onDrop: (event: DragEvent) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      setDepth(0);
      take?.([...(event.dataTransfer?.files ?? [])]);
    },
  };
  return { isOver: depth > 0, handlers };
}

interface SearchLineProps {
  words: string;
  filter: Record<string, string>;
  items: readonly Found[];
}

// What is typed goes into the address after a pause, and is looked for then. Words and places exclude each other: the
// search looks through names, tags, parts and texts alike.
function SearchLine({ words, filter, items }: SearchLineProps) {
  const folders = [...new Set(items.map(({ program }) => program.folder ?? '').filter(Boolean))].sort();
  const tags = [...new Set(items.flatMap(({ program }) => program.tags))].sort();
  const choices: Record<string, string[]> = { folder: folders, tag: tags, part: [] };
  const seek = (text: string) => {
    if (text !== '') for (const name of kFilters) changeQuery(name, null);
    if (text !== '' && filter.shelf === 'archived') changeQuery('shelf', null);
    changeQuery('q', text === '' ? null : text);
  };
  return (
    <search class="search-line">
      <TypedField class="field search-words" label={t('library.search')} value={words} type="search" typed={seek} hint={t('library.search_example')} />
      {kFilters.map((name) => (
        <TypedField
          key={name}
          class="field"
          label={t(`library.${name}`)}
          value={filter[name] ?? ''}
          type="text"
          choices={choices[name] ?? []}
          typed={(text) => {
            if (text !== '') changeQuery('q', null);
            changeQuery(name, text === '' ? null : text);
          }}
        />
      ))}
      <label class="field">
        <span>{t('library.shelf')}</span>
        <select value={filter.shelf ?? 'in_use'} onChange={(event) => changeQuery('shelf', event.currentTarget.value === 'in_use' ? null : event.currentTarget.value)}>
          {kShelves.map((shelf) => (
            <option key={shelf} value={shelf} disabled={words !== '' && shelf === 'archived'}>
              {t(`shelf.${shelf}`)}
            </option>
          ))}
        </select>
      </label>
      <CsvButton name="programs" columns={kCsv} rows={items.map(({ program }) => program)} />
    </search>
  );
}

interface TypedFieldProps {
  class: string;
  label: string;
  value: string;
  type: 'search' | 'text';
  typed: (text: string) => void;
  hint?: string;
  choices?: readonly string[];
}

function TypedField(props: TypedFieldProps) {
  const [text, setText] = useState(props.value);
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const typed = useRef(props.typed);
  typed.current = props.typed;
  // Not while the same is being typed: a blank at its end may be the start of the next word.
  useEffect(() => setText((before) => (before.trim() === props.value ? before : props.value)), [props.value]);
  // Where the address changes, what was typed before is over: its question would replace the newer one.
  const { address } = route.value;
  useEffect(() => () => clearTimeout(timer.current), [address]);
  const list = `choices-${props.label}`;
  return (
    <label class={props.class}>
      <span>{props.label}</span>
      <input
        type={props.type}
        value={text}
        placeholder={props.hint}
        autocomplete="off"
        list={props.choices && props.choices.length > 0 ? list : undefined}
        onInput={(event) => {
          const now = event.currentTarget.value;
          setText(now);
          clearTimeout(timer.current);
          timer.current = setTimeout(() => typed.current(now.trim()), kTypingMs);
        }}
      />
      {props.choices && props.choices.length > 0 && (
        <datalist id={list}>
          {props.choices.map((one) => (
            <option key={one} value={one} />
          ))}
        </datalist>
      )}
    </label>
  );
}

interface ProgramsProps {
  items: readonly Found[];
  isOld: boolean;
  may: boolean;
  changed: (program: Program) => void;
}

const Programs = ({ items, isOld, may, changed }: ProgramsProps) => (
  <div class="found" aria-busy={isOld}>
    <Table
      label={t('nav.library')}
      rows={items}
      name="library"
      keyOf={({ program }) => program.id}
      marks={({ program }) => ({ 'data-program': String(program.id) })}
      columns={[
        { id: 'picture', head: t('column.picture'), class: 'picture-cell', cell: ({ program }) => <Thumbnail program={program} /> },
        { id: 'name', head: t('column.program'), class: 'program-cell', isFixed: true, cell: NameCell },
        { id: 'labels', head: t('column.filed'), cell: ({ program }) => <Labels program={program} may={may && !program.archived} changed={changed} /> },
        { id: 'revision', head: t('column.revision'), cell: ({ program }) => <RevisionCell program={program} /> },
        { id: 'dialect', head: t('column.dialect'), isExtra: true, cell: ({ program }) => dialectText(program.dialect) },
        { id: 'size', head: t('column.size'), isExtra: true, cell: ({ program }) => bytes(program.bytes) },
        { id: 'part', head: t('column.part'), isExtra: true, cell: ({ program }) => program.origin.part && <a href={hrefs.part(program.origin.part)}>{program.origin.part}</a> },
        { id: 'machine', head: t('column.made_for'), isExtra: true, cell: ({ program }) => program.origin.machine },
        may && { id: 'orders', head: t('column.orders'), class: 'orders', cell: ({ program }) => <ArchiveButton program={program} changed={changed} /> },
      ]}
    />
  </div>
);

const NameCell = ({ program, snippet, isSimilar }: Found) => (
  <div class="program-name">
    <a href={hrefs.program(program.id)}>
      <strong>{program.name}</strong>
    </a>{' '}
    <span class="quiet-text">
      {dialectText(program.dialect)}, {t('library.blocks', { count: program.blocks, text: count(program.blocks) })}, {bytes(program.bytes)}
    </span>
    {isSimilar && <span class="reason">{t('library.similar')}</span>}
    {snippet.length > 0 && (
      <code class="snippet">
        {snippet.map(({ text, is_hit }, index) => (is_hit ? <mark key={index}>{text}</mark> : text))}
      </code>
    )}
    {program.archived && <span class="reason">{t('library.archived_by', { name: program.archived.by, reason: program.archived.reason })}</span>}
  </div>
);

const RevisionCell = ({ program }: { program: Program }) => (
  <>
    {program.revision}{' '}
    <span class="quiet-text">{t('library.changed', { name: program.created_by, at: shortTime(program.created_at_ms, minutes.value) })}</span>
    {program.origin.part && ' '}
    {program.origin.part && <a href={hrefs.part(program.origin.part)}>{t('library.of_part', { part: program.origin.part })}</a>}
  </>
);

const kCsv: CsvColumn<Program>[] = [
  { head: 'program', of: ({ id }) => id },
  { head: 'name', of: ({ name }) => name },
  { head: 'dialect', of: ({ dialect }) => dialect },
  { head: 'folder', of: ({ folder }) => folder },
  { head: 'tags', of: ({ tags }) => tags.join(' ') },
  { head: 'revision', of: ({ revision }) => revision },
  { head: 'bytes', of: ({ bytes: size }) => size },
  { head: 'blocks', of: ({ blocks }) => blocks },
  { head: 'changed_by', of: ({ created_by }) => created_by },
  { head: 'changed', of: ({ created_at_ms }) => isoTime(created_at_ms) },
];
