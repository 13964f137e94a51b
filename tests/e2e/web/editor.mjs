// What a programmer does to a text in the editor beyond typing it: new numbers, blanks, letters, each one step that can be undone.
import { accessible, expect, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1280, height: 800 } };
const kPhone = { viewport: { width: 360, height: 740 }, hasTouch: true };
const { url, tokens } = await rig.base();
const kText = '%\nO0800 (SLOT one)\nG21 G17 G90 G94 G54\nT5 M6\nN10 G0 X0. Y0. Z5.\n#1 = 3\nN20 G1 X10. F100.\n#1 = #1 - 1\nIF [#1 GT 0] GOTO 20\nM30\n%\n';

const dialog = (page) => page.getByRole('dialog');
const editor = (page) => page.getByRole('textbox', { name: /^Text of/ });
const written = (page) => editor(page).innerText();

async function open(page, name, text) {
  const { body } = await rig.call('POST', '/programs', { name, dialect: 'fanuc', text });
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}/#/programs/${body.id}`);
  await editor(page).waitFor();
  return body;
}

async function rewrite(page, what) {
  await page.getByRole('button', { name: 'Rewrite…' }).click();
  await dialog(page).getByLabel('What is changed').selectOption({ label: what });
  await dialog(page).getByRole('button', { name: 'Change the text' }).click();
}

const gone = (page) => dialog(page).waitFor({ state: 'hidden' });

async function laysOut() {
  await withPage(kDesk, async (page) => {
    const { id } = await open(page, 'O0800', kText);
    const before = await written(page);
    await page.getByRole('button', { name: 'Rewrite…' }).click();
    await dialog(page).getByLabel('What is changed').selectOption({ label: 'Number all blocks' });
    await dialog(page).getByLabel('First number').fill('100');
    await accessible(page, 'laying a text out anew');
    await shot(page, 'editor-rewrite');
    await dialog(page).getByRole('button', { name: 'Change the text' }).click();
    await gone(page);
    await until(async () => /N140 G1 X10\. F100\./.test(await written(page)), 'blocks have numbers');
    await soon(async () => /GOTO 140/.test(await written(page)), 'the jump follows its block');
    await shot(page, 'editor-numbered');
    await editor(page).click();
    await page.keyboard.press('Control+z');
    await soon(async () => (await written(page)) === before, 'it is one step, and undone');
    await rewrite(page, 'Remove blanks');
    await gone(page);
    await soon(async () => /\nN20G1X10\.F100\.\n/.test(await written(page)) && /\(SLOT one\)/.test(await written(page)), 'blanks are gone, but in the comment');
    await rewrite(page, 'Add blanks between words');
    await gone(page);
    await soon(async () => /\nN20 G1 X10\. F100\.\n/.test(await written(page)), 'and come back');
    await rewrite(page, 'Capital letters');
    await dialog(page).getByText('There is nothing to change.').waitFor();
    await dialog(page).getByRole('button', { name: 'Back' }).click();
    await page.keyboard.press('Control+s');
    await page.getByText('As revision 2.').waitFor();
    const compared = await rig.call('GET', `/programs/${id}/compare?revision=1&with_revision=2`);
    expect(compared.body.meaning.answer === 'equal' && compared.body.motions.answer === 'equal', 'what is saved is the same program');
  });
}

// What could become another program stays, and the line is shown that stands against it.
async function refuses() {
  await withPage(kPhone, async (page) => {
    await open(page, 'O0801', kText.replace('O0800', 'O0801').replace('GOTO 20', 'GOTO 30'));
    const before = await written(page);
    await rewrite(page, 'Renumber the blocks that have a number');
    await dialog(page).getByRole('alert').getByText(/N30/).waitFor();
    await accessible(page, 'a refused change');
    await shot(page, 'editor-refused');
    await soon(async () => (await written(page)) === before, 'the text is as it was');
    await dialog(page).getByRole('button', { name: 'Line 9' }).click();
    await page.getByText('Line 9', { exact: false }).first().waitFor();
    await gone(page);
    await rewrite(page, 'Small letters');
    await dialog(page).getByRole('alert').waitFor();
    await soon(async () => (await written(page)) === before, 'a control without small letters gets none');
  });
}

