// What shops look for in such a page (docs/features.md), each with a picture, in the demo shop. It is walked by hand:
//   SCREENSHOTS=dir python3 tests/e2e/round.py build/dev/dripfeed features.mjs
// Only the feature itself is shown here; the other tests in this folder try each one thoroughly.
import { expect, live, main, shot, signIn, soon, until, withPage } from './browser.mjs';

const url = process.env.DRIPFEED_URL;
const token = process.env.DRIPFEED_TOKEN;
const kDesk = { viewport: { width: 1440, height: 900 } };
const kBlocks = 100_000;

async function call(method, path, body) {
  const headers = { Authorization: `Bearer ${token}`, 'Content-Type': 'application/json' };
  const answer = await fetch(`${url}/api/v1${path}`, { method, headers, body: body && JSON.stringify(body) });
  if (!answer.ok) throw new Error(`${method} ${path}: ${answer.status} ${await answer.text()}`);
  return answer.status === 204 ? null : answer.json();
}

const add = async (name, text) => (await call('POST', '/programs', { name, dialect: 'fanuc', text })).id;
const editor = (page) => page.getByRole('textbox', { name: /^Text of/ });
const dialog = (page) => page.getByRole('dialog');
const kSlot = '%\nO0900 (SLOT)\nG21 G17 G90 G94 G54\nN10 T1 M6\nS3000 M3\nN20 G0 X0 Y0\nG0 Z2.\nG1 Z-3. F120\nX40. F600\nG3 X60. Y20. I0 J20.\nG1 Y60.\nIF[#500 GT 2] GOTO 30\nX0\nN30 G0 Z20.\nM30\n%\n';

// A view at an address, and what must be there before the picture is taken.
async function at(page, address, mark) {
  await page.goto(`${url}/#/${address}`);
  await live(page);
  await mark(page).first().waitFor();
}

async function drawn(page) {
  await page.locator('.path-host canvas').waitFor();
  await page.waitForTimeout(1500); // the picture is drawn after its element is there
}

const made = {};
async function prepare() {
  made.slot = await add('O0900', kSlot);
  const lines = Array.from({ length: kBlocks }, (_, i) => `G1 X${((i % 4000) / 10).toFixed(1)} Y${Math.floor(i / 4000)}. F900.`);
  made.long = await add('O0901', `%\nO0901\nG21 G17 G90 G94 G54\nG0 X0 Y0 Z2.\n${lines.join('\n')}\nM30\n%\n`);
  made.faulty = await add('O0902', kSlot.replace('O0900', 'O0902').replace('G1 Y60.', 'G1 Y60.. Q[1'));
  const machines = await call('GET', '/machines');
  made.machine = machines.items.find(({ name }) => /fanuc/.test(name))?.name ?? machines.items[0].name;
  made.family = (await call('GET', '/families')).items[0].name;
}

// The machine whose first job can be armed is armed, as the page's own tests do by hand; the demo's control asks for it.
async function feed() {
  const { items } = await call('GET', '/jobs?state=queued&limit=200');
  items.sort((a, b) => Number(/plc/.test(a.machine)) - Number(/plc/.test(b.machine))); // its block is over in a moment
  for (const job of items) {
    const armed = await call('POST', `/jobs/${job.id}/arm`, {}).catch(() => null);
    if (armed) return armed;
  }
  throw new Error('no job of the demo can be armed');
}

