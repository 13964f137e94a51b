// The floor against the real server, with controls that are played by hand: what an operator, a shift leader and a
// newcomer do, and each fault that was once seen there.
import { Person, accessible, card, expect, focused, live, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1280, height: 800 } };
const kTablet = { viewport: { width: 820, height: 1180 }, hasTouch: true };
const kPhone = { viewport: { width: 360, height: 740 }, hasTouch: true };
const { url, tokens } = await rig.base();

const order = (page, machine, name) => card(page, machine).getByRole('button', { name });
const standing = (page, machine, value) => until(async () => (await card(page, machine).getAttribute('data-standing')) === value, `${machine} is ${value}`, 20_000);
const dialog = (page) => page.getByRole('dialog');
const isOff = (locator) => locator.getAttribute('aria-disabled').then((value) => value === 'true');

async function arm(page, machine, job, person = new Person()) {
  await person.click(order(page, machine, `Arm, job ${job}`));
  await person.click(dialog(page).getByRole('button', { name: /^Arm for/ }));
  await dialog(page).waitFor({ state: 'detached' });
}

// Arm, watch, stop, resume, done. The Resume is the one that never came on the real server.
async function operator(page) {
  const [job] = await rig.machine('operator', { blocks: 600 });
  await signIn(page, url, tokens.operator);
  const person = new Person();
  await arm(page, 'operator', job, person);
  await standing(page, 'operator', 'armed');
  await soon(async () => (await focused(page)) !== 'BODY', 'after arming the focus is somewhere');
  await soon(() => card(page, 'operator').getByText(/press START at the control/).isVisible(), 'it says who acts next');
  await card(page, 'operator').getByText(/9:\d\d left|10:00 left/).waitFor();
  await shot(page, 'operator-armed');
  await accessible(page, 'an armed machine');
  await rig.say('operator', 'dc1');
  await standing(page, 'operator', 'feeding');
  await card(page, 'operator').getByText(/% sent/).waitFor();
  await card(page, 'operator').getByText(/line \d+ of \d+/).waitFor();
  await shot(page, 'operator-feeding');
  await accessible(page, 'a feeding machine');
  await person.click(order(page, 'operator', `Stop at block end, job ${job}`));
  await standing(page, 'operator', 'stopped');
  const at = await rig.got('operator');
  await soon(() => isOff(order(page, 'operator', 'Stop')), 'stopped: there is nothing more to stop');
  await accessible(page, 'a stopped machine');
  await person.click(order(page, 'operator', `Resume, job ${job}`));
  await soon(async () => (await rig.got('operator')) === at, 'an open dialog resumes nothing');
  await person.click(dialog(page).getByRole('button', { name: 'Resume' }));
  await standing(page, 'operator', 'feeding');
  await until(async () => (await rig.got('operator')) > at + 200, 'the feed goes on at the line');
  await card(page, 'operator').getByText(new RegExp(`Last: job ${job}, done`)).waitFor({ timeout: 60_000 });
  console.log(`  operator: arm, stop, resume, done in ${person.steps} steps`);
}

async function overModbus(page) {
  const [job] = await rig.plc('plc', { blocks: 600 });
  await signIn(page, url, tokens.operator);
  await arm(page, 'plc', job);
  await standing(page, 'plc', 'feeding');
  await order(page, 'plc', `Stop at block end, job ${job}`).click();
  await standing(page, 'plc', 'stopped');
  await order(page, 'plc', `Resume, job ${job}`).click();
  await dialog(page).getByRole('button', { name: 'Resume' }).click();
  await standing(page, 'plc', 'feeding');
  expect(true, 'a mailbox is stopped and resumed from the page');
  await order(page, 'plc', `Cancel, job ${job}`).click();
  await dialog(page).getByRole('button', { name: 'Cancel at block end' }).click();
  await card(page, 'plc').getByText(new RegExp(`Last: job ${job}, cancelled`)).waitFor({ timeout: 30_000 });
}

