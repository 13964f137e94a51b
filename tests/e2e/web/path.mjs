// The toolpath beside its text, against the real server: a picture that one turns, points at and goes along, the
// same in words, what is not known of it, and a long path: about 185,000 segments,
// or a million, as many as are drawn at most, with PATH_RINGS=4600 (docs/measurements.md; minutes on a busy computer).
import { fileURLToPath } from 'node:url';
import { accessible, expect, kSoftwarePictures, live, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1360, height: 900 }, args: kSoftwarePictures };
const kSizes = { desk: kDesk.viewport, tablet: { width: 820, height: 1180 }, phone: { width: 360, height: 740 } };
const { url, tokens } = await rig.base();
const kRoll = fileURLToPath(new URL('../../../deploy/families/hyperbolic-roll.family', import.meta.url));

// A shaft with a cone, an arc and a thread.
const kShaft = `%
O0800 (SHAFT)
G21 G18 G90 G54
T0606
M3 S500
G0 X100. Z5.
G0 X60.
G1 Z-30. F0.25
X80. Z-50.
G2 X100. Z-60. R10. F0.1
G1 Z-90. F0.3
G0 X120. Z5.
T0303
G0 X60. Z5.
G32 Z-25. F2.
G0 X120. Z100.
M30
%
`;

const kPocket = `%
O0810 (POCKET)
G21 G17 G90 G94 G54
T1 M6
S3000 M3
G0 X0 Y0 Z20.
Z2.
G1 Z-3. F120
X40. F600
G3 X60. Y20. I0 J20.
G1 Y60.
G2 X40. Y60. I-10. J0
G1 X0
Y0
IF[#500 GT 2] GOTO 90
G1 X#501
N90 G0 Z20.
M30
%
`;

const panel = (page) => page.getByRole('region', { name: 'Toolpath' });
const picture = (page) => page.locator('.path-host');
const canvas = (page) => page.locator('.path-host canvas');
const place = (page) => page.locator('.path-place');
const slider = (page) => page.getByRole('slider', { name: 'Along the program' });
const editor = (page) => page.getByRole('textbox', { name: /^Text of/ });
const hereLine = async (page) => Number(/Line (\d+)/.exec(await page.locator('.writing-state').innerText())?.[1]);

const add = async (name, dialect, text) => (await rig.call('POST', '/programs', { name, dialect, text })).body.id;

// So many dots of the picture have another colour than its ground.
async function drawn(page) {
  const png = await canvas(page).screenshot();
  return page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (one) => one.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const on = new OffscreenCanvas(image.width, image.height).getContext('2d');
    on.drawImage(image, 0, 0);
    const { data } = on.getImageData(0, 0, image.width, image.height);
    let count = 0;
    for (let i = 4; i < data.length; i += 4) if (Math.abs(data[i] - data[0]) + Math.abs(data[i + 1] - data[1]) + Math.abs(data[i + 2] - data[2]) > 60) count += 1;
    return count;
  }, png.toString('base64'));
}

