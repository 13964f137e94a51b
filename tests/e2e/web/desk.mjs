// A programmer's day against the real server: programs are dropped into the library, found, written and mended, compared,
// checked and handed in; a colleague saves meanwhile; a part gets its values.
import { fileURLToPath } from 'node:url';
import { accessible, expect, live, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1280, height: 800 } };
const kTablet = { viewport: { width: 820, height: 1180 }, hasTouch: true };
const kPhone = { viewport: { width: 360, height: 740 }, hasTouch: true };
const { url, tokens } = await rig.base();
const kRoll = fileURLToPath(new URL('../../../deploy/families/hyperbolic-roll.family', import.meta.url));
const kPump = '%\nO0700 (PUMP HOUSING)\nG21 G18 G90 G54\n(ROUGHING)\nT0606 M6\nG0 X100. Z10.\nM3 S500\nG1 Z-20. F0.2\nX110.\nG0 Z50.\nM5\nM30\n%\n';
const kFlange = kPump.replace('O0700 (PUMP HOUSING)', 'O0701 (FLANGE)').replace('T0606', 'T0303');

const dialog = (page) => page.getByRole('dialog');
const row = (page, name) => page.getByRole('row').filter({ has: page.getByRole('link', { name, exact: true }) });
const editor = (page) => page.getByRole('textbox', { name: /^Text of/ });
const faults = (page) => page.getByRole('complementary', { name: 'Faults and outline' });
const read = (page) => page.locator('[data-phase="known"]').waitFor();
// As the page has it: the browser's driver may hear of it later.
const addressOf = (page) => page.evaluate(() => location.hash);
async function at(page, address) {
  await until(async () => (await addressOf(page)) === address, `the address is ${address}`).catch(async (error) => {
    throw new Error(`${error.message}, not ${await addressOf(page)}`);
  });
}


// What a drop of files is to the page.
async function drop(page, files) {
  const data = await page.evaluateHandle((list) => {
    const transfer = new DataTransfer();
    for (const [name, text] of list) transfer.items.add(new File([text], name));
    return transfer;
  }, files);
  const target = page.locator('.library');
  for (const event of ['dragenter', 'dragover', 'drop']) await target.dispatchEvent(event, { dataTransfer: data });
}

// The whole text of the editor, whatever of it is on the screen.
async function write(page, text) {
  await editor(page).click();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(text);
}

async function upload(page) {
  await signIn(page, url, tokens.programmer);
  await page.getByRole('navigation', { name: 'Views' }).getByRole('link', { name: 'Library' }).click();
  await at(page, '#/library');
  await drop(page, [
    ['O0700.nc', kPump],
    ['O0701.nc', kFlange],
    ['empty.nc', ''],
  ]);
  await dialog(page).getByText('O0700.nc').waitFor();
  await soon(async () => (await dialog(page).getByLabel('Dialect').first().inputValue()) === 'fanuc', 'the server says in which dialect a file is');
  await dialog(page).getByLabel('Folder of new programs').fill('acme/pumps');
  await dialog(page).getByLabel('Dialect').nth(2).selectOption('fanuc');
  await accessible(page, 'the upload');
  await shot(page, 'desk-upload');
  await dialog(page).getByRole('button', { name: 'Upload 3 programs' }).click();
  await dialog(page).getByRole('alert').waitFor();
  await soon(async () => (await dialog(page).getByRole('alert').count()) === 1, 'the file that the server refuses says why, and no other');
  await soon(async () => (await dialog(page).getByRole('link').count()) === 2, 'the others are there');
  await dialog(page).getByRole('button', { name: 'Back' }).click();
  await row(page, 'O0700').getByRole('link', { name: 'acme/pumps' }).waitFor();
}

