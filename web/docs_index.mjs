// The index of the documentation's search, made of the pages as they are written: an entry for each heading with the text below it,
// and one for each row of a table that has an address of its own. So what is found has the address that the page gives it.

const kEntities = { '&lt;': '<', '&gt;': '>', '&quot;': '"', '&#39;': "'", '&amp;': '&' };

const textOf = (html) =>
  html
    .replace(/<svg[\s\S]*?<\/svg>/g, ' ')
    .replace(/<[^>]*>/g, (tag) => (/^<\/?(?:code|a|em|strong)\b/.test(tag) ? '' : ' '))
    .replace(/&(?:lt|gt|quot|#39|amp);/g, (entity) => kEntities[entity])
    .replace(/\s+/g, ' ')
    .trim();

const cellsOf = (html) =>
  html
    .split('</td>')
    .map(textOf)
    .filter((cell) => cell !== '' && cell !== '–')
    .join(' · ');

const kRow = /<tr id="([^"]*)"><td>([\s\S]*?)<\/td>([\s\S]*?)<\/tr>/g;
const kHeading = /<h[1-6] id="([^"]*)">([\s\S]*?)<\/h[1-6]>/g;

// Of one page: {id, heading, text}. What stands above the first heading belongs to none and is not found.
export function entriesOf(html) {
  const headings = [...html.matchAll(kHeading)];
  return headings.flatMap((heading, i) => {
    const below = html.slice(heading.index + heading[0].length, headings[i + 1]?.index);
    const rows = [...below.matchAll(kRow)].map(([, id, first, others]) => ({ id: textOf(id), heading: textOf(first), text: cellsOf(others) }));
    return [{ id: textOf(heading[1]), heading: textOf(heading[2]), text: textOf(below.replace(kRow, '')) }, ...rows];
  });
}

// `pages`: {name, label, html}, in the order in which equal hits are shown. What src/docs/find.ts reads.
export const indexOf = (pages) => ({
  pages: pages.map(({ name, label }) => [name === 'index' ? '/docs' : `/docs/${name}`, label]),
  entries: pages.flatMap(({ html }, page) => entriesOf(html).map(({ id, heading, text }) => [page, id, heading, text])),
});
