// A planner's work against the real server: orders are added, found, sorted, exported, held and opened; jobs of an
// approved release are queued for them; parts are reported. And the transfers of the past, with their sums.
import { readFile } from 'node:fs/promises';
import { accessible, card, expect, fits, live, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1280, height: 900 } };
const kPhone = { width: 360, height: 740 };
const { url, tokens } = await rig.base();

const dialog = (page) => page.getByRole('dialog');
const only = async (number) => (await rig.call('GET', `/orders?number=${number}`)).body.items[0];

async function saved(page, press) {
  const download = page.waitForEvent('download');
  await press();
  const file = await download;
  return { name: file.suggestedFilename(), lines: (await readFile(await file.path(), 'utf8')).replace(/^\uFEFF/, '').trim().split('\r\n') };
}

async function planner(page) {
  await rig.machine('lathe', { jobs: 0 });
  for (let i = 1; i <= 3; i += 1)
    await rig.call('POST', '/orders', { number: `B-${i}`, part: `P-${4 - i}`, quantity: 10 * i, due_at_ms: Date.now() + (i - 2) * 86_400_000, machine: i === 1 ? 'lathe' : null });
  await signIn(page, url, tokens.operator);
  await page.getByRole('navigation', { name: 'Views' }).getByRole('link', { name: 'Orders' }).click();
  await page.locator('[data-order]').first().waitFor();
  await soon(async () => (await page.locator('[data-order]').first().innerText()).includes('B-1'), 'the soonest comes first');
  await soon(() => page.locator('[data-order]').first().getByText('late').isVisible(), 'and says that it is late');

  await page.getByRole('button', { name: 'Add an order' }).click();
  await dialog(page).getByLabel('Number of the planner').fill('A-77');
  await dialog(page).getByLabel('Part', { exact: true }).fill('=R-7');
  await dialog(page).getByLabel('Good parts that are wanted').fill('25');
  await dialog(page).getByLabel('Machine').selectOption('lathe');
  await dialog(page).getByLabel('Due').fill('2031-05-06T07:30');
  await accessible(page, 'a new order');
  await shot(page, 'orders-new');
  await dialog(page).getByRole('button', { name: 'Add an order' }).click();
  await page.getByRole('heading', { name: 'Order A-77' }).waitFor();
  const order = await only('A-77');
  expect(order.quantity === 25 && order.machine === 'lathe' && new Date(order.due_at_ms).getFullYear() === 2031, 'it is as it was written');

  // A job of a release.
  await page.getByRole('button', { name: 'Queue a job…' }).click();
  await until(async () => (await dialog(page).getByRole('option').count()) > 0 || (await dialog(page).getByText('No release').count()) > 0, 'releases are known');
  if ((await dialog(page).getByRole('option').count()) === 0) {
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Queue a job…' }).click();
  }
  await dialog(page).getByRole('option').first().waitFor({ state: 'attached' });
  await shot(page, 'orders-job');
  await dialog(page).getByRole('button', { name: 'Queue' }).click();
  await page.locator('[data-job][data-state="queued"]').waitFor();
  const { body: jobs } = await rig.call('GET', `/jobs?order=${order.id}`);
  expect(jobs.items.length === 1 && jobs.items[0].state === 'queued', 'the job is queued, and not armed');

  // Parts, hold, open.
  await page.getByRole('button', { name: 'Report parts…' }).click();
  await soon(() => dialog(page).getByRole('button', { name: 'Report them' }).isDisabled(), 'nothing is no report');
  await dialog(page).getByLabel('Good parts').fill('4');
  await dialog(page).getByLabel('Scrap').fill('1');
  await dialog(page).getByRole('button', { name: 'Report them' }).click();
  await page.getByText('4 of 25').waitFor();
  await page.getByRole('button', { name: 'Hold it…' }).click();
  await dialog(page).getByRole('textbox').fill('no material');
  await dialog(page).getByRole('button', { name: 'Hold it' }).click();
  await page.getByText('no material').waitFor();
  await soon(async () => (await only('A-77')).state === 'held', 'it is held');
  await soon(async () => (await page.getByRole('button', { name: 'Queue a job…' }).count()) === 0, 'and takes no job');
  await page.getByRole('button', { name: 'Change the plan…' }).click();
  await dialog(page).getByLabel('Good parts that are wanted').fill('30');
  await dialog(page).getByRole('button', { name: 'Save the plan' }).click();
  await page.getByText('4 of 30').waitFor();
  await page.getByRole('button', { name: 'Open it…' }).click();
  await dialog(page).getByRole('button', { name: 'Open it' }).click();
  await page.getByRole('button', { name: 'Hold it…' }).waitFor();
  await accessible(page, 'an order');
  await shot(page, 'orders-one');

  // Find, sort, export.
  await page.getByRole('link', { name: 'All orders' }).click();
  await page.getByRole('button', { name: 'Part', exact: true }).click();
  const parts = () => page.locator('[data-order] td:nth-child(2)').allInnerTexts();
  await soon(async () => JSON.stringify(await parts()) === JSON.stringify([...(await parts())].sort((a, b) => a.localeCompare(b))), 'sorted by part');
  await page.getByRole('button', { name: 'Part', exact: true }).click();
  await soon(async () => (await page.locator('th[aria-sort="descending"]').count()) === 1, 'and downwards, said to a screen reader');
  await page.getByLabel('Number or part').fill('b-');
  await until(async () => (await page.locator('[data-order]').count()) === 3, 'three of them');
  await page.getByLabel('Number or part').fill('');
  const { name, lines } = await saved(page, () => page.getByRole('button', { name: 'Export as CSV' }).click());
  expect(name === 'orders.csv' && lines.length === 5 && lines[0].startsWith('number,operation,part'), `the file has a row an order (${lines.length})`);
  expect(lines.some((line) => line.startsWith("A-77,,'=R-7,lathe,open,2031-05-06T")), 'a text is no formula');
  await accessible(page, 'orders');
  await shot(page, 'orders');
}

