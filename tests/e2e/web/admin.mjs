// An administrator's day: people and tokens, a machine's profile as a form with the test of its line, and the store with its
// verification and backups.
import { accessible, expect, fits, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1280, height: 900 } };
const kTablet = { viewport: { width: 820, height: 1180 }, hasTouch: true, colorScheme: 'dark' };
const kPhone = { viewport: { width: 360, height: 740 }, hasTouch: true };
const { url, tokens } = await rig.base();

const dialog = (page) => page.getByRole('dialog');
const field = (page, pointer) => page.locator(`[data-pointer="${pointer}"]`);
const unfold = (page, name) => page.locator(`[data-section="${name}"] > summary`).click();

// A person with a PIN, a group of machines, a token, and what was done.
async function people(page) {
  await rig.machine('people-mill', { jobs: 0 });
  await signIn(page, url, tokens.admin);
  await page.getByRole('navigation', { name: 'Views' }).getByRole('link', { name: 'Admin' }).click();
  await page.getByText('There is no person yet').waitFor();
  await page.getByRole('link', { name: 'Groups of machines' }).click();
  await page.getByRole('button', { name: 'Add a group' }).click();
  await dialog(page).getByLabel('Name').fill('people-mills');
  await dialog(page).getByLabel('people-mill', { exact: true }).check();
  await dialog(page).getByLabel(/may not approve it/).check();
  await dialog(page).getByRole('button', { name: 'Save' }).click();
  await page.getByRole('cell', { name: 'by another person than the author' }).waitFor();
  await page.getByRole('link', { name: 'People', exact: true }).click();
  await page.getByRole('button', { name: 'Add a person' }).click();
  await dialog(page).getByLabel('Name').fill('olga');
  await dialog(page).getByLabel(/^Role(?! on)/).selectOption('viewer');
  await dialog(page).getByLabel('Role on people-mills').selectOption('operator');
  await dialog(page).getByRole('button', { name: 'Save' }).click();
  await page.getByRole('cell', { name: 'viewer, operator on people-mills' }).waitFor();
  await page.getByRole('button', { name: 'PIN of olga' }).click();
  await dialog(page).getByLabel('New PIN').fill('1234');
  await dialog(page).getByRole('button', { name: 'Save' }).click();
  await dialog(page).getByText(/digits in a row/).waitFor();
  await dialog(page).getByLabel('New PIN').fill('2903');
  await dialog(page).getByRole('button', { name: 'Save' }).click();
  await dialog(page).waitFor({ state: 'detached' });
  await page.getByRole('row').filter({ hasText: 'olga' }).getByRole('cell', { name: 'PIN', exact: true }).waitFor();
  await accessible(page, 'people');
  await shot(page, 'people');
  await page.getByRole('link', { name: 'Tokens' }).click();
  await page.getByRole('button', { name: 'Make a token' }).click();
  await dialog(page).getByLabel('Name').fill('MES');
  await dialog(page).getByLabel(/^Role(?! on)/).selectOption('operator');
  await dialog(page).getByLabel('orders and the queue').check();
  await dialog(page).getByRole('button', { name: 'Make it' }).click();
  const secret = await dialog(page).locator('code').innerText();
  expect(/^[\w-]{43}$/.test(secret), 'the secret is shown once');
  await page.keyboard.press('Escape');
  await dialog(page).waitFor({ state: 'detached' });
  await page.getByRole('row').filter({ hasText: 'MES' }).getByRole('cell', { name: 'orders and the queue' }).waitFor();
  await soon(async () => !(await page.content()).includes(secret), 'and not again');
  await accessible(page, 'tokens');
  await shot(page, 'tokens');
  await page.getByRole('link', { name: 'Audit' }).click();
  await page.getByLabel('About').fill('user/olga');
  await page.getByRole('button', { name: 'Filter' }).click();
  await page.getByRole('cell', { name: 'pin set' }).waitFor();
  await soon(async () => (await page.getByRole('row').count()) === 3, 'the audit has what was done to olga');
  await accessible(page, 'the audit');
  await shot(page, 'audit');
  await page.setViewportSize(kPhone.viewport);
  await shot(page, 'audit-phone');
}

const profileOf = async (machine) => (await rig.call('GET', `/machines/${machine}`)).body;

