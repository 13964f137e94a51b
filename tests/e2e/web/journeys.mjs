// The day of each role, by the shortest path through the page, from the token on: how many steps it takes. A step is a
// click, a key that does something, or an entry in a field; a dropped or chosen file is one.
// docs/page.md has the table.
import { fileURLToPath } from 'node:url';
import { expect, main, Person, shot, signIn, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1440, height: 900 } };
const { url, tokens } = await rig.base();
const kRoll = fileURLToPath(new URL('../../../deploy/families/hyperbolic-roll.family', import.meta.url));
const kHub = '%\nO0700 (HUB)\nG21 G18 G90 G54\nT0606\nM3 S500\nG0 X100. Z5.\nG1 Z-20. F0.2\nx110.\nG0 Z50.\nM5\nM30\n%\n';

const dialog = (page) => page.getByRole('dialog');
const view = (page, name) => page.getByRole('navigation', { name: 'Views' }).getByRole('link', { name });
const button = (where, name) => where.getByRole('button', { name });

class Walk extends Person {
  marks = [];
  constructor(role, page) {
    super();
    this.role = role;
    this.page = page;
  }
  async choose(locator, value) {
    this.steps += 1;
    await locator.selectOption(value);
  }
  async check(locator) {
    this.steps += 1;
    await locator.check();
  }
  async key(name) {
    this.steps += 1;
    await this.page.keyboard.press(name);
  }
  async file(act) {
    this.steps += 1;
    await act();
  }
  // What was reached since the mark before.
  mark(what) {
    const before = this.marks.reduce((sum, { steps }) => sum + steps, 0);
    this.marks.push({ what, steps: this.steps - before });
  }
  report() {
    console.log(`  ${this.role}: ${this.steps} steps: ${this.marks.map(({ what, steps }) => `${what} ${steps}`).join(', ')}`);
  }
}

async function begin(page, role) {
  const walk = new Walk(role, page);
  await signIn(page, url, tokens[role === 'engineer' ? 'programmer' : role === 'administrator' ? 'admin' : role]);
  walk.steps += 2;
  walk.mark('sign in');
  return walk;
}

async function drop(page, name, text) {
  const data = await page.evaluateHandle(([file, content]) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([content], file));
    return transfer;
  }, [name, text]);
  for (const event of ['dragenter', 'dragover', 'drop']) await page.locator('.library').dispatchEvent(event, { dataTransfer: data });
}

async function handIn(page, walk) {
  await walk.click(page.getByRole('link', { name: 'Checks' }));
  await walk.click(button(page, /^Check revision/));
  await page.getByRole('heading', { name: /^Check \d+/ }).waitFor({ timeout: 60_000 });
  walk.mark('check');
  await walk.click(page.getByRole('link', { name: 'Release' }));
  await walk.click(button(page, /^Draft a release/));
  await walk.click(button(page, /^Hand release/));
  await walk.click(button(dialog(page), 'Hand in for review'));
  await page.locator('[data-state="in_review"]').waitFor();
  walk.mark('hand in');
}

async function programmer(page) {
  await rig.machine('lathe', { jobs: 0 });
  const walk = await begin(page, 'programmer');
  await walk.click(view(page, 'Library'));
  await walk.file(() => drop(page, 'O0700.nc', kHub));
  await walk.click(button(dialog(page), 'Upload 1 program'));
  await walk.click(dialog(page).getByRole('link', { name: 'O0700' }));
  await page.getByRole('textbox', { name: /^Text of/ }).waitFor();
  walk.mark('upload by drop');
  const faults = page.getByRole('complementary', { name: 'Faults and outline' });
  await walk.click(button(faults, /^Write X/));
  await until(async () => (await faults.locator('.fault.tone-bad').count()) === 0, 'the fault is mended');
  await walk.key('Control+s');
  await page.getByText('As revision 2.').waitFor();
  walk.mark('see the error, mend, save');
  await walk.click(button(page, 'Toolpath'));
  await page.locator('canvas').first().waitFor();
  walk.mark('toolpath');
  await walk.click(button(page, 'Translation'));
  await walk.choose(page.getByLabel('Translate for'), 'sinumerik-840d');
  await page.getByRole('region', { name: 'Translation' }).getByText('both were run and move the same').waitFor();
  await shot(page, 'journey-programmer');
  walk.mark('translate');
  await walk.click(page.getByRole('link', { name: 'Revisions' }));
  await walk.click(button(page, 'Compare revisions 1 and 2'));
  await page.getByRole('list', { name: 'O0700, revision 2' }).waitFor();
  walk.mark('compare');
  await handIn(page, walk);
  walk.report();
}