const kRows = [
  ['01-toolpath', async (page) => {
    await at(page, `programs/${made.slot}?path=1`, editor);
    await drawn(page);
  }],
  ['02-line-and-path', async (page) => {
    await editor(page).getByText('G3 X60.').click();
    await until(async () => (await page.locator('.path-place').innerText()).includes('Line 10'), 'the cursor leads the tool');
  }],
  ['03-long-program', async (page) => {
    await at(page, `programs/${made.long}?path=1`, editor);
    await drawn(page);
    await soon(async () => (await page.getByRole('region', { name: 'Toolpath' }).innerText()).includes('100'), 'its segments are stated');
  }],
  ['04-sent-and-known', async (page) => {
    const job = await feed();
    await at(page, `machines/${encodeURIComponent(job.machine)}`, (one) => one.locator('.machine-view[data-line="feeding"], .machine-view[data-line="held"]'));
    await page.waitForTimeout(1000);
  }],
  ['05-statistics', async (page) => {
    await at(page, `programs/${made.slot}?figures=1`, (one) => one.getByRole('region', { name: 'Statistics' }).getByText(/Cuts/));
  }],
  ['06-search', async (page) => {
    await at(page, 'library', (one) => one.getByLabel('Search', { exact: true }));
    await page.getByLabel('Search', { exact: true }).fill('slto');
    await page.getByRole('link', { name: 'O0900', exact: true }).waitFor();
  }],
  ['07-upload', async (page) => {
    await at(page, 'library', (one) => one.locator('.library'));
    const data = await page.evaluateHandle((text) => {
      const transfer = new DataTransfer();
      for (const name of ['O0910.nc', 'O0911.nc']) transfer.items.add(new File([text.replace('O0900', name.slice(0, 5))], name));
      return transfer;
    }, kSlot);
    for (const event of ['dragenter', 'dragover', 'drop']) await page.locator('.library').dispatchEvent(event, { dataTransfer: data });
    await dialog(page).getByRole('button', { name: 'Upload 2 programs' }).waitFor();
  }],
  ['08-thumbnails-and-columns', async (page) => {
    await at(page, 'library', (one) => one.locator('.thumbnail svg'));
    await page.getByText('Columns', { exact: true }).click();
    await page.waitForTimeout(1500);
  }],
  ['09-queue', async (page) => {
    await at(page, `machines/${encodeURIComponent(made.machine)}`, (one) => one.locator('[data-part="queue"]'));
    await page.locator('[data-part="queue"]').scrollIntoViewIfNeeded();
  }],
  ['10-history', async (page) => {
    await at(page, 'history', (one) => one.getByRole('heading', { level: 1 }));
    await page.waitForTimeout(500);
  }],
  ['11-faults', async (page) => {
    await at(page, `programs/${made.faulty}`, (one) => one.locator('.fault'));
    await page.getByText('Help', { exact: false }).first().click().catch(() => undefined);
  }],
  ['12-compare', async (page) => {
    await at(page, `programs/${made.faulty}/compare?with=${made.slot}&with_revision=1`, (one) => one.locator('.changes-head, .change, [role="list"]'));
  }],
  ['13-renumber', async (page) => {
    await at(page, `programs/${made.slot}`, editor);
    await page.getByRole('button', { name: 'Rewrite…' }).click();
    await dialog(page).getByLabel('What is changed').waitFor();
  }],
  ['14-floor', (page) => at(page, 'floor', (one) => one.getByRole('article'))],
  ['15-wall', (page) => at(page, 'floor?look=andon', (one) => one.locator('main, [data-look]'))],
  ['16-tablet', async (page, picture) => {
    await page.setViewportSize({ width: 820, height: 1180 });
    await at(page, `machines/${encodeURIComponent(made.machine)}?station=1`, (one) => one.locator('.machine-view'));
    await picture();
    await page.setViewportSize(kDesk.viewport);
  }],
  ['17-notices', async (page, picture) => {
    await at(page, 'floor', (one) => one.getByRole('article'));
    const tray = page.getByRole('button', { name: /alarm/i }).first();
    await tray.click();
    await page.getByText('Notify me').waitFor();
    await picture();
    await tray.click();
  }],
  ['18-lasting-alarms', (page) => at(page, 'alarms', (one) => one.getByRole('heading', { level: 1 }))],
  ['19-stop-reasons', async (page) => {
    const job = await feed();
    await until(async () => (await call('GET', `/jobs/${job.id}`)).state === 'feeding', 'it feeds');
    await call('POST', `/jobs/${job.id}/stop`);
    await at(page, `machines/${encodeURIComponent(job.machine)}`, (one) => one.getByRole('button', { name: 'tool broken' }));
    await page.getByRole('button', { name: 'tool broken' }).click();
    await page.getByRole('listitem').getByText('tool broken').waitFor();
    await page.getByText('Why job').scrollIntoViewIfNeeded();
  }],
  ['20-roles', (page) => at(page, 'people/users', (one) => one.getByRole('heading', { level: 1 }))],
  ['21-keys', async (page) => {
    await at(page, 'floor', (one) => one.getByRole('article'));
    await page.keyboard.press('?');
    await dialog(page).waitFor();
  }],
  ['22-german', async (page, picture) => {
    await page.keyboard.press('Escape');
    const menu = page.locator('details.who > summary');
    await menu.click();
    await page.getByLabel('Language').selectOption('de');
    await page.getByRole('heading', { level: 1, name: 'Halle' }).waitFor();
    await picture();
    await page.getByLabel('Sprache').selectOption('en');
    await menu.click();
  }],
  ['23-arrangement', async (page) => {
    await at(page, `machines/${encodeURIComponent(made.machine)}`, (one) => one.getByText('Arrange this view'));
    await page.getByText('Arrange this view').click();
    await page.getByText('Reset the arrangement').scrollIntoViewIfNeeded();
  }],
  ['24-app', async (page) => {
    const manifest = await page.evaluate(async () => (await fetch(document.querySelector('link[rel="manifest"]').href)).json());
    expect(manifest.display === 'standalone' && manifest.icons.length > 0, 'the browser can install it');
    await at(page, 'floor', (one) => one.getByRole('article'));
  }],
  ['25-wire-and-store', async (page) => {
    await at(page, 'people/store', (one) => one.getByRole('heading', { name: 'Backups' }));
    await shot(page, 'feature-25-store');
    await at(page, `machines/${encodeURIComponent(made.machine)}`, (one) => one.getByRole('button', { name: 'Show the wire terminal' }));
    await page.getByRole('button', { name: 'Show the wire terminal' }).click();
    await page.getByRole('region', { name: 'Wire terminal' }).scrollIntoViewIfNeeded();
  }],
];

async function walk(page) {
  await prepare();
  await signIn(page, url, token);
  const failed = [];
  for (const [name, show] of kRows) {
    let isTaken = false;
    const picture = () => {
      isTaken = true;
      return shot(page, `feature-${name}`);
    };
    await show(page, picture).catch((error) => failed.push(`${name}: ${error.message.split('\n')[0]}`));
    if (!isTaken) await picture();
    await page.keyboard.press('Escape');
  }
  expect(failed.length === 0, `every feature is there: ${failed.join('; ') || 'all'}`);
}

await main([['what shops look for', () => withPage(kDesk, walk)]]);
