// The search of the documentation under /docs, in the server's own pages: by keys alone, on a desk and a phone, light and dark, within the
// strict policy and without an outside host; and a reader without scripts has no field that does nothing.
import { accessible, expect, fits, main, shot, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const { url } = await rig.base();
const kField = 'Search the documentation';

function watched(page) {
  const others = [];
  const own = [];
  page.on('request', (request) => (request.url().startsWith(url) ? own : others).push(request.url()));
  return { others, indexes: () => own.filter((one) => /\/assets\/docs-index-/.test(one)).length };
}

const first = (page) => page.locator('.docs-hits a').first();
const status = (page) => page.locator('.docs-hits [role="status"]');

async function byKeys(page) {
  const requests = watched(page);
  await page.goto(`${url}/docs/safety`);
  await page.getByLabel(kField).waitFor();
  expect(requests.indexes() === 0, 'the index is not fetched before it is needed');
  await page.keyboard.press('/');
  await page.keyboard.type('G84 fanuc');
  await first(page).waitFor();
  await until(async () => /^\d+ places/.test(await status(page).textContent()), 'the hits are counted');
  await soon(async () => (await first(page).textContent()).includes('G84'), 'the row of the word comes first');
  await shot(page, 'docs-search');
  await page.keyboard.press('Enter');
  await page.waitForURL(/\/docs\/words-fanuc#row-G84$/);
  await page.locator('tr:target').waitFor();
  await soon(async () => (await page.locator('tr:target').textContent()).startsWith('G84'), 'the row that was found is the one that is shown');
  await shot(page, 'docs-row');

  await page.keyboard.press('/');
  await page.keyboard.type('torn reset');
  await first(page).waitFor();
  const wanted = await page.locator('.docs-hits a').nth(1).getAttribute('href');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowDown');
  await soon(async () => await page.evaluate(() => document.activeElement.getAttribute('href')) === wanted, 'arrows lead along the hits');
  await page.keyboard.press('Enter');
  await page.waitForURL((address) => `${address.pathname}${address.hash}` === wanted);

  await page.keyboard.press('/');
  await page.keyboard.type('zyzzyva');
  await until(async () => /^Nothing found/.test(await status(page).textContent()), 'it states that nothing is found');
  await page.keyboard.press('Escape');
  await status(page).waitFor({ state: 'hidden' });
  await soon(async () => (await page.getByLabel(kField).inputValue()) === '', 'Escape clears the field');
  expect(requests.others.length === 0, `no outside host is asked (${requests.others.join(', ') || 'none'})`);
}

// Each address of the index is one of a page: a sample of all.
async function addresses(page) {
  await page.goto(`${url}/docs`);
  const { index, pages } = await page.evaluate(async () => {
    const read = await (await fetch(document.querySelector('.docs-search').dataset.index)).json();
    const ids = await Promise.all(read.pages.map(async ([address]) => {
      const answer = await fetch(address);
      const text = new DOMParser().parseFromString(await answer.text(), 'text/html');
      return [...text.querySelectorAll('main [id]')].map((one) => one.id);
    }));
    return { index: read, pages: ids };
  });
  const known = pages.map((ids) => new Set(ids));
  const lost = index.entries.filter(([of, id]) => !known[of].has(id));
  expect(index.entries.length > 3000 && lost.length === 0, `each of ${index.entries.length} entries has its place (${lost.slice(0, 3).join('; ') || 'none is lost'})`);
}

async function onAPhone(page) {
  await page.goto(`${url}/docs`);
  await page.getByLabel(kField).tap();
  await page.getByLabel(kField).fill('overrun budget');
  await first(page).waitFor();
  await fits(page, 'hits on a phone');
  const box = await page.getByLabel(kField).boundingBox();
  expect(box.height >= 36, `the field can be touched (${box.height} pixels high)`);
  await shot(page, 'docs-search-phone');
  await accessible(page, 'hits on a phone');
  await first(page).tap();
  await status(page).waitFor({ state: 'hidden' });
  await fits(page, 'the page that was found');
}

async function looks(page) {
  await page.goto(`${url}/docs/operating`);
  await page.getByLabel(kField).fill('alarm');
  await first(page).waitFor();
  await accessible(page, 'hits in the dark');
  await shot(page, 'docs-search-dark');
  await page.locator('main').click({ position: { x: 5, y: 5 } });
  await status(page).waitFor({ state: 'hidden' });
  expect(true, 'a click elsewhere closes the hits');
  await page.route(/docs-index-/, (route) => route.abort());
  await page.reload();
  await page.getByLabel(kField).fill('alarm');
  await status(page).getByText(/cannot be read/).waitFor();
  expect(true, 'an index that cannot be read is stated');
}

// At the viewport of a small desk.
async function drawings(page) {
  for (const name of ['architecture', 'families']) {
    await page.goto(`${url}/docs/${name}`);
    const wide = await page.locator('.wide:has(> svg)').evaluateAll((all) => all.map((one) => [one.querySelector('title')?.textContent ?? '', one.scrollWidth - one.clientWidth]));
    const cut = wide.filter(([, by]) => by > 0);
    expect(wide.length > 0 && cut.length === 0, `none of the ${wide.length} drawings of ${name} scrolls sideways (${cut.join('; ') || 'none'})`);
  }
  await page.goto(`${url}/docs/architecture#the-state-machines`);
  await shot(page, 'docs-drawing');
  const present = page.locator('.docs-list [aria-current]');
  await soon(() => present.evaluate((one) => one.getBoundingClientRect().bottom <= window.innerHeight), 'the list of pages shows the present one');
}

async function withoutScripts(page) {
  await page.goto(`${url}/docs/safety`);
  await soon(async () => !(await page.locator('.docs-search').isVisible()), 'there is no field');
  await soon(() => page.getByRole('link', { name: 'Profiles' }).or(page.getByRole('link', { name: 'Machine profiles' })).first().isVisible(), 'the list of pages is there');
}

await main([
  ['by keys', () => withPage({}, byKeys)],
  ['addresses', () => withPage({}, addresses)],
  ['on a phone', () => withPage({ viewport: { width: 390, height: 800 }, hasTouch: true }, onAPhone)],
  ['in the dark', () => withPage({ colorScheme: 'dark' }, looks)],
  ['drawings', () => withPage({}, drawings)],
  ['without scripts', () => withPage({ javaScriptEnabled: false }, withoutScripts)],
]);