async function shaft(page) {
  await rig.machine('lathe', { jobs: 0 });
  const id = await add('O0800', 'fanuc', kShaft);
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}/#/programs/${id}?machine=lathe`);
  await editor(page).waitFor();
  await page.getByRole('button', { name: 'Toolpath' }).click();
  await canvas(page).waitFor();
  await until(async () => (await drawn(page)) > 300, 'the path is drawn');
  const words = await panel(page).innerText();
  expect(/X ⌀\s+60 … 120 mm/.test(words) && /Z\s+-90 … 100 mm/.test(words), 'its extent in words, X as the diameter that the program writes');
  expect(/Cuts\s+\d+ mm/.test(words) && /Rapids\s+\d+ mm/.test(words) && /Segments\s+\d+/.test(words), 'and its lengths');
  await accessible(page, 'a toolpath');
  await shot(page, 'path-shaft');

  // The cursor leads the tool, and the other direction.
  await editor(page).getByText('G32').click();
  await until(async () => (await place(page).innerText()).startsWith('Line 15: thread'), 'the line of the cursor is where the tool is');
  await soon(async () => (await place(page).innerText()).includes('2 mm/rev'), 'with its lead');
  await slider(page).focus();
  await page.keyboard.press('Home');
  await until(async () => (await hereLine(page)) < 8, 'the slider leads the cursor');
  const before = await hereLine(page);
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('ArrowRight');
  await until(async () => (await hereLine(page)) > before, 'step by step');
  await soon(async () => await slider(page).evaluate((one) => one === document.activeElement), 'the keyboard stays at the slider');
  await soon(async () => /^Line \d+: /.test(await slider(page).getAttribute('aria-valuetext')), 'which says the place in words');

  // A click on a segment: the cone from X60 Z-30 to X80 Z-50 is looked for along a line of the picture.
  await page.keyboard.press('End');
  await page.getByRole('button', { name: 'Turning drawing' }).click();
  const box = await canvas(page).boundingBox();
  const hit = new Set();
  for (let i = 1; i < 30; i += 1) {
    await page.mouse.click(box.x + (box.width * i) / 30, box.y + box.height * 0.62);
    hit.add(await hereLine(page));
    await slider(page).focus();
    await page.keyboard.press('End');
  }
  expect([...hit].filter((line) => line >= 6 && line <= 16).length >= 2, `a click on a segment goes to its line (${[...hit].join(', ')})`);

  // By the keyboard alone.
  await picture(page).focus();
  const from = await canvas(page).screenshot();
  for (const key of ['ArrowRight', 'ArrowUp', '+', 'Shift+ArrowLeft', '4']) await page.keyboard.press(key);
  await page.waitForTimeout(500);
  await soon(async () => !from.equals(await canvas(page).screenshot()), 'keys turn, move and zoom');
  await shot(page, 'path-shaft-oblique');
  await page.getByRole('button', { name: 'Programmed feed', exact: true }).click();
  await page.getByRole('list', { name: 'Legend' }).getByText('mm/rev').first().waitFor();
  await picture(page).focus();
  await page.keyboard.press('1');
  await shot(page, 'path-shaft-feed');

  // What is written is drawn, too, and nothing of it is stored.
  await editor(page).getByText('G1 Z-90. F0.3').click();
  await page.keyboard.press('End');
  await page.keyboard.insertText('\nX150.');
  await until(async () => /X ⌀\s+60 … 150 mm/.test(await panel(page).innerText()), 'the path follows what is written');
  await soon(async () => (await rig.call('GET', `/programs/${id}`)).body.revision === 1, 'and nothing is stored');
  await page.reload();
  await live(page);
  await canvas(page).waitFor();
  expect(true, 'a reload shows it again');
}

async function pocket(page) {
  const id = await add('O0810', 'fanuc', kPocket);
  await signIn(page, url, tokens.viewer);
  await page.goto(`${url}/#/programs/${id}?path=1`);
  await canvas(page).waitFor();
  await until(async () => (await drawn(page)) > 300, 'a viewer sees it, too');
  await panel(page).getByText('The toolpath is not all that the program may do').waitFor();
  await soon(async () => /#500/.test(await panel(page).getByRole('status').innerText()), "what decides is not known: in the verdict's words");
  await shot(page, 'path-pocket');
  await page.getByRole('button', { name: 'Top', exact: true }).click();
  await shot(page, 'path-pocket-top');
  const nothing = await add('O0811', 'fanuc', '%\nO0811\nM30\n%\n');
  await page.goto(`${url}/#/programs/${nothing}?path=1`);
  await panel(page).getByText('there is nothing to draw').waitFor();
  await shot(page, 'path-nothing');
}

async function family(page) {
  await rig.call('POST', '/families', { text: (await import('node:fs')).readFileSync(kRoll, 'utf8') });
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}/#/families/hyperbolic-roll`);
  await page.getByRole('button', { name: 'Toolpath' }).click();
  await canvas(page).waitFor();
  await until(async () => (await drawn(page)) > 300, 'the path of the values is drawn');
  const before = await page.locator('.path-facts').innerText();
  await page.getByLabel(/length of the roll|roll_length/).first().fill('150');
  await until(async () => (await page.locator('.path-facts').innerText().catch(() => before)) !== before, 'and follows the values');
  await canvas(page).waitFor();
  await accessible(page, 'a preview with its path');
  await shot(page, 'path-family');
}

