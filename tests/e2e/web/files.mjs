// The library's drawings and columns, and the files of programs, parts and orders, against the real server.
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { accessible, expect, fits, live, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1280, height: 900 } };
const kPhone = { width: 360, height: 740 };
const { url, tokens } = await rig.base();

const kHead = '%\nO1\nG21 G90 G94 G17 G54\nG0 X0 Y0 Z5.\n';
const kMilled = `${kHead}G1 Z-1. F100.\nX40.\nY30.\nG3 X20. Y50. I-20. J0.\nG1 X0\nY0\nG0 Z5.\nM30\n%\n`;
const kTurned = '%\nO2\nG21 G18 G90 G94 G54\nG0 X100. Z5.\nX20.\nG1 Z-30. F100.\nX40.\nZ-60.\nX60. Z-80.\nG0 X100.\nZ5.\nM30\n%\n';
const kStill = '%\nO3\nM5\nM30\n%\n';
const kLong = `${kHead}${'G1 X1. F100.\n'.repeat(90_000)}M30\n%\n`;
const kPixel = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR4nGNgYPj/HwADAgIAbo5N0wAAAABJRU5ErkJggg==', 'base64');

const dialog = (page) => page.getByRole('dialog');
const row = (page, name) => page.getByRole('row').filter({ has: page.getByRole('link', { name, exact: true }) });
const files = (page) => page.getByRole('region', { name: 'Files' });

async function add(name, text) {
  const answer = await rig.call('POST', '/programs', { name, dialect: 'fanuc', text }, 'programmer');
  return answer.body.id;
}

async function drawingsAndColumns(page) {
  for (const [name, text] of [['MILLED', kMilled], ['TURNED', kTurned], ['STILL', kStill], ['LONG', kLong], ['BROKEN', kStill.replace('M5', 'G1 X[1')]]) await add(name, text);
  await signIn(page, url, tokens.viewer);
  await page.getByRole('navigation', { name: 'Views' }).getByRole('link', { name: 'Library' }).click();
  const drawn = (name) => row(page, name).locator('.thumbnail');
  const asked = [];
  page.on('request', (request) => request.url().endsWith('picture?revision=1') && asked.push(request.url()));
  await row(page, 'MILLED').waitFor();
  for (const [name, as] of [['MILLED', 'isometric'], ['TURNED', 'turning']]) {
    await until(async () => (await drawn(name).getAttribute('data-drawn')) === as, `${name} is drawn`);
    const cut = await drawn(name).locator('.thumbnail-cut').getAttribute('d');
    expect(/^M\d+ \d+ \d+ \d+/.test(cut), `${name} has its cuts: ${cut}`);
  }
  await until(async () => (await drawn('STILL').innerText()) === 'no move', 'a program without a move has no drawing');
  await until(async () => (await drawn('BROKEN').innerText()) === 'no picture', 'one that cannot be run has none, and does not pass for one without a move');
  await until(async () => (await drawn('LONG').innerText()) === 'no picture', 'nor has a very long one');
  await soon(async () => (await drawn('LONG').locator('span').getAttribute('title')).includes('at most 1048576 bytes'), 'and the reason is there');
  await soon(async () => (await drawn('TURNED').getByRole('img').getAttribute('aria-label')).startsWith('Toolpath of TURNED'), 'it has a name');
  await soon(async () => (await page.locator('.thumbnail-part').count()) === 0, 'no cut is left out');
  await accessible(page, 'the library with its drawings');
  await shot(page, 'files-library');

  // The columns of a person.
  const head = (name) => page.getByRole('columnheader', { name, exact: true });
  await soon(async () => (await head('Dialect').count()) === 0 && (await head('Path').count()) === 1, 'the columns that all have');
  await page.getByText('Columns', { exact: true }).click();
  await page.getByLabel('Dialect').check();
  await page.getByLabel('Path', { exact: true }).uncheck();
  await soon(async () => (await head('Dialect').count()) === 1 && (await head('Path').count()) === 0, 'are chosen');
  await soon(async () => (await page.getByRole('checkbox', { name: 'Program', exact: true }).count()) === 0, 'the name is always there');
  await accessible(page, 'the choice of columns');
  const before = asked.length;
  await page.reload();
  await live(page);
  await row(page, 'MILLED').waitFor();
  await soon(async () => (await head('Dialect').count()) === 1 && (await head('Path').count()) === 0, 'the choice outlives a reload');
  expect(asked.length === before, 'and no drawing is asked for that is not shown');
  await page.getByText('Columns', { exact: true }).click();
  await page.getByLabel('Path', { exact: true }).check();
  await page.setViewportSize(kPhone);
  await fits(page, 'the library on a phone');
  await shot(page, 'files-library-phone');
}