// The same name once more: asked, and then the next revision.
async function uploadAgain(page) {
  const before = await rig.call('GET', '/programs?name=O0701');
  await page.getByLabel('Search', { exact: true }).focus();
  const chosen = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Upload…' }).first().click();
  await (await chosen).setFiles({ name: 'O0701.nc', mimeType: 'text/plain', buffer: Buffer.from(kFlange.replace('S500', 'S600')) });
  await dialog(page).getByText('There is a program O0701 already').waitFor();
  await soon(() => dialog(page).getByLabel(/^as revision 2 of program/).isChecked(), 'it proposes the next revision');
  await dialog(page).getByRole('button', { name: 'Upload 1 program' }).click();
  await dialog(page).getByRole('link', { name: 'O0701' }).waitFor();
  await dialog(page).getByRole('button', { name: 'Back' }).click();
  const after = await rig.call('GET', '/programs?name=O0701');
  expect(after.body.items.length === before.body.items.length && after.body.items[0].revision === 2, 'it became a revision, no second program');
}

async function find(page) {
  const started = Date.now();
  await page.getByLabel('Search', { exact: true }).pressSequentially('housing');
  await page.locator('.snippet mark').first().waitFor();
  console.log(`  found ${Date.now() - started} ms after the first key`);
  await soon(async () => (await page.getByRole('row').count()) === 2, 'one program is found');
  await at(page, '#/library?q=housing');
  await shot(page, 'desk-found');
  await page.reload();
  await live(page);
  await page.locator('.snippet mark').first().waitFor();
  await soon(async () => (await page.getByLabel('Search', { exact: true }).inputValue()) === 'housing', 'a reload looks for the same');
  await page.getByLabel('Search', { exact: true }).fill('nothing like it anywhere');
  await page.getByRole('button', { name: 'Show all programs' }).click();
  await row(page, 'O0701').waitFor();
}

async function file(page) {
  const atOnce = page.evaluate(
    () =>
      new Promise((resolve) => {
        new MutationObserver((_, observer) => {
          const first = document.querySelector('.label-form input');
          if (!first) return;
          observer.disconnect();
          resolve(document.activeElement === first);
        }).observe(document.body, { subtree: true, childList: true });
      }),
  );
  await row(page, 'O0701').getByRole('button', { name: 'Change folder and tags of O0701' }).click();
  expect(await atOnce, 'the form has the focus as soon as it is there, and takes it from no other field later');
  await page.getByLabel('Tags, with commas between').fill('steel, flange');
  await page.keyboard.press('Enter');
  await row(page, 'O0701').getByRole('link', { name: 'flange' }).click();
  await at(page, '#/library?tag=flange');
  await until(async () => (await page.getByRole('row').count()) === 2, 'the tag filters');
  await row(page, 'O0701').getByRole('button', { name: 'Archive O0701' }).click();
  await dialog(page).getByLabel('Why it is put aside').fill('sold');
  await dialog(page).getByRole('button', { name: 'Archive…' }).click();
  await page.getByRole('button', { name: 'Show all programs' }).waitFor();
  await page.getByLabel('Shelf').selectOption('archived');
  await row(page, 'O0701').getByText('Archived by the programmer: sold').waitFor();
  await row(page, 'O0701').getByRole('button', { name: 'Use O0701 again' }).click();
  await dialog(page).getByLabel('Why it is used again').fill('ordered again');
  await dialog(page).getByRole('button', { name: 'Use again…' }).click();
  await page.getByRole('button', { name: 'Show all programs' }).click();
  await row(page, 'O0701').waitFor();
  await accessible(page, 'the library');
  await shot(page, 'desk-library');
}