// A control whose buffer fills a hundred times: Stop stands where it stood, and a tap at its place hits it.
async function stillStop(page) {
  const [job] = await rig.machine('still', { blocks: 2000 });
  await signIn(page, url, tokens.operator);
  await arm(page, 'still', job);
  await page.evaluate(() => {
    window.places = new Set();
    window.states = [];
    const look = () => {
      const stop = document.querySelector('[aria-label="Machine still"] .order-stop');
      if (stop) window.places.add(JSON.stringify(stop.getBoundingClientRect()));
      const now = document.querySelector('[aria-label="Machine still"]')?.dataset.standing;
      if (window.states.at(-1) !== now) window.states.push(now);
      requestAnimationFrame(look);
    };
    look();
  });
  await rig.say('still', 'dc1');
  await standing(page, 'still', 'feeding');
  await page.evaluate(() => {
    window.shifts = [];
    new PerformanceObserver((list) => {
      // Below that it is a part of a pixel, whose moves are not seen.
      for (const { value, sources } of list.getEntries().filter((entry) => entry.value > 0.0001))
        window.shifts.push(`${value} by ${sources.map(({ node }) => node?.className || node?.nodeName).join(' ')}`);
    }).observe({ type: 'layout-shift', buffered: false });
  });
  await rig.holdOften('still', 100);
  const seen = await page.evaluate(() => ({ places: [...window.places], shifts: window.shifts, states: window.states }));
  expect(seen.places.length === 1, `Stop had one place in 100 holds: ${seen.places.join(' ')}`);
  expect(seen.shifts.length === 0, `nothing shifted: ${seen.shifts.join('; ') || 'nothing'}`);
  expect(seen.states.filter((state) => state === 'feeding').length === 1, `holds do not flicker: ${seen.states.join(', ')}`);
  const { height } = JSON.parse(seen.places[0]);
  expect(height >= 56, `Stop is ${height} px high`);
  const box = await order(page, 'still', /^Stop/).boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await standing(page, 'still', 'stopped');
  await order(page, 'still', `Cancel, job ${job}`).click();
  await dialog(page).getByRole('button', { name: 'Cancel at block end' }).click();
  await card(page, 'still').getByText(new RegExp(`Last: job ${job}, cancelled`)).waitFor();
}

// The countdown is the server's, and an expiry is stated.
async function expiry(page) {
  const [job] = await rig.machine('expiry');
  await signIn(page, url, tokens.operator);
  const armed = await rig.call('POST', `/jobs/${job}/arm`, { minutes: 0.1 }, 'operator');
  expect(armed.status === 200, `armed by the API: ${JSON.stringify(armed.body)}`);
  await card(page, 'expiry').getByText(/0:0\d left/).waitFor();
  await card(page, 'expiry').getByText(/the arming expired/).waitFor({ timeout: 20_000 });
  await soon(async () => (await rig.got('expiry')) === 0, 'nothing was sent');
}

// A control that asks with nothing armed is a state of its card, not a flood of alarms.
async function asks(page) {
  const [job] = await rig.machine('asks');
  await signIn(page, url, tokens.operator);
  for (let i = 0; i < 20; ++i) await rig.say('asks', 'dc1');
  await standing(page, 'asks', 'asks');
  await soon(() => card(page, 'asks').getByText(`The control asks for a program: arm job ${job}?`).isVisible(), 'the card asks for the job');
  const open = await rig.call('GET', '/alarms?state=open&machine=asks');
  expect(open.body.items.length === 0, 'and no alarm was raised');
  await page.getByRole('navigation', { name: 'Needs a person' }).getByText('asks', { exact: true }).waitFor();
}

