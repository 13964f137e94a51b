// A machine's line on the page: what passes on it, its test with a loopback plug, what is ahead of a feed, and where the
// machine's times are from.
import { accessible, expect, fits, focused, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1280, height: 900 } };
const kTablet = { viewport: { width: 820, height: 1180 }, hasTouch: true, colorScheme: 'dark' };
const kPhone = { viewport: { width: 360, height: 740 }, hasTouch: true };
const { url, tokens } = await rig.base();

const dialog = (page) => page.getByRole('dialog');
const terminal = (page) => page.getByRole('region', { name: 'Wire terminal' });
const rows = (page) => terminal(page).getByRole('listitem');
const open = (page, machine, more = '') => page.goto(`${url}/#/machines/${machine}${more}`);

async function armByApi(job) {
  const armed = await rig.call('POST', `/jobs/${job}/arm`, {}, 'operator');
  expect(armed.status === 200, `job ${job} is armed`);
}

// What went and came, as it went and came; and nothing of it once the terminal is closed.
async function wire(page, context) {
  const [job] = await rig.machine('wire', { blocks: 60 });
  const streams = { open: 0, ended: 0 };
  context.on('request', (one) => (streams.open += one.url().endsWith('/wire') ? 1 : 0));
  for (const event of ['requestfinished', 'requestfailed']) context.on(event, (one) => (streams.ended += one.url().endsWith('/wire') ? 1 : 0));
  await signIn(page, url, tokens.viewer);
  await open(page, 'wire');
  expect(streams.open === 0, 'nobody listens to a line before a person asks');
  const button = page.getByRole('button', { name: 'Show the wire terminal' });
  await button.focus();
  await page.keyboard.press('Enter');
  await page.locator('[data-phase="wire-open"]').waitFor();
  await rig.say('wire', 'dc3');
  await rows(page).filter({ hasText: 'from the control' }).getByText('DC3', { exact: true }).waitFor();
  await armByApi(job);
  await rig.say('wire', 'dc1');
  await rows(page).filter({ hasText: 'from the control' }).getByText('DC1', { exact: true }).first().waitFor();
  await until(async () => (await rows(page).filter({ hasText: 'to the control' }).count()) > 40, 'the blocks pass', 30_000);
  await rows(page).filter({ hasText: 'M30' }).getByText('LF', { exact: true }).first().waitFor();
  await soon(async () => /^\d\d:\d\d:\d\d\.\d{3}$/.test(await rows(page).first().locator('time').innerText()), 'each row has its time');
  await accessible(page, 'the wire terminal');
  await terminal(page).scrollIntoViewIfNeeded();
  await shot(page, 'wire-desk');
  await terminal(page).getByLabel('Bytes').check();
  await rows(page).filter({ hasText: /4D 33 30/ }).first().waitFor();
  await terminal(page).getByLabel('Hold the display').check();
  const held = await rows(page).count();
  await rig.say('wire', 'dc3');
  await page.waitForTimeout(800);
  await soon(async () => (await rows(page).count()) === held, 'a held display stays as it is');
  await page.getByRole('button', { name: 'Close the wire terminal' }).click();
  await until(async () => streams.ended === streams.open, 'closing it ends the stream');
  await soon(async () => (await focused(page)) === 'BUTTON', 'the focus stays at the button');
}

// Rows are bounded, however much passes.
async function bounded(page) {
  const [job] = await rig.machine('bounded', { blocks: 2000, baud: 115200 });
  await signIn(page, url, tokens.viewer);
  await open(page, 'bounded', '?wire=1');
  await page.locator('[data-phase="wire-open"]').waitFor();
  await armByApi(job);
  await rig.say('bounded', 'dc1');
  await until(async () => (await rig.job(job)).state === 'done', 'the job is done', 60_000);
  await page.waitForTimeout(600);
  const shown = await rows(page).count();
  expect(shown > 100 && shown <= 300, `the last rows are shown: ${shown}`);
}

async function narrow(page, name) {
  const [job] = await rig.machine(`line-${name}`, { blocks: 60 });
  await signIn(page, url, tokens.operator);
  await open(page, `line-${name}`, '?wire=1');
  await page.locator('[data-phase="wire-open"]').waitFor();
  await armByApi(job);
  await rig.say(`line-${name}`, 'dc1');
  await until(async () => (await rows(page).count()) > 20, 'rows are there');
  await fits(page, `the wire terminal on a ${name}`);
  await accessible(page, `the wire terminal on a ${name}`);
  await terminal(page).scrollIntoViewIfNeeded();
  await shot(page, `wire-${name}`);
}

async function lineTest(page) {
  await rig.machine('plug', { jobs: 1 });
  await signIn(page, url, tokens.operator);
  await open(page, 'plug');
  await page.getByRole('button', { name: 'Test the line…' }).click();
  await dialog(page).getByText(/bridge its data wires/).waitFor();
  await accessible(page, 'the dialog of the line test');
  await shot(page, 'line-test-dialog');
  await page.keyboard.press('Escape');
  await dialog(page).waitFor({ state: 'detached' });
  await soon(async () => (await rig.got('plug')) === 0, 'an open dialog sends nothing');
  await page.getByRole('button', { name: 'Test the line…' }).click();
  await dialog(page).getByRole('button', { name: 'The plug is in place: test' }).click();
  const result = page.getByRole('region', { name: 'Result of the line test' });
  await result.getByText(/Nothing came back/).waitFor({ timeout: 30_000 });
  await rig.bridge('plug');
  await page.getByRole('button', { name: 'Test the line…' }).click();
  await dialog(page).getByRole('button', { name: 'The plug is in place: test' }).click();
  await result.getByText(/The line (keeps|does not keep) the machine’s budget/).waitFor({ timeout: 60_000 });
  await result.getByText(/of 20 holds/).waitFor();
  await accessible(page, 'the result of the line test');
  await result.scrollIntoViewIfNeeded();
  await shot(page, 'line-test-result');
  await rig.bridge('plug', false);
  await rig.waitLine('plug', 'idle');
}