// An error is seen while one types, explained, mended by its button, and saved.
async function mend(page) {
  await row(page, 'O0700').getByRole('link', { name: 'O0700', exact: true }).click();
  await editor(page).waitFor();
  await read(page);
  await until(async () => (await page.title()).startsWith('O0700'), 'the tab is named after the program');
  await soon(async () => (await faults(page).locator('.outline-go').allInnerTexts()).join(' ').includes('T0606'), 'the outline has the tool');
  await write(page, kPump.replace('X110.', 'x110.'));
  await faults(page).getByText('Line 9').waitFor();
  await accessible(page, 'a text with a fault');
  await shot(page, 'desk-fault');
  await soon(() => page.locator('.cm-lint-marker').first().isVisible(), 'the margin shows it');
  await faults(page).getByText('What helps').first().click();
  await faults(page).getByRole('button', { name: /^Write X/ }).click();
  await until(async () => (await faults(page).locator('.fault.tone-bad').count()) === 0, 'the fix mends it');
  await page.locator('.nc-code').first().hover();
  await page.locator('.nc-help').waitFor();
  await shot(page, 'desk-hover');
  await write(page, kPump.replace('X110.', 'X111.'));
  await page.getByText('Not saved.').waitFor();
  await page.waitForTimeout(600); // it is kept a moment after the last key
  page.once('dialog', (asked) => void asked.accept());
  await page.reload();
  await live(page);
  await page.getByText(/Your text of .* is here again/).waitFor();
  await editor(page).getByText('X111.').waitFor();
  expect(true, 'what was not saved is there after a reload');
  await page.getByRole('link', { name: 'Revisions' }).click();
  await page.getByRole('link', { name: 'Text', exact: true }).click();
  await editor(page).getByText('X111.').waitFor();
  expect(true, 'and when one comes back from another place');
  await editor(page).click();
  await page.keyboard.press('Control+s');
  await page.getByText('As revision 2.').waitFor();
  await page.goto(`${page.url()}?revision=1`);
  await page.getByText('Revision 1; the newest is 2.').waitFor();
  await editor(page).getByText('X110.').waitFor();
  await soon(async () => (await editor(page).getAttribute('contenteditable')) === 'false', 'an older revision is to read');
  await page.getByRole('link', { name: 'To the newest' }).click();
  await editor(page).getByText('X111.').waitFor();
  const { body } = await rig.call('GET', '/programs?name=O0700');
  expect(body.items[0].revision === 2, 'it is saved as the next revision');
  return body.items[0].id;
}

// Another person saves while one writes: both texts are there, and one's own is saved on top.
async function conflict(page, program) {
  await write(page, kPump.replace('X110.', 'X112.'));
  await rig.call('POST', `/programs/${program}/revisions`, { text: kPump.replace('X110.', 'X113.') }, 'admin', { 'If-Match': '"2"' });
  await page.getByRole('button', { name: 'Save as revision 3' }).click();
  await page.getByText(/saved revision 3 while you wrote on revision 2/).waitFor();
  await soon(() => editor(page).getByText('X112.').isVisible(), 'the own text is not lost');
  await accessible(page, 'a conflict');
  await shot(page, 'desk-conflict');
  await page.getByRole('button', { name: 'Go on with my text on top of revision 3' }).click();
  await page.getByRole('button', { name: 'Save as revision 4' }).click();
  await page.getByText('As revision 4.').waitFor();
  const text = await rig.text(`/programs/${program}/text`);
  expect(text === kPump.replace('X110.', 'X112.'), 'it is saved on top, byte for byte');
}

async function compare(page) {
  await page.getByRole('link', { name: 'Revisions' }).click();
  await page.getByRole('radio', { name: 'Revision 1 as: First' }).check();
  await page.getByRole('button', { name: 'Compare revisions 1 and 4' }).click();
  await page.getByRole('list', { name: 'O0700, revision 1' }).getByText('X110.').waitFor();
  await soon(() => page.getByRole('list', { name: 'O0700, revision 4' }).getByText('X112.').isVisible(), 'side by side');
  await accessible(page, 'a comparison');
  await shot(page, 'desk-compare');
  const address = new URL(page.url()).hash;
  await page.reload();
  await live(page);
  await page.getByRole('list', { name: 'O0700, revision 1' }).getByText('X110.').waitFor();
  await page.getByRole('link', { name: 'Where used' }).click();
  await page.getByText('Called by').waitFor();
  await page.goBack();
  await at(page, address);
}