async function torn(page) {
  const [job] = await rig.machine('torn', { blocks: 400 });
  await signIn(page, url, tokens.operator);
  await arm(page, 'torn', job);
  await rig.say('torn', 'dc1');
  await standing(page, 'torn', 'feeding');
  await rig.tear('torn');
  await standing(page, 'torn', 'torn');
  await until(async () => /^\(\d+\) /.test(await page.title()), 'the title counts the alarm');
  await page.getByRole('link', { name: 'Jobs' }).click();
  const bell = page.getByRole('button', { name: /\d+ alarms?$/ });
  await bell.click();
  const tray = page.getByRole('region', { name: 'Alarms' });
  const item = tray.locator('.alarm', { hasText: 'torn' }).filter({ hasText: 'block' }).first();
  await item.waitFor();
  await shot(page, 'torn-tray');
  await accessible(page, 'the tray');
  await soon(async () => (await item.getByRole('button', { name: /^Shelve/ }).count()) === 0, 'a torn block cannot be shelved');
  await item.getByRole('button', { name: /^Acknowledge/ }).click();
  await item.waitFor({ state: 'detached' });
  await soon(async () => (await focused(page)) !== 'BODY', 'after acknowledging the focus is somewhere');
  await page.keyboard.press('Escape');
  await page.getByRole('link', { name: 'Floor' }).click();
  await shot(page, 'torn-card');
  await order(page, 'torn', 'I have reset the control of torn').click();
  const confirm = dialog(page).getByRole('button', { name: 'I have reset the control' });
  await soon(() => confirm.isDisabled(), 'no confirmation without a reason');
  await dialog(page).getByRole('textbox').fill('RESET pressed, tool retracted by hand');
  await confirm.click();
  await until(async () => (await card(page, 'torn').getAttribute('data-line')) !== 'torn', 'the line is whole');
  await until(async () => (await rig.call('GET', '/alarms?state=open&machine=torn')).body.items.every((one) => one.kind !== 'torn_block'), 'the alarm is closed');
  await page.goto(`${url}/#/jobs/${job}`);
  await page.getByText(/reset confirmed by the operator: RESET pressed/).waitFor();
  await page.goto(`${url}/#/alarms`);
  await page.getByRole('region', { name: 'History' }).locator('.alarm', { hasText: 'torn' }).first().waitFor();
  await shot(page, 'alarms');
  await accessible(page, 'the alarms');
}

// A dialog stays while another person acts, and states why its order is blocked.
async function dialogStays(page) {
  const [job] = await rig.machine('dialog');
  await signIn(page, url, tokens.operator);
  await order(page, 'dialog', `Arm, job ${job}`).click();
  await dialog(page).waitFor();
  await rig.call('POST', `/jobs/${job}/cancel`, {}, 'admin');
  await dialog(page).getByText(/Not now: job \d+ is cancelled/).waitFor();
  await soon(() => dialog(page).getByRole('button', { name: /^Arm for/ }).isDisabled(), 'it arms nothing');
  await page.keyboard.press('Escape');
  await dialog(page).waitFor({ state: 'detached' });
  await soon(async () => (await focused(page)) === 'BUTTON', 'the focus goes back to the button');
}

async function sessions(page, context) {
  await rig.machine('sessions', { jobs: 0 });
  const anna = await rig.token('operator', 'anna');
  const ben = await rig.token('operator', 'ben');
  await signIn(page, url, anna);
  const other = await context.newPage();
  await other.goto(url);
  await live(other);
  await soon(() => other.getByText('anna').first().isVisible(), 'a second tab is signed in as the first');
  await other.locator('.who summary').click();
  await other.getByRole('button', { name: 'Sign out' }).click();
  await page.getByLabel('Token').waitFor();
  expect(true, 'signed out in one tab, signed out in all');
  await other.getByLabel('Token').fill(ben);
  await other.keyboard.press('Enter');
  await live(page);
  await soon(() => page.locator('.who').getByText('ben').isVisible(), 'the first tab shows who signed in in the second');
  await rig.restart();
  await live(page);
  await card(page, 'sessions').waitFor();
  expect(true, 'a restart of the server signs nobody out');
  await rig.revoke('ben');
  await page.getByText(/The session is over/).waitFor();
  expect(true, 'a revoked token ends its session');
}