// A profile is changed field by field, and each fault stands at its field; another person's change is not overwritten.
async function profile(page) {
  await rig.machine('bench', { jobs: 0 });
  await signIn(page, url, tokens.admin);
  await page.goto(`${url}/#/people/machines`);
  await page.getByRole('link', { name: 'bench', exact: true }).click();
  await page.getByRole('heading', { name: 'Profile of bench' }).waitFor();
  await soon(() => field(page, '/name').isDisabled(), 'a name stays');
  const save = page.getByRole('button', { name: /^Save as revision/ });
  await soon(() => save.isDisabled(), 'nothing is changed yet');
  await accessible(page, 'a profile');
  await field(page, '/title').fill('The bench lathe');
  await unfold(page, 'buffer');
  await field(page, '/buffer/bytes').fill('-5');
  await unfold(page, 'tools');
  const tools = (await profileOf('bench')).profile.tools.length;
  await page.getByRole('button', { name: 'Add to tools' }).click();
  await field(page, `/tools/${tools}/diameter_mm`).fill('8,5');
  await shot(page, 'profile');
  await field(page, '/title').focus();
  await save.click();
  await page.getByRole('alert').getByText('see the marked fields').waitFor();
  for (const pointer of ['/buffer/bytes', `/tools/${tools}/number`])
    await soon(async () => (await field(page, pointer).getAttribute('aria-invalid')) === 'true', `${pointer} is marked`);
  await accessible(page, 'a profile with faults');
  await shot(page, 'profile-faults');
  await soon(async () => (await profileOf('bench')).revision === 1, 'a refused profile changes nothing');
  await page.getByRole('button', { name: `tools.${tools}.number` }).click();
  await soon(async () => (await page.evaluate(() => document.activeElement.dataset.pointer)) === `/tools/${tools}/number`, 'a fault leads to its field');
  await page.keyboard.type('77');
  await field(page, '/buffer/bytes').fill('2048');
  await save.click();
  await page.getByRole('button', { name: 'Save as revision 3' }).waitFor();
  const now = (await profileOf('bench')).profile;
  expect(now.title === 'The bench lathe' && now.buffer.bytes === 2048 && now.tools[tools].number === 77 && now.tools[tools].diameter_mm === 8.5, 'the profile has what was typed');
  const other = { ...now, title: 'Changed by another' };
  expect((await rig.call('PUT', '/machines/bench', other, 'admin', { 'If-Match': '"2"' })).status === 200, 'another person changes it');
  await field(page, '/title').fill('Mine');
  await save.click();
  await page.getByText(/another change came first|another revision/i).waitFor();
  await soon(async () => (await profileOf('bench')).profile.title === 'Changed by another', 'their change stays');
}

// As the file has it: out of the page, and into it, for another machine.
async function files(page) {
  await rig.machine('first', { jobs: 0 });
  await signIn(page, url, tokens.admin);
  await page.goto(`${url}/#/people/machines`);
  await page.getByRole('link', { name: 'Copy the profile of first' }).click();
  await page.getByRole('heading', { name: 'New machine' }).waitFor();
  await field(page, '/name').fill('second');
  const [saved] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save as a file' }).click()]);
  expect(saved.suggestedFilename() === 'second.json', 'the file has the name of the machine');
  await unfold(page, 'link');
  await field(page, '/link/url').fill('tcp://127.0.0.1:9');
  await page.getByRole('button', { name: 'Add the machine' }).click();
  await page.getByRole('heading', { name: 'Profile of second' }).waitFor();
  await soon(async () => (await profileOf('second')).profile.link.url === 'tcp://127.0.0.1:9', 'the second machine has its own line');
  await page.getByLabel('Profile of the machine (JSON)').setInputFiles({ name: 'broken.json', mimeType: 'application/json', buffer: Buffer.from('{"name": ') });
  await page.getByText('This file is not JSON').waitFor();
  await page.getByLabel('Profile of the machine (JSON)').setInputFiles(await saved.path());
  await page.getByText(/The form has what is in/).waitFor();
  await soon(async () => (await field(page, '/name').inputValue()) === 'second', 'a file never renames a machine');
}

async function lineTest(page) {
  await rig.machine('looped', { jobs: 0, baud: 9600 });
  await signIn(page, url, tokens.admin);
  await page.goto(`${url}/#/machines/looped/profile`);
  const button = page.getByRole('button', { name: 'The plug is in place: test' });
  await field(page, '/title').fill('x');
  await field(page, '/title').blur();
  await soon(() => button.isDisabled(), 'what is not saved is not tested');
  await page.reload();
  await page.getByText('Save first').waitFor({ state: 'detached' });
  await rig.bridge('looped');
  await button.click();
  await dialog(page).getByRole('button', { name: 'The plug is in place: test' }).click();
  await page.getByText(/The line (keeps|does not keep) the machine’s budget/).waitFor({ timeout: 60_000 });
  await rig.bridge('looped', false);
}

