// What stands around every view: lists that are empty, the sheet of keys, and the manifest by which a browser installs the page.
import { accessible, expect, fits, focused, live, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1280, height: 900 } };
const kPhone = { viewport: { width: 360, height: 740 }, hasTouch: true, colorScheme: 'dark' };
const { url, tokens } = await rig.base();

const sheet = (page, name = 'Keys') => page.getByRole('dialog', { name });

async function keySheet(page) {
  await signIn(page, url, tokens.programmer);
  await page.keyboard.press('?');
  await sheet(page).getByRole('region', { name: 'Text of a program' }).getByText('Next fault').waitFor();
  await accessible(page, 'the sheet of keys');
  await fits(page, 'the sheet of keys');
  await shot(page, 'keys-desk');
  await page.keyboard.press('Escape');
  await sheet(page).waitFor({ state: 'detached' });
  // In a field it is a character.
  await page.goto(`${url}/#/library`);
  const search = page.getByRole('searchbox').first();
  await search.fill('M30');
  await search.press('?');
  await page.waitForTimeout(500); // the sheet would come at once, its code is here
  await soon(async () => (await search.inputValue()) === 'M30?' && (await sheet(page).count()) === 0, 'in a field ? is a character');
  await search.fill('');
  // A person may turn the key off; the menu has the sheet still.
  await page.getByRole('heading', { level: 1 }).focus();
  await page.keyboard.press('?');
  await sheet(page).getByLabel('The key ? shows this list').uncheck();
  await page.keyboard.press('Escape');
  await sheet(page).waitFor({ state: 'detached' });
  await page.reload();
  await live(page);
  await page.getByRole('heading', { level: 1 }).focus();
  await page.keyboard.press('?');
  await page.waitForTimeout(500);
  await page.locator('.who summary').click();
  await soon(async () => (await sheet(page).count()) === 0, 'the key is off, after a reload too');
  await page.getByRole('button', { name: 'Keys', exact: true }).click();
  await sheet(page).getByRole('button', { name: 'Back' }).click();
  await sheet(page).waitFor({ state: 'detached' });
  await soon(async () => (await focused(page)) === 'BUTTON', 'the focus goes back to the button of the menu');
}

async function keySheetInGerman(page) {
  await signIn(page, url, tokens.viewer);
  await page.evaluate(() => localStorage.setItem('dripfeed.language', 'de'));
  await page.reload();
  await live(page);
  await page.locator('.who summary').click();
  await page.getByRole('button', { name: 'Tasten' }).click();
  await sheet(page, 'Tasten').getByText('Strg+S').waitFor();
  await fits(page, 'the sheet of keys on a phone');
  await accessible(page, 'the sheet of keys on a phone');
  await shot(page, 'keys-phone');
}

// The keys that the sheet names do what it states, in the text of a program.
async function keysOfTheText(page) {
  const { body } = await rig.call('POST', '/programs', { name: 'O0911', dialect: 'fanuc', text: '%\nO0911\nG00 X1.\nG01 XY\nM30\n%\n' });
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}/#/programs/${body.id}`);
  const text = page.locator('.cm-content');
  await page.locator('[data-phase="known"]').waitFor();
  await text.locator('.cm-line').nth(2).click();
  await page.keyboard.type('?');
  await until(async () => (await text.innerText()).includes('?'), 'it is there');
  await page.waitForTimeout(500); // the sheet would come with its code
  await soon(async () => (await sheet(page).count()) === 0, 'in the text ? is a character');
  await page.keyboard.press('Control+z');
  await until(async () => !(await text.innerText()).includes('?'), 'Ctrl+Z takes it back');
  await page.keyboard.press('Control+y');
  await until(async () => (await text.innerText()).includes('?'), 'Ctrl+Y brings it again');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Alt+ArrowDown');
  await until(async () => (await text.locator('.cm-line').nth(3).innerText()) === 'G00 X1.', 'Alt and an arrow move the line');
  await page.keyboard.press('Control+Alt+g');
  await page.locator('.cm-panel input').first().fill('5');
  await page.keyboard.press('Enter');
  await until(async () => (await text.locator('.cm-activeLine').innerText()) === 'M30', 'it goes to a line');
  await text.locator('.cm-activeLine').click();
  await page.keyboard.press('Control+f');
  await page.locator('.cm-search input').first().fill('X');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Escape');
  expect(true, 'Ctrl+F opens the search');
}

// What the browser itself finds wrong with installing the page. On an address without TLS it would refuse it; this one is the computer's own.
async function installed(page) {
  await signIn(page, url, tokens.viewer);
  const browser = await page.context().newCDPSession(page);
  const { url: address, errors, data } = await browser.send('Page.getAppManifest');
  expect(errors.length === 0 && JSON.parse(data).display === 'standalone', `the browser reads the manifest (${address})`);
  const { installabilityErrors } = await browser.send('Page.getInstallabilityErrors');
  const ids = installabilityErrors.map(({ errorId }) => errorId);
  expect(ids.every((id) => id === 'in-incognito'), `it may be installed (${ids.join(', ') || 'nothing against it'})`);
  const workers = await page.evaluate(() => navigator.serviceWorker.getRegistrations().then((all) => all.length));
  expect(workers === 0, 'no service worker: nothing answers in the server’s place');
  const icon = await page.request.get(new URL(JSON.parse(data).icons[0].src, url).href);
  expect(icon.ok() && icon.headers()['content-type'] === 'image/svg+xml', 'its icon is there');
}

// A new shop: what is empty states what to do, and a button does it or leads there.
async function emptyShop(page) {
  await signIn(page, url, tokens.admin);
  for (const place of ['floor', 'orders', 'history', 'jobs', 'releases', 'library', 'families', 'received', 'review', 'people/groups', 'people/machines', 'people/store']) {
    await page.goto(`${url}/#/${place}`);
    const empty = page.locator('.empty').first();
    await empty.waitFor();
    expect((await empty.locator('button, a.button').count()) > 0, `${place}: ${(await empty.innerText()).replaceAll('\n', ' | ')}`);
    await shot(page, `empty-${place.replace('/', '-')}`);
  }
  await page.goto(`${url}/#/people/audit`);
  await page.getByLabel('Who').fill('no-such-person');
  await page.getByRole('button', { name: 'Filter' }).click();
  await page.locator('.empty').getByRole('button', { name: 'Show all' }).click();
  await until(async () => (await page.locator('.empty').count()) === 0, 'an empty search of the audit shows all again');
  await accessible(page, 'the audit');
}

await main([
  ['an empty shop', () => withPage(kDesk, emptyShop)],
  ['the sheet of keys', () => withPage(kDesk, keySheet)],
  ['the sheet in German on a phone', () => withPage(kPhone, keySheetInGerman)],
  ['the keys of a text', () => withPage(kDesk, keysOfTheText)],
  ['installed', () => withPage(kDesk, installed)],
]);