// A person of one group of machines: orders stand where the role lets them, and nowhere else.
async function signsInByPin(page) {
  const [job] = await rig.machine('pin-own', { jobs: 1 });
  const [other] = await rig.machine('pin-other', { jobs: 1 });
  await rig.call('PUT', '/groups/own', { machines: ['pin-own'] });
  await rig.call('POST', '/users', { name: 'petra', role: 'viewer', grants: [{ group: 'own', role: 'operator' }] });
  await rig.call('PUT', '/users/petra/pin', { secret: '2903' });
  await page.goto(url);
  await page.getByRole('button', { name: 'PIN', exact: true }).click();
  await page.getByLabel('Name').fill('petra');
  await page.getByLabel('Your PIN').fill('0000');
  await page.keyboard.press('Enter');
  await page.getByText('the name or the pin is wrong').waitFor();
  await accessible(page, 'the sign-in by PIN');
  await shot(page, 'sign-in-pin');
  await page.getByLabel('Your PIN').fill('2903');
  await page.keyboard.press('Enter');
  await live(page);
  await soon(() => page.locator('.who').getByText('petra').isVisible(), 'a PIN signs a person in');
  await order(page, 'pin-own', `Arm, job ${job}`).waitFor();
  await soon(async () => (await order(page, 'pin-other', `Arm, job ${other}`).count()) === 0, 'no order on a machine of another group');
}

async function addresses(page) {
  const [job] = await rig.machine('addresses');
  await signIn(page, url, tokens.viewer);
  await page.goto(`${url}/jobs/${job}`);
  await page.getByRole('heading', { name: `Job ${job}` }).waitFor();
  expect(page.url() === `${url}/#/jobs/${job}`, `a path that is typed is found: ${page.url()}`);
  await until(async () => (await page.title()).endsWith(`Job ${job} – dripfeed`), 'the title names the job');
  await page.goto(`${url}/#/nowhere`);
  await page.getByRole('heading', { name: 'Not found' }).waitFor();
  await page.goto(`${url}/#/machines/no-such-machine`);
  await page.getByText('There is no machine no-such-machine.').waitFor();
  await page.goto(`${url}/#/jobs/999999`);
  await page.getByText('There is no job 999999.').waitFor();
  await page.getByRole('link', { name: 'Go to the floor' }).click();
  await card(page, 'addresses').waitFor();
}

// The shift leader: what needs a person, the order of a queue, the history.
async function shiftLeader(page) {
  const jobs = await rig.machine('leader', { jobs: 4, blocks: 40 });
  await signIn(page, url, tokens.operator);
  const person = new Person();
  await person.click(page.getByRole('link', { name: 'leader', exact: true }));
  await page.getByRole('heading', { level: 1, name: 'leader' }).waitFor();
  const row = (id) => page.locator(`[data-job="${id}"]`);
  const shown = () => page.locator('.queue-list li').evaluateAll((rows) => rows.map((one) => Number(one.dataset.job)));
  const queue = async (...wanted) => until(async () => JSON.stringify(await shown()) === JSON.stringify(wanted.map((i) => jobs[i])), `the queue is ${wanted}`);
  await queue(0, 1, 2, 3);
  await person.click(row(jobs[3]).getByRole('button', { name: `Move job ${jobs[3]} up` }));
  await queue(0, 1, 3, 2);
  await soon(async () => (await focused(page)) === 'BUTTON', 'the focus stays at the button that moved the row');
  await row(jobs[2]).dragTo(row(jobs[0]));
  await queue(2, 0, 1, 3);
  await page.reload();
  await queue(2, 0, 1, 3);
  expect(true, 'the order is the server’s');
  await shot(page, 'machine-queue');
  await accessible(page, 'a machine');
  await person.click(page.getByRole('link', { name: 'Floor' }));
  await arm(page, 'leader', jobs[2], person);
  await rig.say('leader', 'dc1');
  await card(page, 'leader').getByText(new RegExp(`Last: job ${jobs[2]}, done`)).waitFor({ timeout: 30_000 });
  await page.goto(`${url}/#/machines/leader`);
  await page.getByText(/Last job: 1 done/).waitFor();
  await page.getByRole('region', { name: 'Use of the last 7 days' }).getByText('1 done, 0 failed').waitFor();
  await shot(page, 'machine-history');
  console.log(`  shift leader: reorder and arm in ${person.steps} steps`);
}