// What a list shows is what its file has.
async function files(page) {
  const program = (await rig.call('POST', '/programs', { name: '=O0444', dialect: 'fanuc', text: 'O0444\nM30\n' })).body;
  await rig.machine('torn', { jobs: 0 });
  await rig.machine('whole', { jobs: 0 });
  await signIn(page, url, tokens.admin);
  await page.goto(`${url}/#/library?q=O0444`);
  await page.getByRole('link', { name: '=O0444', exact: true }).waitFor();
  const csv = () => page.getByRole('button', { name: 'Export as CSV' });
  const programs = await saved(page, () => csv().click());
  expect(programs.name === 'programs.csv' && programs.lines.length === 2 && programs.lines[1].startsWith(`${program.id},'=O0444,fanuc,`), `a name is no formula (${programs.lines[1]})`);
  await page.goto(`${url}/#/people/audit`);
  await page.getByRole('table').waitFor();
  const audit = await saved(page, () => csv().click());
  expect(audit.lines[0] === 'seq,at,actor,action,subject,detail,hash' && audit.lines.some((line) => line.includes(',program.add,')), 'the audit, with its hashes');
  await page.goto(`${url}/#/alarms`);
  await page.getByLabel('Machine').selectOption('whole');
  await page.getByText('No open alarm.').waitFor();
  await accessible(page, 'alarms of one machine');
  await shot(page, 'alarms-filtered');
}

async function history(page) {
  const jobs = await rig.machine('past', { jobs: 3 });
  for (const job of jobs.slice(0, 2)) await rig.call('POST', `/jobs/${job}/cancel`);
  await signIn(page, url, tokens.viewer);
  await page.getByRole('navigation', { name: 'Views' }).getByRole('link', { name: 'Jobs', exact: true }).click();
  await page.getByRole('link', { name: /History of transfers/ }).click();
  await page.locator('[data-job]').first().waitFor();
  await soon(async () => (await page.locator('[data-job]').count()) === 2, 'what waits is no history');
  const sums = page.getByRole('region', { name: 'Sums' });
  await soon(async () => /Jobs\s+2/.test(await sums.innerText()) && /cancelled\s+2/i.test(await sums.innerText()), 'sums');
  const { lines } = await saved(page, () => page.getByRole('button', { name: 'Export as CSV' }).click());
  expect(lines.length === 3 && lines[1].includes(',cancelled,'), 'and the file');
  await sums.getByRole('combobox', { name: 'Sums by' }).selectOption({ label: 'Machine' });
  await sums.getByRole('row').filter({ hasText: 'past' }).filter({ hasText: '2' }).waitFor();
  await sums.getByRole('combobox', { name: 'Sums by' }).selectOption({ label: 'Shift' });
  await sums.getByText(/belongs to the shift in which it ended/).waitFor();
  const ofShifts = await saved(page, () => sums.getByRole('button', { name: 'Export as CSV' }).click());
  expect(ofShifts.lines.length >= 2 && ofShifts.lines[0].startsWith('shift,from,to,jobs,done'), `sums by shift, and their file (${ofShifts.lines[0]})`);
  await sums.getByRole('combobox', { name: 'Time' }).selectOption({ label: 'the last 7 days' });
  await until(async () => /Jobs\s+2/.test(await sums.innerText()), 'of the last days');
  await accessible(page, 'the history');
  await shot(page, 'history');
  await page.getByRole('search').getByLabel('State').selectOption('done');
  await page.getByText('No transfer like this.').waitFor();
}