// What was released before, as an approver did it.
async function releaseFirst(program, machine = 'lathe') {
  const of = { program, revision: 1, machine };
  await rig.call('POST', '/checks', of);
  const { body } = await rig.call('POST', '/releases', of);
  await rig.call('PUT', `/groups/of-${machine}`, { machines: [machine], operator_sign_off: false });
  for (const step of [{ to: 'in_review' }, { to: 'proving', transfers: 1 }, { to: 'approved', note: 'measured' }]) {
    const moved = await rig.call('POST', `/releases/${body.id}/transitions`, step, 'approver');
    expect(moved.status === 200, `revision 1 is ${step.to}`);
  }
}

// A check whose answer comes late does not take a person back who has gone on meanwhile.
async function stays(page, program) {
  const answered = page.waitForResponse((response) => response.request().method() === 'POST' && response.url().endsWith('/checks'));
  await page.route('**/api/v1/checks', async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 500));
    await route.continue();
  });
  await page.getByRole('button', { name: 'Check revision 4' }).click();
  await page.getByRole('link', { name: 'Release' }).click();
  await answered;
  await page.unroute('**/api/v1/checks');
  await page.getByRole('button', { name: 'Draft a release of revision 4' }).waitFor();
  await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 300)));
  expect(new URL(page.url()).hash === `#/programs/${program}/release`, 'a late answer leaves a person where they are');
  await page.getByRole('link', { name: 'Checks' }).click();
  await page.getByRole('heading', { name: /^Check \d+/ }).waitFor();
}

async function handIn(page, program) {
  await releaseFirst(program);
  await page.getByRole('link', { name: 'Checks' }).click();
  await stays(page, program);
  await page.getByRole('button', { name: 'Check revision 4' }).click();
  await page.getByRole('heading', { name: /^Check \d+/ }).waitFor();
  await accessible(page, 'a check');
  await shot(page, 'desk-check');
  await page.getByRole('link', { name: 'Release' }).click();
  await page.getByRole('button', { name: 'Draft a release of revision 4' }).click();
  await page.getByRole('button', { name: /^Hand release/ }).click();
  await dialog(page).getByText('Verdict:').waitFor();
  await dialog(page).getByText(/What has changed since release \d+, revision 1/).waitFor();
  await dialog(page).getByRole('list', { name: 'O0700, revision 4' }).getByText('X112.').waitFor();
  expect(true, 'it shows what has changed since the last release');
  await dialog(page).getByLabel('Note for the reviewer').fill('new speed');
  await accessible(page, 'handing in');
  await shot(page, 'desk-hand-in');
  await dialog(page).getByRole('button', { name: 'Hand in for review' }).click();
  await page.locator('[data-state="in_review"]').waitFor();
  const { body } = await rig.call('GET', `/releases?program=${program}`);
  expect(body.items[0].state === 'in_review', 'a programmer hands it in');
}

// A finding leads to its line, and the text is searched.
async function failing(page) {
  const text = kPump.replace('O0700', 'O0702').replace('X110.', 'X9000.');
  const { body } = await rig.call('POST', '/programs', { name: 'O0702', dialect: 'fanuc', text });
  await page.goto(`${url}/#/programs/${body.id}/checks`);
  await page.getByRole('button', { name: 'Check revision 1' }).click();
  await page.locator('.fault.tone-bad').first().waitFor();
  await accessible(page, 'a check that fails');
  await shot(page, 'desk-check-failed');
  await page.locator('.fault.tone-bad').getByRole('link', { name: 'Line 9' }).first().click();
  await page.locator('.cm-activeLine').getByText('X9000.').waitFor();
  expect(true, 'a finding leads to its line');
  await page.getByRole('button', { name: 'Find' }).click();
  await page.getByRole('textbox', { name: 'Find' }).pressSequentially('Z50.');
  await page.locator('.cm-searchMatch').first().waitFor();
  await accessible(page, 'a search in the text');
  await shot(page, 'desk-find-in-text');
}

async function day(page) {
  await rig.machine('lathe');
  await upload(page);
  await uploadAgain(page);
  await find(page);
  await file(page);
  const program = await mend(page);
  await conflict(page, program);
  await compare(page);
  await handIn(page, program);
  await failing(page);
}

