// What the page does in states that are hard to bring about with real lines: a lost connection, a torn block, a hold
// that stays, a person who may only look, a narrow screen. Against the mock server of web/test.
import { startMock } from '../../../web/test/mock_server.mjs';
import { card, expect, main, shot, signIn, until, withPage } from './browser.mjs';

const against = (options, test) => async () => {
  const mock = await startMock(0);
  try {
    await withPage(options, (page) => test(page, mock));
  } finally {
    await mock.close();
  }
};
const set = (mock, machine, key, value) => fetch(`${mock.url}/mock/set/${machine}?key=${key}&value=${encodeURIComponent(JSON.stringify(value))}`);

async function lostConnection(page, mock) {
  await signIn(page, mock.url, 'operator');
  const port = Number(new URL(mock.url).port);
  await mock.close();
  await page.getByText(/connection to the server is lost/).waitFor();
  await shot(page, 'lost');
  expect((await page.getByText('live', { exact: true }).count()) === 0, 'nothing claims to be live');
  expect(await card(page, 'mill-2').getByText('last known: feeding').isVisible(), 'a state is named as the last known');
  expect((await page.getByRole('button', { name: /^Arm/ }).count()) === 0, 'nothing can be armed');
  expect(await card(page, 'mill-2').getByRole('button', { name: /^Stop/ }).isVisible(), 'a stop can still be tried');
  await card(page, 'mill-2').getByRole('button', { name: /^Stop/ }).click();
  await page.getByText(/Whether the order took effect is not known/).waitFor();
  expect(true, 'an order without an answer says that its effect is not known');
  const again = await startMock(port);
  try {
    // The new server does not know the session.
    await page.getByText(/The session is over/).waitFor();
    expect(true, 'a server that was restarted asks for the token again');
  } finally {
    await again.close();
  }
}

async function cutStream(page, mock) {
  await signIn(page, mock.url, 'operator');
  await card(page, 'lathe-1').waitFor();
  await page.evaluate(() => {
    window.wasLost = false;
    new MutationObserver(() => {
      if (document.querySelector('.lost')) window.wasLost = true;
    }).observe(document.body, { subtree: true, childList: true });
  });
  await set(mock, 'lathe-1', 'status', { ...(await statusOf(mock, 'lathe-1')), line: 'held', stall: 'CTS off', job: 42 });
  expect(await card(page, 'lathe-1').getByText('idle').isVisible(), 'a change without an event is not seen');
  await fetch(`${mock.url}/mock/cut`);
  await until(() => page.evaluate(() => window.wasLost), 'the loss was shown');
  await card(page, 'lathe-1').getByText('CTS off').waitFor();
  await page.getByText('live', { exact: true }).waitFor();
  expect(true, 'after a cut the page says so, then loads everything and is live again');
  await set(mock, 'lathe-1', 'status', { ...(await statusOf(mock, 'lathe-1')), line: 'idle', stall: null });
  await fetch(`${mock.url}/mock/reset`);
  await card(page, 'lathe-1').getByText('idle').waitFor();
  expect(true, 'a reset event loads everything');
}

const statusOf = async (mock, machine) =>
  (await (await fetch(`${mock.url}/api/v1/machines/${machine}`, { headers: { Authorization: 'Bearer admin' } })).json()).status;

async function tornBlock(page, mock) {
  await signIn(page, mock.url, 'operator');
  const place = card(page, 'lathe-4');
  await place.getByText(/may have reached the control \(line 1187 to 1188\)/).waitFor();
  const articles = await page.getByRole('article').evaluateAll((all) => all.map((one) => one.getAttribute('aria-label')));
  expect(articles[0] === 'Machine lathe-4', 'a torn line comes first');
  await place.getByRole('button', { name: /I have reset the control/ }).click();
  const dialog = page.getByRole('dialog');
  const confirm = dialog.getByRole('button', { name: 'I have reset the control' });
  expect(await confirm.isDisabled(), 'no confirmation without a reason');
  await dialog.getByRole('textbox').fill('RESET pressed, tool retracted by hand');
  await shot(page, 'torn');
  await confirm.click();
  await until(async () => (await place.getAttribute('data-line')) === 'idle', 'the line is idle');
  expect((await place.getByText('Torn block').count()) === 0, 'the warning goes when the reset is confirmed');
  await page.goto(`${mock.url}/#/jobs/38`);
  await page.getByText(/reset confirmed by operator-1: RESET pressed/).waitFor();
  expect(true, 'the reason is kept with the job');
}

