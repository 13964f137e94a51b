// Builds the pages of the documentation into dist/docs: README.md as index.html, one page for each file of docs/, and the
// reference of the API, which a script writes from the description that the server gives; and the index of their search into
// dist/assets. No inline script or style: they keep to the strict policy with which the server sends them.
import { createHash } from 'node:crypto';
import { copyFile, mkdir, readdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { Marked } from 'marked';
import { indexOf } from './docs_index.mjs';

// The groups in which the pages are listed; those without a group follow by name.
const kGroups = [
  ['Start', ['index', 'getting-started', 'concepts', 'safety']],
  ['Programs', ['families', 'checks', 'diagnostics', 'optimizing', 'editor']],
  ['Languages', ['dialects', 'words', 'words-fanuc', 'words-haas', 'words-mazak', 'words-mitsubishi-m80', 'words-sinumerik-840d']],
  ['Machines', ['connecting', 'profiles']],
  ['Server', ['page', 'operating', 'integrating', 'api', 'api-reference', 'scheduling', 'threads', 'measurements']],
];
const kOthers = 'Development';

const kLicences = '<!-- bundled packages -->';

const escape = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

// The anchor that GitHub gives a heading, too.
export const slugOf = (heading) =>
  heading
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}_\- ]/gu, '')
    .replaceAll(' ', '-');

// Links between files become links between pages; other files of the repository have no page.
export function hrefOf(href) {
  if (/^[a-z]+:/i.test(href) || href.startsWith('#')) return href;
  const [file, anchor] = href.split('#');
  const name = path.posix.basename(file, '.md');
  if (!file.endsWith('.md')) return null;
  return `/docs/${name === 'README' ? '' : name}${anchor ? `#${anchor}` : ''}`.replace(/\/$/, '');
}

// A row of a long table that begins with one word of code has an address of its own: a code of a control, a route, a member.
const kLongTable = 8; // rows
const kWordAlone = /^(?:<strong>)?<code>([^<]*)<\/code>(?:<\/strong>)?$/;

// `drawings`: by name, of SVG files that are written into the page.
function renderer(drawings) {
  const seen = new Map();
  const idOf = (slug) => {
    const times = seen.get(slug) ?? 0;
    seen.set(slug, times + 1);
    return times ? `${slug}-${times}` : slug;
  };
  const rowId = (first, rows) => {
    const [, word] = (rows >= kLongTable && kWordAlone.exec(first)) || [];
    return word ? ` id="row-${idOf(word.replace(/&\w+;|[^\p{L}\p{N}._]+/gu, '-'))}"` : '';
  };
  return {
    heading({ tokens, depth, text }) {
      const id = idOf(slugOf(text.replaceAll('`', '')));
      return `<h${depth} id="${escape(id)}"><a class="anchor" href="#${escape(id)}">${this.parser.parseInline(tokens)}</a></h${depth}>\n`;
    },
    link({ href, tokens }) {
      const to = hrefOf(href);
      const text = this.parser.parseInline(tokens).replace(/^(?:docs\/)?([\w-]+)\.md$/, '$1');
      return to === null ? text : `<a href="${escape(to)}">${text}</a>`;
    },
    image({ href, text }) {
      const drawing = drawings.get(path.posix.basename(href));
      if (drawing) return `<div class="wide" tabindex="0">${drawing}</div>`;
      return `<img src="/docs/${escape(path.posix.basename(href))}" alt="${escape(text)}">`;
    },
    html({ text }) {
      return text.startsWith('<!--') ? '' : escape(text);
    },
    table(token) {
      const texts = (row) => row.map((cell) => this.parser.parseInline(cell.tokens));
      const cells = (row, tag) => row.map((cell) => `<${tag}>${cell}</${tag}>`).join('');
      const rows = token.rows.map(texts);
      const body = rows.map((row) => `<tr${rowId(row[0], rows.length)}>${cells(row, 'td')}</tr>`).join('\n');
      return `<div class="wide" tabindex="0"><table><thead><tr>${cells(texts(token.header), 'th')}</tr></thead>\n<tbody>${body}</tbody></table></div>\n`;
    },
    code({ text, lang }) {
      return `<pre tabindex="0"><code class="${escape(lang ? `is-${lang}` : '')}">${escape(text)}</code></pre>\n`;
    },
  };
}

export const htmlOf = (markdown, drawings = new Map()) => new Marked({ gfm: true, renderer: renderer(drawings) }).parse(markdown);