// The verdict beside a preview is that of a check, follows the values, and is stored nowhere.
async function judged(page) {
  const summary = page.locator('.judged:not([aria-busy=true]) > summary');
  const shown = async (values) => {
    const { body } = await rig.call('POST', '/preview/verdict', { family: 'hyperbolic-roll', values, machine: await page.locator('.preview').getByLabel('Machine').inputValue(), delivery: 'drip' });
    await until(async () => (await summary.count()) === 1 && new RegExp(`${body.verdict}.*cycle time`, 'is').test(await summary.innerText()), `the verdict on it is ${body.verdict}`);
    return { verdict: body.verdict, words: await summary.innerText() };
  };
  const fast = await shown({ speed_rpm: '777 rpm' });
  await page.getByLabel(/spindle speed/).fill('77');
  await page.locator('.judged[aria-busy=true]').waitFor();
  await until(async () => (await summary.count()) === 1 && (await summary.innerText()) !== fast.words, 'and another one for other values');
  await summary.click();
  await page.locator('.judged').getByText('Blocks').waitFor();
  await page.locator('.preview').scrollIntoViewIfNeeded();
  await accessible(page, 'the verdict on a preview');
  await shot(page, 'desk-preview-verdict');
  await page.getByLabel(/spindle speed/).fill('777');
}

// What the variables of a macro mean stands beside its text. Plain blocks have none.
async function legend(page) {
  const title = page.locator('.preview summary', { hasText: /Variables \(\d+\)/ });
  await soon(async () => (await title.count()) === 0, 'plain blocks have no variables');
  await page.locator('.preview').getByLabel('Delivery').selectOption('memory');
  await title.click();
  const order = { family: 'hyperbolic-roll', values: { speed_rpm: '777 rpm' }, machine: await page.locator('.preview').getByLabel('Machine').inputValue(), delivery: 'memory' };
  const { body } = await rig.call('POST', '/preview', order);
  const table = page.getByRole('region', { name: 'Variables of the program' });
  const shown = await table.locator('tbody tr').allInnerTexts();
  expect(shown.length === body.legend.length && body.legend.every(({ variable, name }, row) => shown[row].includes(variable) && shown[row].includes(name)), `${shown.length} variables of the macro are named`);
  await accessible(page, 'the variables of a macro');
  await table.scrollIntoViewIfNeeded();
  await shot(page, 'desk-preview-legend');
  await page.locator('.preview').getByLabel('Delivery').selectOption('drip');
}

async function part(page) {
  await rig.machine('roll-bench', { jobs: 0 });
  await signIn(page, url, tokens.programmer);
  await page.getByRole('navigation', { name: 'Views' }).getByRole('link', { name: 'Parts' }).click();
  const chosen = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Upload a family…' }).click();
  await (await chosen).setFiles(kRoll);
  await page.getByRole('link', { name: 'Hyperbolic rolling-mill roll', exact: true }).click();
  await page.getByLabel('Part number').fill('R-7');
  const preview = page.getByLabel('Text of the program');
  await preview.getByText('M30').waitFor();
  const before = await preview.innerText();
  await page.getByLabel(/spindle speed/).fill('777');
  await until(async () => (await preview.innerText()).includes('S777'), 'the preview follows what is typed');
  expect(!before.includes('S777'), 'and was another one before');
  const { body } = await rig.call('GET', '/programs?part=R-7');
  expect(body.items.length === 0, 'a preview stores nothing');
  await judged(page);
  await legend(page);
  await page.getByLabel(/step of the angle/).fill('99 deg');
  await page.locator('[data-parameter="angle_step"] .parameter-fault').waitFor();
  expect(true, 'a value that is not possible is said at its field while one types');
  await page.getByRole('button', { name: 'Make the part' }).click();
  await page.getByText('Some values are not possible').waitFor();
  await accessible(page, 'a value that is not possible');
  await shot(page, 'desk-part');
  await page.getByLabel(/step of the angle/).fill('1');
  await page.getByRole('button', { name: 'Make the part' }).click();
  await at(page, '#/parts/R-7');
  await soon(async () => (await rig.call('GET', '/parts/R-7')).body.values.angle_step === '1 deg', 'a plain number is in the unit of its field');
  await page.getByRole('button', { name: 'Add an order for this part…' }).click();
  await soon(async () => (await dialog(page).getByLabel('Part', { exact: true }).inputValue()) === 'R-7', 'an order of the part');
  await dialog(page).getByLabel('Number of the planner').fill('A-R7');
  await dialog(page).getByRole('button', { name: 'Add an order' }).click();
  await page.getByRole('heading', { name: 'Order A-R7' }).waitFor();
  await soon(async () => (await rig.call('GET', '/orders?number=A-R7')).body.items[0].part === 'R-7', 'is there');
  await page.goBack();
  await at(page, '#/parts/R-7');
  const region = page.getByRole('region', { name: 'Feasible region' });
  await region.getByRole('button', { name: 'Compute it' }).click();
  await region.getByText(/The defaults pass on/).waitFor({ timeout: 120_000 });
  await region.locator('[data-parameter="roll_length"] svg').waitFor();
  await page.getByLabel(/length of the barrel/).fill('995');
  await region.getByText('995 does not pass').waitFor();
  await accessible(page, 'the feasible region');
  await region.scrollIntoViewIfNeeded();
  await shot(page, 'region');
  await page.getByLabel(/length of the barrel/).fill('');
  await queuedFromPart(page);
  await page.locator('[data-program]').getByRole('link', { name: /./ }).first().click();
  await editor(page).waitFor();
}

