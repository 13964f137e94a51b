// Two servers with one store, seen at server b: a line is handed over, and one is taken from a server that is not heard of.
import { accessible, card, expect, fits, main, shot, signIn, soon, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1280, height: 900 } };
const kPhone = { viewport: { width: 360, height: 740 }, hasTouch: true };
const { url, tokens } = await rig.base();

const dialog = (page) => page.getByRole('dialog');
const line = (page, machine) => page.locator(`[data-line="${machine}"]`);

async function open(page) {
  await signIn(page, url, tokens.admin);
  await page.goto(`${url}/#/people/servers`);
  await page.locator('[data-server="a"]').waitFor();
}

async function handOver(page) {
  await open(page);
  await soon(async () => (await page.locator('[data-server="b"]').innerText()).includes('this server'), 'it states which one answers');
  await soon(async () => /^http:/.test(await page.locator('[data-server="a"]').getByRole('link').getAttribute('href')), 'and leads to the other');
  await soon(async () => (await line(page, 'lathe').getByRole('button').count()) === 0, 'what another server has, and which answers, is not taken');
  await accessible(page, 'servers');
  await shot(page, 'servers');
  await line(page, 'mill').getByRole('button', { name: 'Hand over the line of mill' }).click();
  const send = dialog(page).getByRole('button', { name: 'Hand over', exact: true });
  await soon(() => send.isDisabled(), 'it wants a reason');
  await dialog(page).getByLabel('Reason').fill('the mill moves to hall a');
  await accessible(page, 'a hand-over');
  await shot(page, 'servers-hand-over');
  await send.click();
  await dialog(page).waitFor({ state: 'detached' });
  await line(page, 'mill').getByText('the mill moves to hall a').waitFor();
  expect((await rig.do('lines_of_a')).join() === 'lathe,mill', 'server a has both lines');
}

async function takeOver(page) {
  const job = await rig.do('tear_at_a');
  await open(page);
  const take = line(page, 'lathe').getByRole('button', { name: 'Take over the line of lathe' });
  await soon(async () => (await take.count()) === 0, 'no line is offered while its server counts as heard of');
  await take.waitFor({ timeout: 40_000 });
  await shot(page, 'servers-unheard');
  await take.click();
  const send = dialog(page).getByRole('button', { name: 'Take over', exact: true });
  await dialog(page).getByLabel('Reason').fill('the computer of a is off');
  await soon(() => send.isDisabled(), 'a reason alone takes no line');
  await accessible(page, 'a take-over');
  await shot(page, 'servers-take-over');
  await dialog(page).getByLabel(/I have seen that a is off/).check();
  await send.click();
  await dialog(page).waitFor({ state: 'detached' });
  await soon(async () => (await line(page, 'lathe').innerText()).includes('the computer of a is off'), 'the line is at b');
  await soon(async () => (await line(page, 'lathe').getByRole('button', { name: /^Hand over/ }).count()) === 1, 'which may hand it over');
  await page.goto(`${url}/#/floor`);
  await card(page, 'lathe').getByText(/torn/i).first().waitFor();
  expect((await rig.job(job)).torn, 'the line is torn: a may have sent all of the text');
}

async function onPhone(page) {
  await open(page);
  await fits(page, 'servers on a phone');
  await accessible(page, 'servers on a phone');
  await shot(page, 'servers-phone');
}

await main([
  ['a line is handed over', () => withPage(kDesk, handOver)],
  ['a line is taken over', () => withPage(kDesk, takeOver)],
  ['on a phone', () => withPage(kPhone, onPhone)],
]);
