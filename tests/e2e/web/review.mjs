// An approver's work against the real server: what waits, the verdict with its findings and pictures, a waiver with a
// reason, what has changed, four eyes, and the decision: to the proving, back, approved, withdrawn.
import { accessible, expect, live, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1280, height: 900 } };
const kPhone = { width: 360, height: 740 };
const { url, tokens } = await rig.base();
const kText = '%\nO0900 (HUB)\nG21 G18 G90 G54\nT0606\nM3 S500\nG0 X100. Z5.\nG1 Z-20. F0.2\nX110.\nG0 Z50.\nM5\nM30\n%\n';

const dialog = (page) => page.getByRole('dialog');
const decision = (page) => page.getByRole('region', { name: 'Decision' });
const state = async (release) => (await rig.call('GET', `/releases/${release}`)).body.state;

async function handedIn(name, text, machine = 'lathe') {
  const program = (await rig.call('POST', '/programs', { name, dialect: 'fanuc', text }, 'programmer')).body.id;
  const release = await draft(program, machine);
  return { program, release };
}

async function draft(program, machine) {
  const of = { program, machine };
  const check = (await rig.call('POST', '/checks', of, 'programmer')).body;
  const release = (await rig.call('POST', '/releases', of, 'programmer')).body.id;
  if (check.verdict !== 'pass') await rig.call('POST', `/checks/${check.id}/waivers`, { reason: 'for a test' }, 'approver');
  const moved = await rig.call('POST', `/releases/${release}/transitions`, { to: 'in_review', note: 'please look at line 7' }, 'programmer');
  expect(moved.status === 200, `release ${release} is handed in (${JSON.stringify(moved.body)})`);
  return release;
}

async function decide(page, button, comment) {
  await decision(page).getByRole('button', { name: button }).click();
  await dialog(page).getByRole('textbox').fill(comment);
}

// A transfer to the control, and the operator's sign-off: only then it may be approved.
async function proved(page, release) {
  const proving = page.getByRole('region', { name: 'Proving' });
  await proving.getByText('Nothing of it was transferred yet.').waitFor();
  const may = async (name) => (await decision(page).getByRole('button', { name }).getAttribute('aria-disabled')) !== 'true';
  expect(!(await may('Approve it…')), 'before the sign-off it is not approved');
  expect(await may('Back to review…'), 'it may be sent back');
  const job = (await rig.call('POST', '/jobs', { release })).body.id;
  await rig.waitLine('lathe', 'idle');
  await rig.call('POST', `/jobs/${job}/arm`, {});
  await rig.say('lathe', 'dc1');
  await until(async () => (await rig.job(job)).state === 'done', 'the first part is made', 20_000);
  await page.reload();
  await live(page);
  await proving.getByText('An operator of lathe states what they have shown.').waitFor();
  await proving.getByRole('button', { name: 'Sign the proving off…' }).click();
  await soon(() => dialog(page).getByRole('button', { name: 'Sign it off' }).isDisabled(), 'without words nothing is signed off');
  await dialog(page).getByRole('textbox').fill('12.00 on all three');
  await accessible(page, 'a sign-off');
  await shot(page, 'review-sign-off');
  await dialog(page).getByRole('button', { name: 'Sign it off' }).click();
  await proving.getByText(/Signed off by .*: 12.00 on all three/).waitFor();
  await accessible(page, 'a proving that was signed off');
  await shot(page, 'review-proved');
  await soon(() => may('Approve it…'), 'it may be approved');
}