// From the part to a job of it: rendered, released by others, queued; nothing is sent.
async function queuedFromPart(page) {
  await page.locator('section').filter({ has: page.getByRole('heading', { name: 'Programs' }) }).getByLabel('Machine').selectOption('roll-bench');
  await page.getByRole('button', { name: 'Render for this machine' }).click();
  const made = page.locator('[data-program]');
  await made.getByRole('link', { name: /^Hand in / }).waitFor();
  await releaseFirst(Number(await made.getAttribute('data-program')), 'roll-bench');
  await page.reload();
  await live(page);
  await made.getByText(/: approved\./).waitFor();
  await accessible(page, 'the programs of a part');
  await made.scrollIntoViewIfNeeded();
  await shot(page, 'desk-part-programs');
  await made.getByRole('button', { name: /^Queue a job/ }).click();
  await dialog(page).getByRole('button', { name: 'Queue', exact: true }).click();
  await page.getByRole('status').getByText(/Queued as job/).waitFor();
  const { body } = await rig.call('GET', '/jobs?machine=roll-bench');
  expect(body.items.length === 1 && body.items[0].state === 'queued', 'the job waits in the queue of its machine');
}

// What was changed at the control comes back, and is the part's: its values, not only its text.
async function sentBack(page) {
  await rig.machine('sends-back', { jobs: 0 });
  await rig.call('POST', '/parts', { number: 'R-8', family: 'hyperbolic-roll', values: { angle_step: '2 deg' } });
  const { body } = await rig.call('POST', '/render', { part: 'R-8', machine: 'sends-back', mode: 'macro', delivery: 'memory', name: 'O0808' });
  const text = await rig.text(`/programs/${body.program}/text`);
  await rig.punch('sends-back', text.replace('=196.(', '=188.5('));
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}/#/received`);
  await page.getByRole('row').filter({ hasText: 'O0808' }).getByRole('button', { name: /^Accept/ }).click();
  await dialog(page).getByText('the family gives exactly what was received').waitFor();
  await dialog(page).getByText('196 mm').waitFor();
  await dialog(page).getByText('Compare with revision 1').click();
  await dialog(page).getByRole('region', { name: 'Changed lines' }).waitFor();
  await accessible(page, 'values that came back');
  await shot(page, 'received-values');
  await dialog(page).getByRole('button', { name: 'Save these values in part R-8' }).click();
  await dialog(page).getByRole('link', { name: /Part R-8 has them/ }).waitFor();
  const now = (await rig.call('GET', '/parts/R-8')).body;
  expect(now.values.roll_length === '188.5 mm' && now.values.angle_step === '2 deg' && now.revision === 2, 'the part has the value, and keeps its others');
}