// The blocks of the running program stand around the one that is sent.
async function runningBlock(page) {
  const [job] = await rig.machine('blocks', { blocks: 600 });
  await signIn(page, url, tokens.operator);
  await arm(page, 'blocks', job);
  await rig.say('blocks', 'dc1');
  await page.goto(`${url}/#/machines/blocks`);
  const list = page.getByRole('list', { name: 'Running block and its neighbours' });
  await list.locator('[aria-current="true"]').waitFor();
  const before = Number(await list.locator('[aria-current="true"] .block-line').innerText());
  await until(async () => Number(await list.locator('[aria-current="true"] .block-line').innerText().catch(() => '0')) > before + 20, 'the block moves on', 20_000);
  await soon(async () => (await list.getByRole('listitem').count()) >= 10, 'it stands within its neighbours');
  await shot(page, 'machine-blocks');
  await page.getByRole('button', { name: `Stop at block end, job ${job}` }).click();
  await until(async () => (await page.locator('.machine-view').getAttribute('data-standing')) === 'stopped', 'stopped from the machine’s view');
  await page.getByRole('button', { name: `Cancel, job ${job}` }).click();
  await dialog(page).getByRole('button', { name: 'Cancel at block end' }).click();
  await page.getByText(new RegExp(`Last: job ${job}, cancelled`)).waitFor();
}

async function received(page) {
  await rig.machine('punch', { jobs: 0 });
  await signIn(page, url, tokens.approver);
  await page.getByRole('link', { name: 'Received' }).click();
  await page.getByRole('heading', { level: 1, name: 'Received' }).waitFor();
  await rig.punch('punch', '%\nO0077(BUSH)\nG0X1.\nM30\n%\n');
  const row = page.locator('[data-receipt]').first();
  await row.getByText('waits for a decision').waitFor({ timeout: 20_000 });
  expect(true, 'what a control punches appears by itself');
  await row.getByRole('button', { name: /^Accept receipt/ }).click();
  await dialog(page).locator('pre').getByText('O0077(BUSH)').waitFor();
  expect(true, 'its text stands in the dialog that accepts it');
  await accessible(page, 'the dialog of a receipt');
  await dialog(page).getByRole('button', { name: 'Accept' }).click();
  await row.getByText('accepted').waitFor();
  await shot(page, 'received');
}

async function viewer(page) {
  const [job] = await rig.machine('viewer');
  await signIn(page, url, tokens.viewer);
  const buttons = card(page, 'viewer').locator('.order');
  await soon(async () => (await buttons.count()) === 3, 'the places of the orders are there');
  for (const button of await buttons.all()) expect(await isOff(button), `a viewer cannot: ${await button.innerText()}`);
  for (const view of ['machines/viewer', 'jobs', `jobs/${job}`, 'releases', 'received', 'alarms']) {
    await page.goto(`${url}/#/${view}`);
    await page.getByRole('heading', { level: 1 }).waitFor();
    await page.waitForTimeout(200);
    const enabled = page.locator('main button:not([aria-disabled="true"], .sort, .arrange *)'); // what changes the view of the browser alone is not an order
    const labels = (await enabled.allInnerTexts()).filter((label) => !/^(Show|Export as CSV$)/.test(label));
    expect(labels.length === 0, `a viewer has no order under ${view} (${labels.join(', ') || 'none'})`);
  }
}

// More queued jobs than a page of the server's list holds.
async function manyJobs(page) {
  const jobs = await rig.machine('many', { jobs: 230, blocks: 5 });
  await signIn(page, url, tokens.operator);
  await card(page, 'many').getByText('230 jobs queued').waitFor();
  await order(page, 'many', `Arm, job ${jobs[0]}`).waitFor();
  expect(true, 'the oldest of 230 queued jobs is there and can be armed');
}