// On hold a job keeps its place, and the next one is offered to be armed.
async function onHold(page, row, id) {
  await row(id).getByRole('button', { name: `Hold… job ${id}` }).first().click();
  await dialog(page).getByLabel('What it waits for').fill('no material');
  await accessible(page, 'a hold');
  await shot(page, 'plans-hold');
  await dialog(page).getByRole('button', { name: 'Put it on hold' }).click();
  await row(id).getByText(/On hold by .*: no material/).waitFor();
  await shot(page, 'plans-on-hold');
  await page.getByText('Ready, 2 jobs wait to be armed').waitFor();
  await soon(async () => (await rig.job(id)).on_hold?.reason === 'no material', 'it is on hold');
  await soon(async () => (await page.getByRole('button', { name: `Arm job ${id}`, exact: true }).count()) === 0, 'what is on hold is not offered');
  await row(id).getByRole('button', { name: `Take off hold… job ${id}` }).first().click();
  await dialog(page).getByRole('button', { name: 'Take it off hold' }).click();
  await until(async () => (await rig.job(id)).on_hold === null, 'it is off hold');
}

// What is planned of jobs: a time, a choice of machines, an end that is confirmed. Nothing is armed by any of it.
async function plans(page) {
  const [model] = await rig.machine('plans', { jobs: 1, blocks: 40 });
  const { release, program } = await rig.job(model);
  await rig.machine('plans2', { jobs: 0 });
  const verdict = (await rig.call('POST', '/checks', { program, machine: 'plans2' })).body;
  if (verdict.verdict !== 'pass') await rig.call('POST', `/checks/${verdict.id}/waivers`, { reason: 'a text of a test' });
  const other = (await rig.call('POST', '/releases', { program, machine: 'plans2' })).body;
  for (const step of [{ to: 'in_review' }, { to: 'proving', transfers: 9 }]) await rig.call('POST', `/releases/${other.id}/transitions`, step);
  const add = async (more) => (await rig.call('POST', '/jobs', { release, ...more })).body.id;
  await rig.call('POST', `/jobs/${model}/cancel`);
  const timed = await add({ not_before_ms: Date.now() + 3_600_000 });
  const checked = await add({ end_check: 'part taken out, chuck closed' });
  await rig.call('PUT', '/groups/both', { machines: ['plans', 'plans2'] });
  const choice = (await rig.call('POST', '/groups/both/jobs', { program })).body;
  await signIn(page, url, tokens.approver);
  await page.goto(`${url}/#/machines/plans`);
  const row = (id) => page.locator(`.queue-list [data-job="${id}"]`);
  await row(timed).getByText(/Not to be armed before/).waitFor();
  await row(checked).getByText('After its end a person confirms: part taken out, chuck closed').waitFor();
  await row(choice.jobs[0].id).getByText(/A choice, also queued for plans2/).waitFor();
  await accessible(page, 'a queue with plans');
  await shot(page, 'plans-queue');
  await row(timed).getByRole('button', { name: `Time… of job ${timed}` }).click();
  await dialog(page).getByLabel(/Not before/).fill('');
  await dialog(page).getByRole('button', { name: 'Set the time' }).click();
  await until(async () => (await rig.job(timed)).not_before_ms === null, 'at any time');
  await onHold(page, row, timed);
  await rig.call('POST', `/jobs/${timed}/schedule`, { not_before_ms: Date.now() + 3_600_000 });
  await row(timed).getByRole('button', { name: 'Arm before its time…' }).click();
  await dialog(page).getByLabel(/Why it is armed before its time/).fill('the customer waits');
  await shot(page, 'plans-early');
  await dialog(page).getByRole('button', { name: /Arm for/ }).click();
  await until(async () => (await rig.job(timed)).state === 'armed', 'armed with a reason');
  await rig.call('POST', `/jobs/${timed}/cancel`);
  await rig.waitLine('plans', 'idle');
  await rig.call('POST', `/jobs/${checked}/arm`, {});
  await rig.say('plans', 'dc1');
  await until(async () => (await rig.job(checked)).state === 'done', 'fed', 20_000);
  const end = page.getByRole('region', { name: 'Queued for plans' }).getByRole('button', { name: `Confirm the end of job ${checked}` });
  await end.waitFor();
  await shot(page, 'plans-end');
  await accessible(page, 'an end that waits');
  // Nothing else is armed there meanwhile: the machine's main order is the confirmation.
  await page.goto(`${url}/#/floor`);
  const plans = card(page, 'plans');
  await plans.getByText('end to confirm').waitFor();
  await soon(() => plans.getByText(`Job ${checked} has ended; to be confirmed: part taken out, chuck closed`).isVisible(), 'the card states what is to be confirmed');
  await soon(async () => (await plans.getByRole('button', { name: /^Arm/ }).count()) === 0, 'and offers no arming');
  await shot(page, 'plans-floor');
  await plans.getByRole('button', { name: `Confirm the end of job ${checked}` }).click();
  await dialog(page).getByText('part taken out, chuck closed').waitFor();
  await dialog(page).getByLabel(/Note/).fill('on the table');
  await dialog(page).getByRole('button', { name: 'I have seen it' }).click();
  await plans.getByRole('button', { name: /^Arm/ }).waitFor();
  await soon(async () => (await rig.job(checked)).end_note === 'on the table', 'the note is kept');
  await page.goto(`${url}/#/jobs/${checked}`);
  await page.getByText(/part taken out, chuck closed: confirmed by/).waitFor();
  await page.getByRole('link', { name: String(release), exact: true }).waitFor();
  await page.getByRole('button', { name: 'Queue again…' }).click();
  await shot(page, 'plans-retry');
  await dialog(page).getByRole('button', { name: 'Queue it again' }).click();
  await page.getByRole('link', { name: `Job ${checked} again` }).waitFor();
  const again = Number(/jobs\/(\d+)/.exec(page.url())[1]);
  await soon(async () => (await rig.job(again)).retry_of === checked && (await rig.job(again)).state === 'queued', 'it is queued, and not armed');
}