async function engineer(page) {
  await rig.machine('roll-lathe', { jobs: 0 });
  const walk = await begin(page, 'engineer');
  await walk.click(view(page, 'Parts'));
  const chosen = page.waitForEvent('filechooser');
  await walk.file(async () => {
    await button(page, 'Upload a family…').click();
    await (await chosen).setFiles(kRoll);
  });
  await walk.click(page.getByRole('link', { name: 'Hyperbolic rolling-mill roll', exact: true }));
  walk.mark('family');
  await walk.type(page.getByLabel('Part number'), 'R-1');
  await walk.type(page.getByLabel(/length of the barrel/).first(), '180');
  await page.locator('[data-dimension="roll_length"]').getByText('180 mm').waitFor();
  await shot(page, 'journey-engineer');
  walk.mark('values, live preview');
  const region = page.getByRole('region', { name: 'Feasible region' });
  await walk.click(button(region, 'Compute it'));
  await region.getByText(/The defaults pass on/).waitFor({ timeout: 120_000 });
  walk.mark('region');
  await walk.click(button(page, 'Make the part'));
  await walk.click(button(page, 'Render for this machine'));
  await walk.click(page.getByRole('status').getByRole('link', { name: /./ }).first());
  await page.getByRole('textbox', { name: /^Text of/ }).waitFor();
  walk.mark('part and program');
  await handIn(page, walk);
  const program = Number(/programs\/(\d+)/.exec(page.url())[1]);
  const release = (await rig.call('GET', `/releases?program=${program}`)).body.items[0].id;
  await rig.call('POST', `/releases/${release}/transitions`, { to: 'proving', transfers: 1 }, 'approver');
  await walk.click(view(page, 'Jobs'));
  await walk.click(page.getByRole('link', { name: 'New job' }));
  await walk.click(button(page, new RegExp(`^Queue release ${release}\\b`)));
  await page.getByText(/Queued as/).waitFor();
  walk.mark('job');
  walk.report();
}