export const titleOf = (markdown) => (/^# +(.+)$/m.exec(markdown)?.[1] ?? 'dripfeed').replaceAll('`', '');

// The field is shown by its script; without it there is none that does nothing.
const searchForm = (index) => `<form class="docs-search" role="search" data-index="${index}" hidden>
<input type="search" name="words" aria-label="Search the documentation" placeholder="Search ( / )" autocomplete="off" spellcheck="false">
<div class="docs-hits" hidden><p role="status"></p><ol></ol></div>
</form>`;

function pageOf({ title, body, list, style, icon, scripts, index }) {
  const full = title === 'dripfeed' ? title : `${title} · dripfeed`;
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>${escape(full)}</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" type="image/svg+xml" href="${icon}">
<link rel="stylesheet" href="${style}">
${scripts.map((script) => `<script type="module" src="${script}"></script>`).join('\n')}
</head>
<body class="docs">
<header class="docs-top"><a class="docs-brand" href="/docs">dripfeed</a>
${searchForm(index)}
<a class="docs-to-list" href="#pages">All pages</a><a href="/">Machines</a></header>
<div class="docs-body">
<nav class="docs-list" id="pages" aria-label="Documentation">
${list}
</nav>
<main>
${body}</main>
</div>
</body>
</html>
`;
}

// "Checks" of "Checks: verdicts, models, formulas"; a page of words has the control's name.
function labelOf({ name, markdown }) {
  const [first, rest] = titleOf(markdown).split(': ');
  return name.startsWith('words-') ? rest : first;
}

// The links to all pages, by groups. `current`: the name of the page that shows them.
function listOf(pages, current) {
  const grouped = new Set(kGroups.flatMap(([, names]) => names));
  const others = pages.map(({ name }) => name).filter((name) => !grouped.has(name));
  const link = (name) => {
    const page = pages.find((one) => one.name === name);
    if (!page) throw new Error(`docs: no page is named ${name}`);
    const href = name === 'index' ? '/docs' : `/docs/${name}`;
    return `<li><a href="${href}"${name === current ? ' aria-current="page"' : ''}>${escape(labelOf(page))}</a></li>`;
  };
  return [...kGroups, [kOthers, others]].map(([title, names]) => `<p>${title}</p>\n<ul>${names.map(link).join('\n')}</ul>`).join('\n');
}

const kReference = {
  name: 'api-reference',
  markdown: '# Reference of the API\n',
  body: '<h1 id="reference-of-the-api">Reference of the API</h1>\n<div id="reference">It is read from this server.</div>\n',
};

// The address of the file with the index, which has a hash in its name as all assets have.
async function writeIndex(pages, assets) {
  const text = JSON.stringify(indexOf(pages));
  const file = `docs-index-${createHash('sha256').update(text).digest('hex').slice(0, 8)}.json`;
  await writeFile(path.join(assets, file), text);
  return `/assets/${file}`;
}

// `repository`: its root; `into`: dist/docs; `assets`: dist/assets; `style`, `icon`, `reference` and `search` (scripts): addresses of what
// was built; `licences`: of the packages that were bundled, as markdown.
export async function writeDocs({ repository, into, assets, style, icon, reference, search, licences }) {
  await mkdir(into, { recursive: true });
  const read = (...parts) => readFile(path.join(repository, ...parts), 'utf8');
  const names = (await readdir(path.join(repository, 'docs'))).filter((name) => name.endsWith('.md')).map((name) => name.slice(0, -3));
  names.sort();
  const drawings = new Map();
  for (const name of (await readdir(path.join(repository, 'docs', 'pictures'))).filter((one) => one.endsWith('.svg'))) drawings.set(name, await read('docs', 'pictures', name));
  const pages = [{ name: 'index', markdown: await read('README.md') }];
  for (const name of names) pages.push({ name, markdown: await read('docs', `${name}.md`) });
  const shipped = pages.find(({ markdown }) => markdown.includes(kLicences));
  if (!shipped) throw new Error(`docs: no page has the place ${kLicences}`);
  shipped.markdown = shipped.markdown.replace(kLicences, () => licences);
  pages.push(kReference);
  const written = pages.map((page) => ({ ...page, label: labelOf(page), html: page.body ?? htmlOf(page.markdown, drawings) }));
  const index = await writeIndex(written, assets);
  for (const { name, markdown, body, html } of written) {
    const scripts = body ? [search, reference] : [search];
    const page = pageOf({ title: titleOf(markdown), body: html, list: listOf(pages, name), style, icon, scripts, index });
    await writeFile(path.join(into, `${name}.html`), page);
  }
  await copyFile(path.join(repository, 'web', 'pictures', 'machines.png'), path.join(into, 'machines.png'));
}