// From the page: a choice of a group's machines with a time and an end to confirm, queued at once.
async function planned(page) {
  for (const one of (await rig.call('GET', '/jobs?state=queued&limit=200')).body.items) await rig.call('POST', `/jobs/${one.id}/cancel`);
  await signIn(page, url, tokens.operator);
  await page.goto(`${url}/#/releases`);
  await page.getByRole('row').filter({ hasText: 'plans2' }).getByRole('button', { name: /^Plan a job of release/ }).first().click();
  await dialog(page).getByRole('combobox', { name: /^For/ }).selectOption('both');
  await dialog(page).getByLabel(/Not before/).fill('2031-05-06T07:30');
  await dialog(page).getByLabel(/To be confirmed after its end/).fill('part measured');
  await accessible(page, 'a job that is planned');
  await shot(page, 'plans-new');
  await dialog(page).getByRole('button', { name: 'Queue' }).click();
  await page.getByText('A person arms one of them; the others then leave').waitFor(); // the dialog's hint names the first half, too
  await shot(page, 'plans-queued');
  const { body } = await rig.call('GET', '/jobs?state=queued&limit=200');
  const made = body.items.filter(({ end_check }) => end_check === 'part measured');
  expect(made.map(({ machine }) => machine).sort().join() === 'plans,plans2', `one for each machine: ${made.length}`);
  expect(made[0].choice !== null && made[0].choice === made[1].choice && new Date(made[0].not_before_ms).getFullYear() === 2031, 'they are one choice, not before its time');
}