const kTwoTools = '%\nO0802\nG21 G18 G90 G54\nT0101\nM3 S500\nG0 X100. Z10.\nG1 Z-20. F0.2\nT0202\nG0 X200. Z50.\nG1 X120.\nM30\n%\n';
const figures = (page) => page.getByRole('region', { name: 'Statistics' });

// Lengths and times by tool; what is written is compared with what is stored.
async function figuresOfText() {
  await rig.machine('lathe', { jobs: 0 });
  await withPage(kDesk, async (page) => {
    await open(page, 'O0802', kTwoTools);
    await page.getByRole('button', { name: 'Statistics' }).click();
    const tools = figures(page).getByRole('table', { name: 'Tools' });
    await tools.getByRole('row').filter({ hasText: 'T2' }).filter({ hasText: 'Line 8' }).waitFor();
    await figures(page).getByText(/name the machine/).waitFor();
    expect(true, 'without a machine no time is stated');
    await page.getByLabel('Read for').selectOption('lathe');
    await figures(page).getByText(/^Time of moves, dwells/).waitFor();
    await tools.getByRole('button', { name: 'Line 8' }).click();
    await page.locator('.writing-state').getByText('Line 8').waitFor();
    await editor(page).click();
    await page.keyboard.press('Control+End');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.insertText('G1 X90. F0.2\n');
    await figures(page).getByRole('columnheader', { name: 'As written' }).waitFor();
    await figures(page).getByRole('button', { name: 'Show what differs from revision 1' }).click();
    await figures(page).getByRole('list', { name: 'As written' }).getByText('G1 X90. F0.2').waitFor();
    await accessible(page, 'the figures of a text');
    await shot(page, 'editor-figures');
    await page.setViewportSize(kPhone.viewport);
    const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(wider <= 0, `on a phone it is as wide as the screen (${wider})`);
    await shot(page, 'editor-figures-phone');
  });
}

// A long text is translated when it is opened, and then when its person asks.
async function translatesLong() {
  await withPage(kDesk, async (page) => {
    const { id } = await open(page, 'O0803', `%\nO0803\nG21 G17 G90 G94 G54\n${'G1 X10.123 Y20.456 F1000.\n'.repeat(16_000)}M30\n%\n`);
    await page.goto(`${url}/#/programs/${id}?to=haas`);
    const panel = page.getByRole('region', { name: 'Translation' });
    await panel.getByRole('textbox').waitFor({ timeout: 60_000 });
    await editor(page).click();
    await page.keyboard.press('Control+Home');
    await page.keyboard.insertText('(A)\n');
    await panel.getByText(/The text is long/).waitFor();
    await shot(page, 'editor-long-translation');
    await panel.getByRole('button', { name: 'Read it again' }).click();
    await panel.getByText(/The text is long/).waitFor({ state: 'hidden' });
    expect(true, 'a long text is translated again when its person asks');
  });
}

// A line is gone to by keys alone, and the keyboard stays in the text: what is typed next is typed there.
async function goesToALine() {
  await withPage(kDesk, async (page) => {
    await open(page, 'O0803', kText.replace('O0800', 'O0803'));
    await editor(page).click();
    const field = page.getByRole('textbox', { name: 'Go to line' });
    for (const close of ['Enter', 'Escape']) {
      await page.keyboard.press('Control+Alt+g');
      await field.waitFor();
      await page.keyboard.type('3');
      await page.keyboard.press(close);
      await field.waitFor({ state: 'detached' });
      await until(() => editor(page).evaluate((one) => one.getRootNode().activeElement === one), `the keyboard is in the text after ${close}`);
    }
    await page.keyboard.press('Control+f');
    await page.getByRole('textbox', { name: 'Find' }).waitFor();
  });
}

await main([
  ['a line is gone to by keys', goesToALine],
  ['a text is laid out anew', laysOut],
  ['figures of a text', figuresOfText],
  ['a long text is translated when it is asked for', translatesLong],
  ['what could become another program is refused', refuses],
]);