const kLoop = '%\nO0710 (PASSES)\nG21 G17 G90 G94 G54\nT5 M6\nM3 S800\nG0 X0 Y0 Z5.\n#101=0\nWHILE[#101LT3]DO1\nG1 Z[-#101] F100.\nX[10.+#101]\nG0 X0\n#101=#101+1\nEND1\nG0 Z50.\nM30\n%\n';

async function translation(page) {
  const { body } = await rig.call('POST', '/programs', { name: 'O0710', dialect: 'fanuc', text: kLoop });
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}/#/programs/${body.id}`);
  await page.getByRole('button', { name: 'Translation' }).click();
  await page.getByText('Choose a machine or a control.').waitFor();
  await page.getByLabel('Translate for').selectOption('sinumerik-840d');
  const panel = page.getByRole('region', { name: 'Translation' });
  await panel.getByText('both were run and move the same').waitFor();
  const translated = panel.getByRole('textbox', { name: 'Translation for SINUMERIK 840D' });
  await translated.getByText('WHILE R101').waitFor();
  await page.getByRole('textbox', { name: /^Text of/ }).getByText('#101=#101+1').click();
  await translated.locator('.cm-activeLine').getByText('R101=R101+1').waitFor();
  expect(true, "the cursor's line is shown in the translation");
  await translated.getByText('ENDWHILE').click();
  await page.getByRole('textbox', { name: /^Text of/ }).locator('.cm-activeLine').getByText('END1').waitFor();
  expect(true, 'and the other side follows');
  await accessible(page, 'a translation');
  await shot(page, 'desk-translation');
  await panel.getByLabel(/^As/).selectOption('explicit');
  await translated.getByText('X12').waitFor();
  await panel.getByRole('button', { name: 'Keep it as a program…' }).click();
  await dialog(page).getByLabel('Name').fill('PASSES.MPF');
  await dialog(page).getByRole('button', { name: 'Keep it' }).click();
  await page.getByRole('heading', { name: 'PASSES.MPF' }).waitFor();
  const kept = (await rig.call('GET', '/programs?name=PASSES.MPF')).body.items;
  expect(kept.length === 1 && kept[0].dialect === 'sinumerik-840d', 'it is a program of its own, in its own language');
  await page.goBack();
  await write(page, kLoop.replace('G0 X0 Y0 Z5.', 'G0 X0 Y0 Z5. G65 P9999'));
  await panel.getByText('refused').waitFor();
  await panel.locator('.fault').first().waitFor();
  await shot(page, 'desk-translation-refused');
}

// A dump of a control's memory becomes its programs.
async function dump(page) {
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}/#/library`);
  await page.getByRole('button', { name: 'Upload…' }).first().waitFor();
  const text = kPump.replace('O0700', 'O0720').replace('M30\n%', 'M30\nO0721 (GROOVE)\nG0 X0\nM99\n:0722\nM99\n%').split('\n').join('\r\n');
  await drop(page, [['ALL-PROG.TXT', text]]);
  await dialog(page).getByText('The file holds 3 programs: O0720 (PUMP HOUSING), O0721 (GROOVE)').waitFor();
  await shot(page, 'desk-dump');
  await dialog(page).getByRole('button', { name: 'Take it apart' }).click();
  await dialog(page).getByRole('button', { name: 'Upload 3 programs' }).click();
  await until(async () => (await dialog(page).getByRole('link').count()) === 3, 'all three are there');
  await accessible(page, 'a dump');
  const { body } = await rig.call('GET', '/programs?name=O0721');
  const stored = await fetch(`${url}/api/v1/programs/${body.items[0].id}/text`, { headers: { Authorization: `Bearer ${tokens.viewer}` } });
  expect((await stored.text()) === '%\r\nO0721 (GROOVE)\r\nG0 X0\r\nM99\r\n%\r\n', 'each with the line ends of the file');
}