// Jobs of a state and of a machine; the choice stands in the address.
async function filtered(page) {
  await signIn(page, url, tokens.operator);
  await page.goto(`${url}/#/jobs`);
  const states = async () => [...new Set(await page.locator('[data-job]').evaluateAll((rows) => rows.map((row) => row.dataset.state)))];
  await page.locator('[data-job]').first().waitFor();
  expect((await states()).length > 1, `jobs of several states: ${await states()}`);
  await page.getByRole('search').getByLabel('State').selectOption('cancelled');
  await until(async () => (await states()).join() === 'cancelled', 'those of one state');
  await page.reload();
  await live(page);
  await page.locator('[data-job]').first().waitFor();
  await soon(async () => (await states()).join() === 'cancelled', 'the choice is in the address');
  await page.getByRole('search').getByLabel('State').selectOption('armed');
  await page.getByText('No job like this among those that are loaded.').waitFor();
  await accessible(page, 'jobs of a state that none has');
}

// Why a transfer was stopped: stated at the machine by one touch, seen at the job, counted in the history.
async function stops(page) {
  const [job] = await rig.machine('stops', { jobs: 1, blocks: 600, baud: 9600 });
  await rig.call('POST', `/jobs/${job}/arm`, {});
  await rig.say('stops', 'dc1');
  await until(async () => (await rig.got('stops')) > 200, 'it is fed');
  await signIn(page, url, tokens.operator);
  await page.goto(`${url}/#/machines/stops`);
  const reasons = page.getByRole('region', { name: `Why job ${job} stopped` });
  await page.locator('[data-part="queue"]').waitFor();
  await soon(async () => (await reasons.count()) === 0, 'while it is fed it asks for no reason');
  await page.getByRole('button', { name: `Stop at block end, job ${job}` }).click();
  await reasons.getByText('Nothing is stated yet.').waitFor();
  await reasons.getByLabel(/^Note/).fill('insert of T3');
  await accessible(page, 'a stop without a reason');
  await reasons.getByRole('button', { name: 'tool broken' }).click();
  await reasons.getByRole('listitem').getByText('tool broken').waitFor();
  await shot(page, 'stops-machine');
  await soon(async () => (await rig.job(job)).state === 'held', 'it goes on being held');
  await reasons.getByRole('button', { name: 'measuring' }).click();
  await reasons.getByRole('listitem').getByText('measuring').waitFor();
  await rig.call('POST', `/jobs/${job}/cancel`);
  await page.goto(`${url}/#/jobs/${job}`);
  await reasons.getByText('insert of T3').waitFor();
  await accessible(page, 'a job with its reasons');
  await page.goto(`${url}/#/history`);
  const row = page.getByRole('region', { name: 'Stops by reason' }).getByRole('row').filter({ hasText: 'tool broken' });
  await row.waitFor();
  await soon(async () => (await row.innerText()).includes('stops'), 'the history counts it for its machine');
  await accessible(page, 'the history with reasons');
  await shot(page, 'stops-history');
  await page.setViewportSize(kPhone);
  await page.goto(`${url}/#/machines/stops`);
  await reasons.waitFor();
  await fits(page, 'reasons on a phone');
}

async function looks(page) {
  await signIn(page, url, tokens.operator);
  const { id } = await only('A-77');
  for (const [name, viewport, language] of [['desk', kDesk.viewport, 'de'], ['tablet', { width: 820, height: 1180 }, 'en'], ['phone', kPhone, 'en']]) {
    await page.setViewportSize(viewport);
    await page.evaluate((tag) => localStorage.setItem('dripfeed.language', tag), language);
    for (const scheme of ['light', 'dark']) {
      await page.emulateMedia({ colorScheme: scheme });
      for (const [place, address, there] of [['orders', '#/orders', '[data-order]'], ['order', `#/orders/${id}`, '.decide-buttons'], ['history', '#/history', '[data-job]']]) {
        await page.goto(`${url}/${address}`);
        await page.reload();
        await live(page);
        await page.locator(there).first().waitFor();
        const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        expect(wider <= 0, `${place}, ${name}, ${scheme}: as wide as the screen (${wider})`);
        await accessible(page, `${place}, ${name}, ${scheme}`);
        await shot(page, `look-${place}-${name}-${scheme}`);
      }
    }
  }
}

await main([
  ['a planner: add, queue, report, hold, change, find, sort, export', () => withPage(kDesk, planner)],
  ['lists as files', () => withPage(kDesk, files)],
  ['transfers of the past', () => withPage(kDesk, history)],
  ['plans of jobs', () => withPage(kDesk, plans)],
  ['a job that is planned from the page', () => withPage(kDesk, planned)],
  ['jobs by state and machine', () => withPage(kDesk, filtered)],
  ['why transfers were stopped', () => withPage(kDesk, stops)],
  ['every look', () => withPage(kDesk, looks)],
]);