async function approve(page) {
  await rig.machine('lathe', { jobs: 0 });
  const { program, release } = await handedIn('O0900', kText);
  await signIn(page, url, tokens.approver);
  await page.getByRole('navigation', { name: 'Views' }).getByRole('link', { name: 'Review' }).click();
  const row = page.locator(`[data-release="${release}"]`);
  await row.waitFor();
  await accessible(page, 'what waits');
  await shot(page, 'review-queue');
  await row.getByRole('link').click();
  await page.getByRole('heading', { name: 'O0900, revision 1, for lathe' }).waitFor();
  await page.getByRole('heading', { name: /^Check \d+/ }).waitFor();
  await page.getByText('please look at line 7').waitFor();
  expect(true, "the programmer's note is there");
  await page.getByRole('button', { name: 'Speed over time' }).click();
  const picture = page.getByRole('img', { name: 'Speed over time' });
  await picture.waitFor();
  await soon(async () => await picture.evaluate((one) => one.complete && one.naturalWidth > 100), "the check's picture is drawn");
  await accessible(page, 'a review');
  await shot(page, 'review');
  await decide(page, 'Let it be proved…', 'first piece at half rapid');
  await dialog(page).getByLabel('Transfers that may be made').fill('2');
  await accessible(page, 'the decision');
  await shot(page, 'review-decision');
  await dialog(page).getByRole('button', { name: 'Let it be proved' }).click();
  await decision(page).getByRole('button', { name: 'Approve it…' }).waitFor();
  await soon(async () => (await state(release)) === 'proving', 'it is proved');
  await page.getByText('first piece at half rapid').waitFor();
  await proved(page, release);
  await decide(page, 'Approve it…', 'measured, 12 parts');
  await dialog(page).getByRole('button', { name: 'Approve it' }).click();
  await decision(page).getByRole('button', { name: 'Withdraw it…' }).waitFor();
  await soon(async () => (await state(release)) === 'approved', 'it is approved');

  // The next revision: what has changed since is there, and it is returned with a comment.
  await rig.call('POST', `/programs/${program}/revisions`, { text: kText.replace('X110.', 'X112.') }, 'programmer', { 'If-Match': '"1"' });
  const next = await draft(program, 'lathe');
  await page.goto(`${url}/#/review/${next}`);
  await page.getByRole('heading', { name: /What has changed since release/ }).waitFor();
  await page.getByRole('list', { name: 'O0900, revision 2' }).getByText('X112.').waitFor();
  await page.locator('.compared').getByText('Motions').waitFor();
  expect(true, 'text and motions are compared with the last one released there');
  await shot(page, 'review-since');
  await decide(page, 'Return it…', 'X112 is beside the drawing');
  await dialog(page).getByRole('button', { name: 'Return it' }).click();
  await until(async () => (await state(next)) === 'draft', 'it is returned');
}