async function approver(page) {
  await rig.machine('mill-9', { jobs: 0 });
  const text = kHub.replace('O0700 (HUB)', 'O0790 (RIM)').replace('x110.', 'X110.');
  const { body } = await rig.call('POST', '/programs', { name: 'O0790', dialect: 'fanuc', text }, 'programmer');
  const draft = async (waived) => {
    const of = { program: body.id, machine: 'mill-9' };
    await rig.call('POST', '/checks', of, 'programmer');
    const release = (await rig.call('POST', '/releases', of, 'programmer')).body.id;
    if (waived) return release;
    await rig.call('POST', `/releases/${release}/transitions`, { to: 'in_review' }, 'programmer');
    return release;
  };
  const first = await draft(false);
  await rig.call('PUT', '/groups/of-mill-9', { machines: ['mill-9'], operator_sign_off: false });
  for (const step of [{ to: 'proving', transfers: 1 }, { to: 'approved', note: 'measured' }]) await rig.call('POST', `/releases/${first}/transitions`, step, 'approver');
  await rig.call('POST', `/programs/${body.id}/revisions`, { text: text.replace('X110.', 'X112.') }, 'programmer', { 'If-Match': '"1"' });
  const release = await draft(false);
  const walk = await begin(page, 'approver');
  await walk.click(view(page, 'Review'));
  await walk.click(page.locator(`[data-release="${release}"]`).getByRole('link').first());
  await page.getByRole('heading', { name: /What has changed since release/ }).waitFor();
  await shot(page, 'journey-approver');
  walk.mark('review, what changed');
  const decision = page.getByRole('region', { name: 'Decision' });
  await walk.click(button(decision, 'Let it be proved…'));
  await walk.type(dialog(page).getByRole('textbox'), 'first piece at half rapid');
  await walk.click(button(dialog(page), 'Let it be proved'));
  walk.mark('let it be proved');
  await walk.click(button(decision, 'Approve it…'));
  await walk.type(dialog(page).getByRole('textbox'), 'measured, 12 parts');
  await walk.click(button(dialog(page), 'Approve it'));
  await button(decision, 'Withdraw it…').waitFor();
  walk.mark('approve');
  // What is not known needs a person who waives it.
  const open = (await rig.call('POST', '/programs', { name: 'O0791', dialect: 'fanuc', text: text.replace('O0790', 'O0791').replace('X110.', 'X#500') }, 'programmer')).body.id;
  await rig.call('POST', '/checks', { program: open, machine: 'mill-9' }, 'programmer');
  const waits = (await rig.call('POST', '/releases', { program: open, machine: 'mill-9' }, 'programmer')).body.id;
  await page.goto(`${url}/#/review/${waits}`);
  await walk.click(button(page, /^Waive this verdict/));
  await walk.type(dialog(page).getByRole('textbox', { name: /^Why this may go/ }), '#500 is set by the probe before');
  await walk.click(button(dialog(page), /^Waive as/));
  await page.getByText(/Waived by .*: #500 is set by the probe before/).first().waitFor();
  walk.mark('waive');
  walk.report();
}

async function administrator(page) {
  await rig.machine('bench', { jobs: 0, baud: 9600 });
  const walk = await begin(page, 'administrator');
  await walk.click(view(page, 'Admin'));
  await walk.click(button(page, 'Add a person'));
  await walk.type(dialog(page).getByLabel('Name'), 'olga');
  await walk.choose(dialog(page).getByLabel(/^Role(?! on)/), 'operator');
  await walk.click(button(dialog(page), 'Save'));
  await page.getByRole('row').filter({ hasText: 'olga' }).waitFor();
  walk.mark('user and role');
  await walk.click(page.getByRole('link', { name: 'Tokens' }));
  await walk.click(button(page, 'Make a token'));
  await walk.type(dialog(page).getByLabel('Name'), 'MES');
  await walk.choose(dialog(page).getByLabel(/^Role(?! on)/), 'operator');
  await walk.click(button(dialog(page), 'Make it'));
  await dialog(page).locator('code').waitFor();
  await walk.key('Escape');
  await dialog(page).waitFor({ state: 'detached' });
  walk.mark('token');
  await walk.click(page.getByRole('link', { name: 'Machines', exact: true }));
  await walk.click(page.getByRole('link', { name: 'bench', exact: true }));
  await walk.type(page.locator('[data-pointer="/title"]'), 'The bench lathe');
  await walk.click(button(page, /^Save as revision/));
  await button(page, 'Save as revision 3').waitFor();
  await shot(page, 'journey-administrator');
  walk.mark('profile form');
  await rig.bridge('bench');
  await walk.click(button(page, 'The plug is in place: test'));
  await walk.click(button(dialog(page), 'The plug is in place: test'));
  await page.getByText(/The line (keeps|does not keep) the machine’s budget/).waitFor({ timeout: 60_000 });
  await rig.bridge('bench', false);
  walk.mark('line test');
  await walk.click(view(page, 'Admin'));
  await walk.click(page.getByRole('link', { name: 'Store', exact: true }));
  await walk.click(button(page, 'Make a backup'));
  await page.getByRole('status').getByText(/is whole/).waitFor({ timeout: 30_000 });
  walk.mark('backup');
  await walk.click(button(page, 'Verify the store'));
  await page.getByText('The store is sound').waitFor({ timeout: 30_000 });
  walk.mark('ledger verification');
  await walk.click(page.getByRole('link', { name: 'Audit' }));
  await page.getByRole('table', { name: 'Audit' }).waitFor();
  walk.mark('audit');
  walk.report();
  expect(walk.steps > 0, 'it was walked');
}

await main([
  ['programmer', () => withPage(kDesk, programmer)],
  ['engineer', () => withPage(kDesk, engineer)],
  ['approver', () => withPage(kDesk, approver)],
  ['administrator', () => withPage(kDesk, administrator)],
]);