// The store is read through and backed up while a line feeds.
async function store(page) {
  const [job] = await rig.machine('fed', { blocks: 3000, baud: 9600 });
  await rig.call('POST', `/jobs/${job}/arm`, {}, 'operator');
  await rig.say('fed', 'dc1');
  await signIn(page, url, tokens.admin);
  await page.goto(`${url}/#/people/store`);
  await page.getByText('There is no backup').waitFor();
  await page.getByRole('button', { name: 'Verify the store' }).click();
  await page.getByText('The store is sound').waitFor({ timeout: 30_000 });
  await page.getByRole('button', { name: 'Make a backup' }).click();
  const made = page.getByRole('status').getByText(/is whole/);
  await made.waitFor({ timeout: 30_000 });
  const name = /dripfeed-\S+\.backup/.exec(await made.innerText())[0];
  await page.getByRole('cell', { name, exact: true }).waitFor();
  await soon(async () => (await rig.job(job)).state === 'feeding', 'the line went on');
  await accessible(page, 'the store');
  await page.getByRole('link', { name: 'Licences of what is shipped' }).click();
  await page.getByText('Permission is hereby granted').first().waitFor();
  await soon(async () => (await page.locator('body').innerText()).includes('three'), 'the licences of what is shipped, with their texts');
  await page.goBack();
  await page.getByText('The store is sound').or(page.getByRole('button', { name: 'Verify the store' })).first().waitFor();
  await shot(page, 'store');
  await page.getByRole('button', { name: `Remove ${name}` }).click();
  await dialog(page).getByRole('button', { name: 'Remove' }).click();
  await page.getByText('There is no backup').waitFor();
  await page.goto(`${url}/#/people/audit`);
  for (const action of ['store.verify', 'backup.add', 'backup.remove']) await page.getByRole('cell', { name: action, exact: true }).first().waitFor();
}

async function everyLook(page, look) {
  await rig.machine(`look-${look}`, { jobs: 0 });
  await signIn(page, url, tokens.admin);
  for (const [address, heading] of [['people/users', 'Administration'], ['people/machines', 'Administration'], ['people/store', 'Administration'], [`machines/look-${look}/profile`, 'Profile of']]) {
    await page.goto(`${url}/#/${address}`);
    await page.getByRole('heading', { name: heading }).first().waitFor();
    if (address.endsWith('profile')) for (const name of ['axes', 'tools', 'link']) await unfold(page, name);
    await until(async () => (await page.locator('[role="status"]', { hasText: 'Loading' }).count()) === 0, 'it is there');
    await fits(page, `${address} on a ${look}`);
    await accessible(page, `${address} on a ${look}`);
    await shot(page, `${address.replaceAll('/', '-')}-${look}`);
  }
}

async function alone(page) {
  await signIn(page, url, tokens.admin);
  await page.goto(`${url}/#/people`);
  await page.getByRole('link', { name: 'Servers' }).click();
  await page.getByText('This server is the only one of its store.').waitFor();
  await accessible(page, 'one server');
}

// Who is no administrator sees none of it.
async function others(page) {
  await signIn(page, url, tokens.approver);
  await page.goto(`${url}/#/people/store`);
  await page.getByRole('heading', { name: 'Administration' }).waitFor();
  await soon(async () => (await page.getByRole('button', { name: 'Make a backup' }).count()) === 0, 'an approver makes no backup');
  await page.goto(`${url}/#/people/audit`);
  await page.getByRole('table', { name: 'Audit' }).waitFor();
}

await main([
  ['people', () => withPage(kDesk, people)],
  ['a profile', () => withPage(kDesk, profile)],
  ['files of profiles', () => withPage(kDesk, files)],
  ['a line test', () => withPage(kDesk, lineTest)],
  ['the store', () => withPage(kDesk, store)],
  ['one server', () => withPage(kDesk, alone)],
  ['an approver', () => withPage(kDesk, others)],
  ['on a tablet', () => withPage(kTablet, (page) => everyLook(page, 'tablet'))],
  ['on a phone', () => withPage(kPhone, (page) => everyLook(page, 'phone'))],
]);