// Drawings are asked for one after the other, and only of rows in sight.
async function onlyWhatIsSeen(page) {
  for (let i = 0; i < 60; i += 1) await add(`SHORT${i}`, kMilled);
  let most = 0;
  let now = 0;
  let all = 0;
  const isPicture = (request) => /\/picture\?/.test(request.url());
  page.on('request', (request) => {
    if (!isPicture(request)) return;
    all += 1;
    now += 1;
    most = Math.max(most, now);
  });
  page.on('requestfinished', (request) => isPicture(request) && (now -= 1));
  await signIn(page, url, tokens.viewer);
  await page.goto(`${url}#/library`);
  await page.locator('.thumbnail svg').first().waitFor();
  await until(() => now === 0 && all >= 3, 'those in sight are drawn');
  await new Promise((resolve) => setTimeout(resolve, 300));
  expect(most === 1, `one at a time: ${most}`);
  expect(all < 30, `not those out of sight: ${all}`);
  await page.locator('.thumbnail').last().scrollIntoViewIfNeeded();
  await until(async () => (await page.locator('.thumbnail').last().locator('svg').count()) === 1, 'they follow when they are reached');
}

async function ofAProgram(page) {
  const id = await add('WITH FILES', kMilled);
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}#/programs/${id}`);
  await page.getByRole('navigation', { name: /Places of/ }).or(page.locator('nav.tabs')).first().getByRole('link', { name: 'Files' }).click();
  await files(page).getByText('No file is attached').waitFor();
  const chosen = page.waitForEvent('filechooser');
  await files(page).getByRole('button', { name: 'Add files…' }).click();
  await (await chosen).setFiles([
    { name: 'clamping.png', mimeType: 'image/png', buffer: kPixel },
    { name: 'sheet.pdf', mimeType: 'application/pdf', buffer: Buffer.from('%PDF-1.4 of a sheet') },
    { name: 'empty.txt', mimeType: 'text/plain', buffer: Buffer.alloc(0) },
  ]);
  await files(page).getByRole('link', { name: 'sheet.pdf' }).waitFor();
  await page.getByRole('alert').waitFor();
  await soon(async () => (await page.getByRole('alert').innerText()).startsWith('empty.txt:'), 'an empty file is refused, the others are there');
  const picture = files(page).getByRole('img', { name: 'Picture clamping.png' });
  await until(() => picture.evaluate((one) => one.complete && one.naturalWidth === 1), 'the picture is shown');
  await soon(async () => (await files(page).getByRole('img').count()) === 1, 'a PDF is not');
  const download = page.waitForEvent('download');
  await files(page).getByRole('link', { name: 'sheet.pdf' }).click();
  expect((await download).suggestedFilename() === 'sheet.pdf', 'it is saved under its name');
  await accessible(page, 'the files of a program');
  await shot(page, 'files-program');

  // Dropped.
  const data = await page.evaluateHandle(() => {
    const transfer = new DataTransfer();
    transfer.items.add(new File(['<svg xmlns="http://www.w3.org/2000/svg"><script>document.title = "run"</script></svg>'], 'drawing.svg', { type: 'image/svg+xml' }));
    return transfer;
  });
  for (const event of ['dragover', 'drop']) await files(page).dispatchEvent(event, { dataTransfer: data });
  await files(page).getByRole('link', { name: 'drawing.svg' }).waitFor();
  await soon(async () => (await files(page).getByRole('img').count()) === 1, 'what could run is never shown');

  await files(page).getByRole('button', { name: 'Remove sheet.pdf' }).click();
  await dialog(page).getByLabel('Reason for the removal').fill('of another part');
  await dialog(page).getByRole('button', { name: 'Remove', exact: true }).click();
  await files(page).getByRole('link', { name: 'sheet.pdf' }).waitFor({ state: 'detached' });
  const kept = (await rig.call('GET', `/attachments?program=${id}`)).body.items.map(({ name }) => name);
  expect(kept.join() === 'drawing.svg,clamping.png', `the server has the rest: ${kept}`);
  await page.setViewportSize(kPhone);
  await fits(page, 'the files on a phone');
  await shot(page, 'files-program-phone');
}

