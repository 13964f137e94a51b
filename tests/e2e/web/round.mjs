// A newcomer's path through one transfer in a real browser, against any server that has the API:
//   DRIPFEED_URL, DRIPFEED_TOKEN   the server, and a token of an operator or more
//   SCREENSHOTS=dir                keeps a picture of each step
//   DRIPFEED_WAIT_S=120            how long the transfer may take
// There must be a machine whose line is idle, with a queued job or an approved release, and a control (or a simulated
// one) that asks for the program once it is armed.
import { Person, card, expect, main, recordLine, shot, signIn, soon, until, withPage } from './browser.mjs';

const url = process.env.DRIPFEED_URL;
const token = process.env.DRIPFEED_TOKEN;
const wait = Number(process.env.DRIPFEED_WAIT_S ?? 120) * 1000;
if (!url || !token) {
  console.error('DRIPFEED_URL and DRIPFEED_TOKEN name the server and the token');
  process.exit(2);
}

async function refusesAWrongToken(page) {
  await page.goto(url);
  await page.getByLabel('Token').fill('no-such-token');
  await page.getByRole('button', { name: 'Sign in' }).click();
  await page.getByRole('alert').waitFor();
  await soon(() => page.getByLabel('Token').isVisible(), 'a wrong token is refused with a sentence');
  await shot(page, '01-refused');
}

// Takes the first job that can be armed; where there is none, queues the first release.
async function findJob(page, person) {
  const arm = page.getByRole('button', { name: /^Arm, job \d+$/ });
  if ((await arm.count()) === 0) {
    await person.click(page.getByRole('link', { name: 'New job' }));
    await person.click(page.getByRole('button', { name: /^Queue release/ }).first());
    await page.getByText(/Queued as/).waitFor();
    await shot(page, '03-queued');
    await person.click(page.getByRole('navigation').getByRole('link', { name: 'Floor' }));
    await arm.first().waitFor();
  }
  const label = await arm.first().getAttribute('aria-label');
  const machine = await arm.first().evaluate((button) => button.closest('article').getAttribute('aria-label'));
  return { id: Number(/\d+/.exec(label)[0]), machine: machine.replace(/^Machine /, ''), arm: arm.first() };
}

async function armThroughDialog(page, job, person) {
  const dialog = page.getByRole('dialog');
  await job.arm.click();
  await dialog.waitFor();
  const text = await dialog.innerText();
  for (const word of ['Program', 'Revision', 'SHA-256', 'Machine', 'Link', 'Delivery', job.machine])
    expect(text.includes(word), `the dialog shows ${word}`);
  expect(/The control starts the motion; dripfeed never does\./.test(text), 'the dialog says who starts the motion');
  await shot(page, '04-arm-dialog');
  await page.keyboard.press('Escape');
  await dialog.waitFor({ state: 'detached' });
  await soon(() => job.arm.isVisible(), 'Escape closes the dialog and arms nothing');
  await person.click(job.arm);
  await person.click(dialog.getByRole('button', { name: /^Arm for/ }));
  await dialog.waitFor({ state: 'detached' });
}

async function round(page) {
  const person = new Person();
  await refusesAWrongToken(page);
  await signIn(page, url, token);
  person.steps += 2; // the token, and Enter
  await page.getByRole('article').first().waitFor();
  await shot(page, '02-floor');
  const job = await findJob(page, person);
  const seen = await recordLine(page, job.machine);
  await armThroughDialog(page, job, person);
  const place = card(page, job.machine);
  await until(async () => (await seen()).some((line) => line !== 'idle'), 'it is armed');
  await shot(page, '05-armed');
  await until(async () => (await seen()).includes('feeding'), 'it feeds', wait);
  await shot(page, '06-feeding');
  await until(async () => (await seen()).length > 1 && (await seen()).at(-1) === 'idle', 'the line is idle again', wait);
  const lines = await seen();
  // A control that asks at once leaves the page no time to show "armed"; that a person armed it stands at the job.
  expect(lines.indexOf('armed') < lines.indexOf('feeding'), `it is not armed again once it fed: ${lines.join(', ')}`);
  await place.getByText(`Last: job ${job.id}, done`).waitFor();
  await shot(page, '07-done');
  console.log(`  newcomer: from the token to a fed program in ${person.steps} steps`);

  await page.goto(`${url}/#/jobs/${job.id}`);
  await page.locator('section[aria-label="Job"][data-state="done"]').waitFor();
  await page.getByText('Armed by').waitFor();
  await page.getByText(/(passed the line|passed the line for certain|acknowledged by the other side)/).first().waitFor();
  await shot(page, '08-ledger');
  expect(true, 'the job is done and its ledger says how many bytes passed: the trailer after the end may stay unsent');

  await page.locator('.who summary').click();
  await page.getByRole('button', { name: 'Sign out' }).click();
  await page.getByLabel('Token').waitFor();
  await page.reload();
  await page.getByLabel('Token').waitFor();
  expect(true, 'after signing out the session is over');
}

await main([['a person arms a job and sees it through', () => withPage({}, round)]]);