// A control that asks is on the line: no test is offered then.
async function testIsBlocked(page) {
  await rig.machine('blocked', { jobs: 0 });
  await signIn(page, url, tokens.operator);
  await rig.say('blocked', 'dc1');
  await open(page, 'blocked');
  await until(async () => (await page.locator('.machine-view').getAttribute('data-standing')) === 'asks', 'the control asks');
  await page.getByRole('button', { name: 'Test the line…' }).click();
  await dialog(page).getByText(/still on the line/).waitFor();
  await soon(() => dialog(page).getByRole('button', { name: 'The plug is in place: test' }).isDisabled(), 'and the test cannot be started');
}

// What is ahead: by the prediction first, corrected once enough was seen, never for a feed that a person stopped.
async function outlook(page) {
  const [job] = await rig.machine('outlook', { blocks: 3000, baud: 2400 });
  await signIn(page, url, tokens.operator);
  const { body } = await rig.call('GET', `/jobs/${job}/forecast`);
  expect(body.cycle_s > 0 && body.course.length > 100, `the checks predicted ${body.cycle_s} s in ${body.course.length} points`);
  await armByApi(job);
  await rig.say('outlook', 'dc1');
  await open(page, 'outlook');
  const part = page.locator('.outlook');
  await part.getByText(/left, as the checks predicted/).waitFor();
  await part.getByText(/at most \d+ blocks|\d+ to \d+ blocks|states no buffer/).waitFor();
  await shot(page, 'outlook-checked');
  await accessible(page, 'what is ahead of a feed');
  await part.getByText(/corrected by what is seen/).waitFor({ timeout: 60_000 });
  await shot(page, 'outlook-pace');
  await page.getByRole('button', { name: `Stop at block end, job ${job}` }).click();
  await until(async () => (await page.locator('.machine-view').getAttribute('data-standing')) === 'stopped', 'stopped');
  await soon(async () => (await part.getByText(/left/).count()) === 0, 'a feed that a person stopped has no time to go');
}

async function calibration(page) {
  await rig.machine('measured', { jobs: 0, timing: { sample_time_ms: 2, cost: { block_ms: 3.5, source: 'calibrated', origin: 'DRIPFEED TIMING, 2026-02-03', spread: 1.2 } } });
  await rig.machine('assumed', { jobs: 0 });
  await signIn(page, url, tokens.viewer);
  await open(page, 'measured');
  const part = page.getByRole('region', { name: 'Calibration' });
  await part.getByText('Calibrated at this machine').waitFor();
  await part.getByText('DRIPFEED TIMING, 2026-02-03').waitFor();
  await part.getByText('by a factor of 1.2 in either direction').waitFor();
  await page.getByRole('region', { name: 'Line', exact: true }).getByText(/19200.bit\/s/).waitFor();
  await part.scrollIntoViewIfNeeded();
  await shot(page, 'calibration');
  await open(page, 'assumed');
  await part.getByText(/^Not calibrated/).waitFor();
  expect(true, 'times that nobody measured are not called measured');
}

// What the server says of a machine and of an order is German where the page is, with the values in it.
async function german(page) {
  const [job] = await rig.machine('riss', { blocks: 400 });
  await signIn(page, url, tokens.operator);
  await page.evaluate(() => localStorage.setItem('dripfeed.language', 'de'));
  await armByApi(job);
  await rig.say('riss', 'dc1');
  await rig.waitLine('riss', 'feeding');
  await rig.tear('riss');
  await rig.waitLine('riss', 'torn');
  await open(page, 'riss');
  await page.reload();
  const alarms = page.getByRole('region', { name: 'Alarme' });
  await alarms.getByText(/zwischen Byte \d+ und \d+ von \d+ können bei der Steuerung angekommen sein/).first().waitFor();
  await alarms.getByText(/ein Satz ist zerrissen: die Steuerung zurücksetzen und das bestätigen/).first().waitFor();
  await soon(async () => (await page.getByText(/may have reached the control/).count()) === 0, 'no English sentence beside it');
  await shot(page, 'german-torn');
  await page.locator('.who summary').click();
  await page.getByRole('button', { name: 'Abmelden' }).click();
  await page.getByLabel('Kennung').fill('no-such-token');
  await page.keyboard.press('Enter');
  await page.getByText('Diese Kennung ist nicht gültig').waitFor();
  expect(true, 'a refusal of the server is German, too');
}

await main([
  ['wire', () => withPage(kDesk, wire)],
  ['bounded', () => withPage(kDesk, bounded)],
  ['wire on a phone', () => withPage(kPhone, (page) => narrow(page, 'phone'))],
  ['wire on a tablet', () => withPage(kTablet, (page) => narrow(page, 'tablet'))],
  ['line test', () => withPage(kDesk, lineTest)],
  ['test is blocked', () => withPage(kDesk, testIsBlocked)],
  ['outlook', () => withPage(kDesk, outlook)],
  ['german', () => withPage(kDesk, german)],
  ['calibration', () => withPage(kDesk, calibration)],
]);