async function holdsAndStops(page, mock) {
  await set(mock, 'lathe-1', 'holdForever', true);
  await set(mock, 'lathe-1', 'startAfter', 300);
  await signIn(page, mock.url, 'operator');
  const place = card(page, 'lathe-1');
  await place.getByRole('button', { name: 'Arm, job 42' }).click();
  await page.getByRole('dialog').getByRole('button', { name: /^Arm for/ }).click();
  await place.getByText(/expires in 10:00|expires in 9:5\d/).waitFor();
  await place.getByRole('button', { name: /^Stop at block end/ }).click();
  await place.getByText(/stops at the next block end/).waitFor();
  await place.getByText('stopped by a person at a block end').waitFor();
  await place.getByRole('button', { name: /^Resume, job/ }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Resume' }).click();
  await place.getByText('held by DC3', { exact: true }).waitFor();
  await place.getByRole('button', { name: /^Resume as if DC1/ }).click();
  const dialog = page.getByRole('dialog');
  const send = dialog.getByRole('button', { name: 'Resume as if DC1' });
  expect(await send.isDisabled(), 'no "as if DC1" without a reason');
  await dialog.getByRole('textbox').fill('DC1 lost in the cable');
  await shot(page, 'as-if-dc1');
  await send.click();
  await place.getByText(/done/).waitFor({ timeout: 30_000 });
  expect(true, 'stopped, resumed, held, resumed as if DC1, done');

  await place.getByRole('button', { name: 'Arm, job 43' }).click();
  await dialog.getByRole('button', { name: /^Arm for/ }).click();
  await place.getByRole('button', { name: /^Disarm|^Cancel at block end/ }).first().click();
  if (await dialog.isVisible()) await dialog.getByRole('button', { name: 'Cancel at block end' }).click();
  await place.getByText(/cancelled/).waitFor();
  expect(true, 'an armed job can be taken back');
}

async function received(page, mock) {
  await signIn(page, mock.url, 'admin');
  await page.getByRole('link', { name: 'Received' }).click();
  const row = (id) => page.locator(`[data-receipt="${id}"]`);
  await row(3).getByText('in quarantine').waitFor();
  expect(await row(3).getByText('its end is missing').isVisible(), 'a receipt in quarantine says why');
  const readable = await row(3).getByRole('link', { name: 'What can be read' }).getAttribute('href');
  expect(readable === '/api/v1/receipts/3/text?form=read', 'what can be read of it is shown');
  expect(await row(2).getByText(/differs from rev. 2: line 3, column 4/).isVisible(), 'a difference is named');
  await row(2).getByRole('button', { name: 'Accept receipt 2' }).click();
  const dialog = page.getByRole('dialog');
  await dialog.getByText(/becomes revision 3 of program 7/).waitFor();
  await dialog.getByRole('button', { name: 'Accept' }).click();
  await row(2).getByText('program 7 rev. 3').waitFor();
  await row(3).getByRole('button', { name: 'Take receipt 3 out of quarantine' }).click();
  await dialog.getByText(/It is in quarantine: its end is missing/).waitFor();
  expect(await dialog.getByRole('button', { name: 'Accept' }).isDisabled(), 'nothing leaves the quarantine without a reason');
  await dialog.getByRole('button', { name: 'Back' }).click();
  await row(3).getByRole('button', { name: 'Discard receipt 3' }).click();
  expect(await dialog.getByRole('button', { name: 'Discard' }).isDisabled(), 'nothing is discarded without a reason');
  await dialog.getByRole('textbox').fill('torn, punched again');
  await dialog.getByRole('button', { name: 'Discard' }).click();
  await row(3).getByText('torn, punched again').waitFor();
  await shot(page, 'received');
  expect((await row(3).getByRole('button').count()) === 0, 'what is decided is decided');
}

async function viewerLooksOnly(page, mock) {
  await signIn(page, mock.url, 'viewer');
  await card(page, 'mill-2').waitFor();
  for (const view of ['machines', 'jobs', 'releases', 'received', 'jobs/41']) {
    await page.goto(`${mock.url}/#/${view}`);
    await page.getByRole('heading', { level: 1 }).waitFor();
    await page.waitForTimeout(200);
    const labels = await page.getByRole('button').allInnerTexts();
    const orders = labels.filter((label) => !/^(Sign out|Show older jobs|Show the next 50 rows)$/.test(label));
    expect(orders.length === 0, `a viewer has no order under ${view} (${orders.join(', ') || 'none'})`);
  }
}

async function narrowScreen(page, mock) {
  await signIn(page, mock.url, 'operator');
  for (const view of ['machines', 'jobs', 'releases', 'received', 'jobs/38']) {
    await page.goto(`${mock.url}/#/${view}`);
    await page.waitForTimeout(300);
    const over = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    expect(over <= 0, `nothing is wider than the screen under ${view}`);
    await shot(page, `narrow-${view.replace('/', '-')}`);
  }
}

async function keyboardAlone(page, mock) {
  await page.goto(mock.url);
  await page.getByLabel('Token').focus();
  await page.keyboard.type('operator');
  await page.keyboard.press('Enter');
  await card(page, 'lathe-1').waitFor();
  const arm = card(page, 'lathe-1').getByRole('button', { name: 'Arm, job 42' });
  const focused = () => arm.evaluate((button) => button === document.activeElement);
  for (let i = 0; i < 40 && !(await focused()); ++i) await page.keyboard.press('Tab');
  expect(await focused(), 'the Arm button is reached by Tab');
  await page.keyboard.press('Enter');
  await page.getByRole('dialog').waitFor();
  const inside = () => page.evaluate(() => document.querySelector('dialog').contains(document.activeElement));
  expect(await inside(), 'the dialog takes the focus');
  await page.keyboard.press('Escape');
  await page.getByRole('dialog').waitFor({ state: 'detached' });
  expect(await focused(), 'Escape gives the focus back to the button');
}

async function emptyServer() {
  const mock = await startMock(0, { empty: true });
  try {
    await withPage({}, async (page) => {
      await signIn(page, mock.url, 'admin');
      await page.getByText(/No machine is set up yet/).waitFor();
      await page.getByRole('link', { name: 'Jobs' }).click();
      await page.getByText(/No job yet/).waitFor();
      await page.getByRole('link', { name: 'New job' }).first().click();
      await page.getByText(/Nothing is proving or approved/).waitFor();
      await page.getByRole('link', { name: 'Received' }).click();
      await page.getByText(/Nothing was received yet/).waitFor();
      expect(true, 'an empty server says what is missing');
    });
  } finally {
    await mock.close();
  }
}

await main([
  ['the connection is lost', against({}, lostConnection)],
  ['the stream is cut', against({}, cutStream)],
  ['a torn block', against({}, tornBlock)],
  ['holds and stops', against({}, holdsAndStops)],
  ['what was received', against({}, received)],
  ['a viewer', against({}, viewerLooksOnly)],
  ['a narrow screen', against({ viewport: { width: 360, height: 740 } }, narrowScreen)],
  ['a keyboard alone', against({}, keyboardAlone)],
  ['nothing there yet', emptyServer],
]);