async function pages(page) {
  for (let i = 0; i < 60; ++i) await rig.call('POST', '/programs', { name: `P${i}`, dialect: 'fanuc', text: `%\nO${i + 1}\nM30\n%\n` });
  await signIn(page, url, tokens.viewer);
  await page.goto(`${url}/#/library`);
  const rows = page.locator('[data-program]');
  await until(async () => (await rows.count()) === 50, 'a page has 50 programs');
  await page.getByRole('button', { name: 'Show more' }).click();
  await until(async () => (await rows.count()) > 60, 'the next page comes after it');
  const ids = await rows.evaluateAll((all) => all.map((one) => one.dataset.program));
  expect(new Set(ids).size === ids.length, 'each program once');
}

// Who may only look has no button that the server would refuse.
async function viewer(page) {
  await signIn(page, url, tokens.viewer);
  await page.goto(`${url}/#/library`);
  await page.getByRole('link', { name: 'O0700', exact: true }).click();
  const [, id] = /#\/programs\/(\d+)/.exec(page.url());
  await editor(page).waitFor();
  await page.locator('.nc-code').first().waitFor();
  await soon(async () => (await editor(page).getAttribute('contenteditable')) === 'false', 'the text is to read');
  await page.locator('.nc-code').first().hover();
  await page.waitForTimeout(700);
  await soon(async () => (await page.locator('.nc-help').count()) === 0, 'nothing is explained while the control is not known');
  for (const place of ['Text', 'Revisions', 'Checks', 'Release']) {
    await page.getByRole('link', { name: place, exact: true }).click();
    await at(page, `#/programs/${id}${place === 'Text' ? '' : `/${place.toLowerCase()}`}`);
    await page.getByRole('main').locator('.editor, .table, .empty').first().waitFor();
    await soon(async () => (await page.getByRole('button', { name: /Save|Check revision|Draft|Hand|Archive|Upload|Change/ }).count()) === 0, `${place}: no order for a viewer`);
  }
}

async function everyLook(page) {
  await signIn(page, url, tokens.programmer);
  const { body } = await rig.call('GET', '/programs?name=O0700');
  const speak = (tag) => page.evaluate((language) => localStorage.setItem('dripfeed.language', language), tag);
  for (const [name, { viewport }] of Object.entries({ desk: kDesk, tablet: kTablet, phone: kPhone })) {
    await page.setViewportSize(viewport);
    await speak(name === 'tablet' ? 'de' : 'en');
    await page.reload();
    await live(page);
    for (const scheme of ['light', 'dark']) {
      await page.emulateMedia({ colorScheme: scheme });
      for (const [place, address, there] of [
        ['library', '#/library', '[data-program]'],
        ['text', `#/programs/${body.items[0].id}`, '[data-phase="known"]'],
        ['compare', `#/programs/${body.items[0].id}/compare`, '.change'],
        ['checks', `#/programs/${body.items[0].id}/checks`, '.card'],
        ['part', '#/parts/R-7', '[data-parameter]'],
      ]) {
        await page.goto(`${url}/${address}`);
        await page.locator(there).first().waitFor();
        const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        expect(wider <= 0, `${place}, ${name}, ${scheme}: as wide as the screen (${wider})`);
        if (name !== 'tablet') await accessible(page, `${place}, ${name}, ${scheme}`);
        await shot(page, `look-${place}-${name}-${scheme}`);
      }
    }
  }
}

await main([
  ['a programmer: upload, find, file, mend, conflict, compare, hand in', () => withPage(kDesk, day)],
  ['a part by its values', () => withPage(kDesk, part)],
  ['what a control sends back', () => withPage(kDesk, sentBack)],
  ['a translation', () => withPage(kDesk, translation)],
  ['a dump', () => withPage(kDesk, dump)],
  ['a viewer', () => withPage(kDesk, viewer)],
  ['pages of the library', () => withPage(kDesk, pages)],
  ['every look', () => withPage(kDesk, everyLook)],
]);