async function lost(page) {
  const [job] = await rig.machine('lost', { blocks: 600 });
  await signIn(page, url, tokens.operator);
  await arm(page, 'lost', job);
  await rig.say('lost', 'dc1');
  await standing(page, 'lost', 'feeding');
  await order(page, 'lost', /^Stop/).waitFor(); // the card knows its job
  await rig.killServer();
  await page.getByText(/connection to the server is lost/).waitFor();
  await shot(page, 'lost');
  await soon(() => card(page, 'lost').getByText('last known: feeding').isVisible(), 'a state is named as the last known');
  await order(page, 'lost', /^Stop/).click();
  await card(page, 'lost').getByText(/Whether the order took effect is not known/).waitFor({ state: 'attached' });
  expect(true, 'an order without an answer says that its effect is not known');
  await accessible(page, 'a lost connection');
  await rig.startServer();
  await live(page);
  expect(true, 'it finds the server again and is still signed in');
}

async function keyboard(page) {
  const [job] = await rig.machine('keys', { blocks: 600 });
  await page.goto(url);
  await page.getByLabel('Token').waitFor();
  await page.keyboard.type(tokens.operator);
  await page.keyboard.press('Enter');
  await live(page);
  const reach = async (locator, what) => {
    for (let i = 0; i < 200; ++i) {
      if (await locator.evaluate((one) => one === document.activeElement).catch(() => false)) return;
      await page.keyboard.press('Tab');
    }
    throw new Error(`not reached by Tab: ${what}`);
  };
  await reach(order(page, 'keys', `Arm, job ${job}`), 'Arm');
  await page.keyboard.press('Enter');
  await reach(dialog(page).getByRole('button', { name: /^Arm for/ }), 'the dialog’s Arm');
  await page.keyboard.press('Enter');
  await standing(page, 'keys', 'armed');
  await rig.say('keys', 'dc1');
  await standing(page, 'keys', 'feeding');
  await reach(order(page, 'keys', `Stop at block end, job ${job}`), 'Stop');
  await page.keyboard.press('Enter');
  await standing(page, 'keys', 'stopped');
  await soon(async () => (await focused(page)) === 'BUTTON', 'after the stop the focus is at its button');
  await reach(order(page, 'keys', `Resume, job ${job}`), 'Resume');
  await page.keyboard.press('Enter');
  await reach(dialog(page).getByRole('button', { name: 'Resume' }), 'the dialog’s Resume');
  await page.keyboard.press('Enter');
  await standing(page, 'keys', 'feeding');
  expect(true, 'armed, stopped and resumed by the keyboard alone');
  await page.keyboard.press('Tab');
}

// Nothing is wider than the screen, and axe finds nothing, in every view and colour scheme.
const everywhere = (name) => async (page) => {
  await rig.machine(`wide-${name}`, { jobs: 2 });
  await signIn(page, url, tokens.admin);
  for (const view of ['floor', 'floor?look=compact', 'floor?look=andon', `machines/wide-${name}`, 'jobs', 'releases', 'received', 'alarms', 'nowhere']) {
    await page.goto(`${url}/#/${view}`);
    await page.waitForTimeout(300);
    const over = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    expect(over <= 0, `nothing is wider than the screen under ${view} (${over})`);
    await accessible(page, view);
    await shot(page, `${name}-${view.replace(/[^a-z]+/g, '-')}`);
  }
};

async function german(page) {
  await rig.machine('deutsch', { jobs: 1 });
  await signIn(page, url, tokens.operator);
  await page.locator('.who summary').click();
  await page.getByLabel('Language').selectOption('de');
  await page.getByRole('heading', { level: 1, name: 'Halle' }).waitFor();
  await soon(async () => (await page.locator('html').getAttribute('lang')) === 'de', 'the page names its language');
  await shot(page, 'german');
  await page.reload();
  await page.getByRole('heading', { level: 1, name: 'Halle' }).waitFor();
  expect(true, 'the choice stays');
}