// What only warns needs a name and a reason; the person who drafted it reads that another must approve.
async function waiveAndFourEyes(page) {
  await rig.machine('mill-7', { jobs: 0 });
  await rig.call('PUT', '/groups/careful', { machines: ['mill-7'], four_eyes: true });
  const text = kText.replace('O0900 (HUB)', 'O0901 (RING)').replace('X110.', 'X#500');
  const program = (await rig.call('POST', '/programs', { name: 'O0901', dialect: 'fanuc', text }, 'approver')).body.id;
  const check = (await rig.call('POST', '/checks', { program, machine: 'mill-7' }, 'approver')).body;
  expect(check.verdict === 'unknown', `what is not known is not passed (${check.verdict})`);
  const release = (await rig.call('POST', '/releases', { program, machine: 'mill-7' }, 'approver')).body.id;
  await signIn(page, url, tokens.approver);
  await page.goto(`${url}/#/programs/${program}/release`);
  await page.getByRole('link', { name: String(release), exact: true }).click();
  await page.getByText(/needs a person who waives it/).first().waitFor().catch(() => undefined);
  await page.getByRole('button', { name: 'Waive this verdict…' }).click();
  await soon(() => dialog(page).getByRole('button', { name: /^Waive as/ }).isDisabled(), 'without a reason nothing is waived');
  await dialog(page).getByRole('textbox', { name: /^Why this may go/ }).fill('#500 is set by the probe before');
  await accessible(page, 'a waiver');
  await shot(page, 'review-waive');
  await dialog(page).getByRole('button', { name: /^Waive as/ }).click();
  await dialog(page).getByText(/./).first().waitFor();
  await page.waitForTimeout(500);
  const refused = await dialog(page).getByRole('alert').count();
  expect(refused === 1, 'four eyes: the server refuses it of who wrote the text, and its sentence is shown');
  await shot(page, 'review-four-eyes');
  await page.keyboard.press('Escape');
  await rig.token('approver', 'second-approver').then(async (token) => {
    await page.getByText('the approver').first().click();
    await page.getByRole('button', { name: 'Sign out' }).click();
    await signIn(page, url, token.trim().split(/\s+/).at(-1));
  });
  await page.goto(`${url}/#/review/${release}`);
  await page.getByRole('button', { name: 'Waive this verdict…' }).click();
  await dialog(page).getByRole('textbox', { name: /^Why this may go/ }).fill('#500 is set by the probe before');
  await dialog(page).getByRole('button', { name: /^Waive as/ }).click();
  await page.getByText(/Waived by .*: #500 is set by the probe before/).first().waitFor();
  expect(true, 'another person waives it, with name and reason');
}

// One point after the other, each with a reason; and one that ends by itself.
async function points(page) {
  await rig.machine('mill-8', { jobs: 0 });
  const text = kText.replace('O0900 (HUB)', 'O0903 (CAM)').replace('F0.2', 'F0.2 F0.3').replace('X110.', 'X#500');
  const program = (await rig.call('POST', '/programs', { name: 'O0903', dialect: 'fanuc', text }, 'programmer')).body.id;
  const check = (await rig.call('POST', '/checks', { program, machine: 'mill-8' }, 'programmer')).body;
  expect(check.points.length > 1, `the verdict has points (${check.points.join('; ')})`);
  const release = (await rig.call('POST', '/releases', { program, machine: 'mill-8' }, 'programmer')).body.id;
  const handIn = () => rig.call('POST', `/releases/${release}/transitions`, { to: 'in_review' }, 'programmer');
  await signIn(page, url, tokens.approver);
  await page.goto(`${url}/#/review/${release}`);
  const open = page.getByRole('button', { name: /^Waive this point/ });
  await open.first().waitFor();
  await accessible(page, 'the points of a verdict');
  await shot(page, 'review-points');
  for (let left = check.points.length; left > 0; left -= 1) {
    expect((await handIn()).status === 409, `${left} points stand against the release`);
    await open.first().click();
    await dialog(page).getByRole('textbox', { name: /^Why this may go/ }).fill('set by the probe');
    if (left === 1) await dialog(page).getByLabel(/^Last day on which it counts/).fill('2099-12-31');
    await dialog(page).getByRole('button', { name: /^Waive as/ }).click();
    await until(async () => (await open.count()) === left - 1, 'the point is waived');
  }
  await page.getByText(/It ends 2100-01-01 00:00:00/).waitFor();
  await accessible(page, 'waived points');
  await shot(page, 'review-points-waived');
  expect((await handIn()).status === 200, 'with each point waived it goes on');
}

async function looks(page) {
  const { release } = await handedIn('O0902', kText.replace('O0900 (HUB)', 'O0902'));
  await signIn(page, url, tokens.approver);
  for (const [name, viewport, language] of [['desk', kDesk.viewport, 'de'], ['tablet', { width: 820, height: 1180 }, 'en'], ['phone', kPhone, 'de']]) {
    await page.setViewportSize(viewport);
    await page.evaluate((tag) => localStorage.setItem('dripfeed.language', tag), language);
    for (const scheme of ['light', 'dark']) {
      await page.emulateMedia({ colorScheme: scheme });
      for (const [place, address, there] of [['queue', '#/review', '[data-release]'], ['one', `#/review/${release}`, '.decide-buttons']]) {
        await page.goto(`${url}/${address}`);
        await page.reload();
        await live(page);
        await page.locator(there).first().waitFor();
        const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        expect(wider <= 0, `${place}, ${name}, ${scheme}: as wide as the screen (${wider})`);
        await accessible(page, `${place}, ${name}, ${scheme}`);
        await shot(page, `look-review-${place}-${name}-${scheme}`);
      }
    }
  }
}

await main([
  ['an approver: look, let prove, approve, return', () => withPage(kDesk, approve)],
  ['a waiver and four eyes', () => withPage(kDesk, waiveAndFourEyes)],
  ['a waiver of each point', () => withPage(kDesk, points)],
  ['every look', () => withPage(kDesk, looks)],
]);