async function ofAnOrder(page) {
  const { body: order } = await rig.call('POST', '/orders', { number: 'F-1', part: 'P-9', quantity: 3 });
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}#/orders/${order.id}`);
  const chosen = page.waitForEvent('filechooser');
  await files(page).getByRole('button', { name: 'Add files…' }).click();
  await (await chosen).setFiles({ name: 'order.pdf', mimeType: 'application/pdf', buffer: Buffer.from('%PDF-1.4 of an order') });
  await files(page).getByRole('link', { name: 'order.pdf' }).waitFor();
}

// A folder of a person's disk, with what folders of a shop have beside programs.
async function aFolder(page) {
  const folder = await mkdtemp(path.join(tmpdir(), 'shop-'));
  const write = async (name, body) => {
    await mkdir(path.dirname(path.join(folder, name)), { recursive: true });
    await writeFile(path.join(folder, name), body);
  };
  await write('pumps/O0810.nc', kMilled);
  await write('pumps/twice.nc', kMilled);
  await write('pumps/twice.txt', kTurned);
  await write('ALL.TXT', '%\nO0811\nM30\nO0812\nM30\n%\n');
  await write('sheet.pdf', '%PDF-1.4');
  const before = (await rig.call('GET', '/programs?limit=200')).body.items.length;
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}#/library`);
  const choose = async () => {
    const chosen = page.waitForEvent('filechooser');
    await page.getByRole('button', { name: 'Import a folder…' }).click();
    await (await chosen).setFiles(folder);
  };
  await choose();
  await dialog(page).getByRole('button', { name: 'Import 5 programs' }).waitFor();
  await soon(async () => (await dialog(page).getByRole('row').filter({ hasText: 'sheet.pdf' }).innerText()).includes('is not a text of a program'), 'the drawing is left alone');
  await soon(async () => (await rig.call('GET', '/programs?limit=200')).body.items.length === before, 'a look stores nothing');
  await accessible(page, 'the import');
  await soon(() => dialog(page).evaluate((one) => one.scrollWidth <= one.clientWidth), 'nothing of the dialog is cut off');
  await shot(page, 'files-import');
  await dialog(page).getByLabel('Into the library’s folder').fill('old');
  await dialog(page).getByRole('button', { name: 'Look again' }).click();
  await dialog(page).getByRole('row').filter({ hasText: 'old/pumps/twice.txt' }).waitFor();
  await dialog(page).getByRole('button', { name: 'Import 5 programs' }).click();
  await dialog(page).getByText('The import is done.').waitFor();
  await dialog(page).getByRole('button', { name: 'Back' }).click();
  await row(page, 'O0810').getByRole('link', { name: 'old/pumps' }).waitFor();
  const names = (await rig.call('GET', '/programs?limit=200')).body.items.filter((one) => one.folder?.startsWith('old')).map((one) => `${one.folder}/${one.name}`);
  expect(names.sort().join(' ') === 'old/ALL/O0811 old/ALL/O0812 old/pumps/O0810 old/pumps/twice.nc old/pumps/twice.txt', names.join(' '));
  await choose();
  await dialog(page).getByLabel('Into the library’s folder').fill('old');
  await dialog(page).getByRole('button', { name: 'Look again' }).click();
  await dialog(page).getByRole('button', { name: 'There is nothing to import.' }).waitFor();
  await page.setViewportSize(kPhone);
  await fits(page, 'the import on a phone');
  await shot(page, 'files-import-phone');
  await rm(folder, { recursive: true });
}

async function viewer(page) {
  const { body } = await rig.call('GET', '/attachments?limit=1');
  await signIn(page, url, tokens.viewer);
  await page.goto(`${url}#/orders/${body.items[0].order}`);
  await files(page).getByRole('link', { name: 'order.pdf' }).waitFor();
  await soon(async () => (await files(page).getByRole('button').count()) === 0, 'a viewer reads them and changes none');
}

await main([
  ['the library draws its programs, and a person chooses its columns', () => withPage(kDesk, drawingsAndColumns)],
  ['drawings are asked for as rows come into sight', () => withPage(kDesk, onlyWhatIsSeen)],
  ['files of a program are added, shown, saved and removed', () => withPage(kDesk, ofAProgram)],
  ['an order has files', () => withPage(kDesk, ofAnOrder)],
  ['a folder is looked at, and imported', () => withPage(kDesk, aFolder)],
  ['a viewer sees files', () => withPage(kDesk, viewer)],
]);