// A badge's QR code signs in and leaves no trace in the address; a tablet belongs to one machine.
async function badgeAndStation(page) {
  const [job] = await rig.machine('station', { blocks: 40 });
  await page.goto(`${url}/#/badge/${encodeURIComponent(tokens.operator)}`);
  await live(page);
  expect(!page.url().includes(tokens.operator), `the token is gone from the address: ${page.url()}`);
  await page.goBack().catch(() => undefined);
  expect(!page.url().includes(tokens.operator), 'and from the history');
  await page.goto(`${url}/#/machines/station`);
  await page.getByLabel(/This screen belongs to this machine/).check();
  await soon(async () => !(await page.getByRole('navigation', { name: 'Views' }).isVisible()), 'the rest of the page steps back');
  await page.reload();
  await live(page);
  expect(page.url().endsWith('#/machines/station?station=1'), `it stays so: ${page.url()}`);
  await soon(async () => !(await page.getByRole('navigation', { name: 'Views' }).isVisible()), 'also after a reload');
  await page.getByRole('button', { name: `Arm, job ${job}` }).click();
  await dialog(page).getByRole('button', { name: /^Arm for/ }).click();
  await dialog(page).waitFor({ state: 'detached' });
  await rig.say('station', 'dc1');
  await page.getByText(`Last: job ${job}, done`).waitFor({ timeout: 30_000 });
  await accessible(page, 'a station');
  await shot(page, 'station');
  await page.goto(`${url}/#/badge/wrong-token`);
  await dialog(page).getByText('this token is not valid').waitFor();
  await page.keyboard.press('Escape');
  await soon(() => page.locator('.who').getByText('the operator').isVisible(), 'a wrong badge changes nothing');
  await page.goto(`${url}/#/badge/${encodeURIComponent(tokens.programmer)}`);
  await page.locator('.who').getByText('the programmer').waitFor();
  await live(page);
  expect(page.url().endsWith('#/floor'), 'another badge is another person, and leaves no trace either');
}

// A job that a person ended in the middle: the restart is shown, made, released for one transfer and queued; the control gets nothing by that.
async function restartAtLine(page) {
  const [job] = await rig.machine('restart', { blocks: 400 });
  await signIn(page, url, tokens.admin);
  await arm(page, 'restart', job);
  await rig.say('restart', 'dc1');
  await standing(page, 'restart', 'feeding');
  await until(async () => (await rig.got('restart')) > 600, 'some blocks are sent');
  await order(page, 'restart', `Cancel, job ${job}`).click();
  await dialog(page).getByRole('button', { name: 'Cancel at block end' }).click();
  await card(page, 'restart').getByText(new RegExp(`Last: job ${job}, cancelled`)).waitFor();
  const got = await rig.got('restart');
  await page.goto(`${url}/#/jobs/${job}`);
  const place = page.getByRole('region', { name: 'Restart at a line' });
  const line = place.getByLabel('Line of the program');
  expect(Number(await line.inputValue()) > 7, `it proposes the line of the job's end: ${await line.inputValue()}`);
  await line.fill('3');
  await place.getByRole('button', { name: 'Show the restart' }).click();
  await line.fill('12');
  await place.getByRole('button', { name: 'Show the restart' }).click();
  await place.getByText('(RESTART AT LINE 12)').first().waitFor();
  const make = place.getByRole('button', { name: 'Make it a release' });
  await soon(() => isOff(make), 'what was not read is not made');
  await accessible(page, 'a restart');
  await shot(page, 'restart');
  await place.getByLabel(/I have read the new lines/).check();
  await make.click();
  await place.getByText(/^Release \d+: /).waitFor();
  const release = place.getByRole('button', { name: 'Release it for one transfer' });
  if (await release.isVisible()) {
    await release.click();
    await place.getByRole('button', { name: 'Queue the restart' }).click();
    await place.getByText(/Queued as job/).waitFor();
    await shot(page, 'restart-queued');
  } else {
    await soon(() => place.getByText(/Its verdict does not clear it yet/).isVisible(), 'it says what is to be done');
  }
  await soon(async () => (await rig.got('restart')) === got, 'nothing of it was sent');
}

