// The search of the documentation, in the header of each of its pages. The index is fetched from this server when a person first comes to the
// field. Keys: / to the field, arrows along the hits, Enter opens the first or the chosen one, Escape leaves.
import { searchOf, type DocsIndex, type Found, type Hit } from './find';

const kPause_ms = 60; // after a key

function make(tag: string, attributes: Record<string, string>, ...children: (Node | string)[]): HTMLElement {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

const itemOf = ({ href, page, heading, text }: Hit): HTMLElement =>
  make(
    'li',
    {},
    make('a', { href }, make('span', { class: 'docs-hit-page' }, page), ' ', make('strong', {}, heading)),
    make('p', {}, ...text.map((piece) => (piece.isHit ? make('mark', {}, piece.text) : piece.text))),
  );

function sentenceOf({ count, hits }: Found): string {
  if (count === 0) return 'Nothing found. Each word must be found; a shorter word finds more.';
  const places = count === 1 ? '1 place' : `${count} places`;
  return hits.length < count ? `${places}; the best ${hits.length} are shown.` : places;
}

function start(form: HTMLFormElement): void {
  const field = form.querySelector('input')!;
  const panel = form.querySelector<HTMLElement>('.docs-hits')!;
  const status = panel.querySelector('p')!;
  const list = panel.querySelector('ol')!;
  let search: Promise<(query: string) => Found> | null = null;
  let pause = 0;

  const prepare = () => {
    search ??= fetch(form.dataset['index'] ?? '').then(async (answer) => {
      if (!answer.ok) throw new Error(`status ${answer.status}`);
      return searchOf((await answer.json()) as DocsIndex);
    });
    return search;
  };
  const links = () => [...list.querySelectorAll('a')];
  const close = () => {
    panel.hidden = true;
  };
  const show = async () => {
    const query = field.value;
    if (query.trim() === '') return close();
    try {
      const found = (await prepare())(query);
      if (query !== field.value) return; // another one is in transit
      list.replaceChildren(...found.hits.map(itemOf));
      status.textContent = sentenceOf(found);
    } catch (error) {
      search = null;
      list.replaceChildren();
      status.textContent = `The index of the search cannot be read: ${error instanceof Error ? error.message : 'no answer'}.`;
    }
    panel.hidden = false;
  };
  const step = (by: number) => {
    const stops: HTMLElement[] = [field, ...links()];
    const at = stops.indexOf(document.activeElement as HTMLElement);
    stops[Math.min(Math.max(at + by, 0), stops.length - 1)]?.focus();
  };

  form.hidden = false;
  field.addEventListener('focus', () => {
    prepare().catch(() => undefined); // reported when a word is searched
    if (field.value !== '') void show();
  });
  field.addEventListener('input', () => {
    clearTimeout(pause);
    pause = window.setTimeout(() => void show(), kPause_ms);
  });
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    clearTimeout(pause);
    void show().then(() => links()[0]?.click());
  });
  form.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') {
      field.value = '';
      close();
      field.focus();
    } else if (event.key === 'ArrowDown' || event.key === 'ArrowUp') {
      step(event.key === 'ArrowDown' ? 1 : -1);
    } else {
      return;
    }
    event.preventDefault();
  });
  form.addEventListener('focusout', ({ relatedTarget }) => {
    if (!(relatedTarget instanceof Node && form.contains(relatedTarget))) close();
  });
  list.addEventListener('click', ({ target }) => {
    if (target instanceof Element && target.closest('a')) close();
  });
  document.addEventListener('keydown', (event) => {
    const isWritten = event.target instanceof HTMLElement && event.target.matches('input, textarea, select');
    if (event.key !== '/' || isWritten || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    field.focus();
  });
}

const form = document.querySelector<HTMLFormElement>('.docs-search');
if (form) start(form);

// A list of pages that is longer than the window shows the present page.
const present = document.querySelector<HTMLElement>('.docs-list [aria-current]');
const pages = present?.closest<HTMLElement>('.docs-list');
if (present && pages && present.offsetTop > pages.clientHeight) pages.scrollTop = present.offsetTop - pages.clientHeight / 2;
