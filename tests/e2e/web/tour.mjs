// The guided tour of the demo shop, to its end: each of the five steps shows something that is there, in both languages, and
// nothing is covered or wider than the screen. DRIPFEED_URL and DRIPFEED_TOKEN as for round.mjs.
import { accessible, expect, fits, main, shot, signIn, soon, until, withPage } from './browser.mjs';

const url = process.env.DRIPFEED_URL;
const token = process.env.DRIPFEED_TOKEN;
const kSteps = [
  ['The floor', /Stop is in the same place/, '.card.machine'],
  ['A machine', /that moves nothing/, '.machine-top'],
  ['A program', /marks faults while you type/, '.writing-bar'],
  ['A part family', /Values make a program/, '.values'],
  ['From a text to a machine', /an approver let it go/, '.table'],
];

const tour = (page) => page.getByRole('region', { name: 'Guided tour' });

async function take(page) {
  await page.locator('details.who > summary').click();
  await page.getByRole('button', { name: 'Guided tour' }).click();
  await tour(page).waitFor();
}

async function walk(page, look) {
  await signIn(page, url, token);
  await take(page);
  for (const [index, [title, words, mark]] of kSteps.entries()) {
    await tour(page).getByRole('heading', { name: title }).waitFor();
    await tour(page).getByText(words).waitFor();
    await tour(page).getByText(`step ${index + 1} of 5`).waitFor();
    await page.locator(`${mark}.tour-mark`).first().waitFor();
    await soon(async () => (await tour(page).getByText('nothing to show').count()) === 0, `the demo has something for: ${title}`);
    await fits(page, `${title} on a ${look}`);
    await accessible(page, `${title} on a ${look}`);
    await shot(page, `tour-${index + 1}-${look}`);
    await tour(page).getByRole('button', { name: index < 4 ? 'Next' : 'Done' }).click();
  }
  await tour(page).waitFor({ state: 'detached' });
}

async function leave(page) {
  await signIn(page, url, token);
  await take(page);
  await tour(page).getByRole('button', { name: 'Next' }).click();
  await tour(page).getByRole('heading', { name: 'A machine' }).waitFor();
  await page.reload();
  await tour(page).getByRole('heading', { name: 'A machine' }).waitFor();
  expect(true, 'a reload keeps the step');
  await page.goto(`${url}/#/alarms`);
  await tour(page).getByRole('link', { name: 'Go there' }).click();
  await page.locator('.machine-view').waitFor();
  await tour(page).getByRole('button', { name: 'Back' }).click();
  await tour(page).getByRole('heading', { name: 'The floor' }).waitFor();
  await page.locator('details.who > summary').click();
  await page.getByLabel('Language').selectOption('de');
  await page.getByRole('region', { name: 'Rundgang' }).getByRole('heading', { name: 'Die Halle' }).waitFor();
  await page.getByRole('button', { name: 'Rundgang beenden' }).click();
  await until(async () => (await page.getByRole('region', { name: 'Rundgang' }).count()) === 0, 'the tour is left');
}

await main([
  ['at a desk', () => withPage({ viewport: { width: 1280, height: 900 } }, (page) => walk(page, 'desk'))],
  ['on a phone', () => withPage({ viewport: { width: 360, height: 740 }, hasTouch: true, colorScheme: 'dark' }, (page) => walk(page, 'phone'))],
  ['back and away', () => withPage({ viewport: { width: 1280, height: 900 } }, leave)],
]);