async function everyLook(page) {
  await signIn(page, url, tokens.programmer);
  const { body } = await rig.call('GET', '/programs?name=O0800');
  for (const [name, viewport] of Object.entries(kSizes)) {
    await page.setViewportSize(viewport);
    await page.evaluate((language) => localStorage.setItem('dripfeed.language', language), name === 'tablet' ? 'de' : 'en');
    for (const scheme of ['light', 'dark']) {
      await page.emulateMedia({ colorScheme: scheme });
      await page.goto(`${url}/#/programs/${body.items[0].id}?path=1&machine=lathe`);
      await page.reload();
      await live(page);
      await canvas(page).waitFor();
      await until(async () => (await drawn(page)) > 100, 'the path is drawn');
      const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      expect(wider <= 0, `${name}, ${scheme}: as wide as the screen (${wider})`);
      await accessible(page, `${name}, ${scheme}`);
      await shot(page, `path-look-${name}-${scheme}`);
    }
  }
}

// Rings of chords. What it costs is printed; that it stays usable is tested.
const kRings = Number(process.env.PATH_RINGS ?? 500);
const kMostRingsDrawn = 4600;

async function longPath(page) {
  let text = '%\nO0820 (RINGS)\nG21 G17 G90 G94 G54\nG0 X0 Y0 Z0\nF1000\n';
  for (let i = 0; i < kRings; i += 1) text += `G1 X${40 + (i % 230)}. Z-${Math.floor(i / 230)}.\nG2 I-${40 + (i % 230)}.\n`;
  const id = await add('O0820', 'fanuc', `${text}M30\n%\n`);
  await signIn(page, url, tokens.programmer);
  const began = Date.now();
  await page.goto(`${url}/#/programs/${id}?path=1`);
  await canvas(page).waitFor({ timeout: 120_000 });
  await until(async () => (await drawn(page)) > 1000, 'it is drawn', 60_000);
  const segments = Number(/Segments\s+([\d\s\u202F]+)/.exec(await page.locator('.path-facts').innerText())[1].replace(/\D/g, ''));
  console.log(`  ${segments} segments are there ${Date.now() - began} ms after they were asked for`);
  expect(segments > 200 * kRings, 'as many segments as the rings have');
  if (kRings >= kMostRingsDrawn) await panel(page).getByText(/The first .* points are drawn/).waitFor();
  await shot(page, 'path-long');
  // Frames while it is turned by hand.
  const box = await canvas(page).boundingBox();
  const frames = page.evaluate(async () => {
    const times = [];
    const end = performance.now() + 4000;
    for (let now = performance.now(); now < end; ) {
      now = await new Promise((resolve) => {
        requestAnimationFrame(resolve);
      });
      times.push(now);
    }
    return times;
  });
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  for (let i = 0; i < 60; i += 1) {
    await page.mouse.move(box.x + box.width / 2 + 4 * i, box.y + box.height / 2 + i);
    await page.waitForTimeout(30);
  }
  await page.mouse.up();
  const times = await frames;
  const gaps = times.slice(1).map((time, i) => time - times[i]);
  gaps.sort((a, b) => a - b);
  const middle = gaps[Math.floor(gaps.length / 2)];
  console.log(`  turning: ${Math.round(1000 / middle)} frames a second, the slowest ${Math.round(gaps.at(-1))} ms`);
  expect(middle < 250, 'it turns');
  const click = Date.now();
  await page.mouse.click(box.x + box.width / 2 + 60, box.y + box.height / 2);
  await until(async () => (await place(page).innerText()).length > 0, 'a click is answered');
  console.log(`  a click is answered after ${Date.now() - click} ms`);
  await shot(page, 'path-long-turned');
}

await main([
  ['a shaft: picture, cursor, slider, click, keys, what is written', () => withPage(kDesk, shaft)],
  ['a pocket: what is not known', () => withPage(kDesk, pocket)],
  ['a family', () => withPage(kDesk, family)],
  ['every look', () => withPage(kDesk, everyLook)],
  ['a long path', () => withPage(kDesk, longPath)],
]);