// A person's own arrangement of a machine's view; a tablet at the machine has none to change.
async function arrange(page) {
  await rig.machine('arranged', { jobs: 1 });
  await signIn(page, url, tokens.operator);
  await page.goto(`${url}/#/machines/arranged`);
  const order = () => page.locator('.machine-parts > div').evaluateAll((columns) => columns.map((column) => [...column.querySelectorAll('[data-part]')].map((part) => part.dataset.part).join()));
  await page.getByText('Arrange this view').waitFor();
  expect((await order()).join(' | ') === 'on_line,stops,queue,line,history | alarms,use,calibration', `at first: ${await order()}`);
  await page.getByText('Arrange this view').click();
  await soon(() => page.getByRole('checkbox', { name: 'Alarms' }).isDisabled(), 'alarms cannot be hidden');
  await page.getByRole('button', { name: 'Queue up' }).click();
  await page.getByRole('button', { name: 'Other column Use', exact: false }).first().click();
  await page.getByRole('checkbox', { name: 'Calibration' }).uncheck();
  const own = 'on_line,use,queue,stops,line,history | alarms';
  expect((await order()).join(' | ') === own, `arranged: ${await order()}`);
  await accessible(page, 'an arranged view');
  await shot(page, 'machine-arranged');
  await page.reload();
  await live(page);
  await page.locator('[data-part="history"]').waitFor({ state: 'attached' });
  await soon(async () => (await order()).join(' | ') === own, 'it outlives a reload');
  await page.goto(`${url}/#/machines/arranged?station=1`);
  await page.getByLabel(/This screen belongs to this machine/).waitFor();
  await soon(async () => (await page.getByText('Arrange this view').count()) === 0, 'a tablet at the machine changes none of it');
  await page.goto(`${url}/#/machines/arranged`);
  await page.getByText('Arrange this view').click();
  await page.getByRole('button', { name: 'Reset the arrangement' }).click();
  await soon(async () => (await order()).join(' | ') === 'on_line,stops,queue,line,history | alarms,use,calibration', 'and back');
}

await main([
  ['restart at a line', () => withPage(kDesk, restartAtLine)],
  ['operator', () => withPage(kDesk, operator)],
  ['modbus', () => withPage(kDesk, overModbus)],
  ['still stop', () => withPage(kTablet, stillStop)],
  ['expiry', () => withPage(kDesk, expiry)],
  ['asks', () => withPage(kDesk, asks)],
  ['torn', () => withPage(kDesk, torn)],
  ['dialog stays', () => withPage(kDesk, dialogStays)],
  ['addresses', () => withPage(kDesk, addresses)],
  ['shift leader', () => withPage(kDesk, shiftLeader)],
  ['running block', () => withPage(kDesk, runningBlock)],
  ['received', () => withPage(kDesk, received)],
  ['viewer', () => withPage(kDesk, viewer)],
  ['signs in by PIN', () => withPage(kDesk, signsInByPin)],
  ['keyboard', () => withPage(kDesk, keyboard)],
  ['badge and station', () => withPage(kTablet, badgeAndStation)],
  ['an arrangement of one\'s own', () => withPage(kDesk, arrange)],
  ['german', () => withPage(kDesk, german)],
  ['many jobs', () => withPage(kDesk, manyJobs)],
  ['phone', () => withPage(kPhone, everywhere('phone'))],
  ['tablet, dark', () => withPage({ ...kTablet, colorScheme: 'dark' }, everywhere('tablet'))],
  ['desk', () => withPage(kDesk, everywhere('desk'))],
  ['desk, dark', () => withPage({ ...kDesk, colorScheme: 'dark' }, everywhere('dark'))],
  ['sessions', () => withPage(kDesk, sessions)],
  ['lost', () => withPage(kDesk, lost)],
]);
