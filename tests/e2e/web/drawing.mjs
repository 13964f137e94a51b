// A family's drawing on the page: a parameter and its dimension light each other, a value that is dragged moves the drawing, and no text of any
// shipped family covers another one.
import { readdir, readFile } from 'node:fs/promises';
import { expect, fits, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1280, height: 1000 } };
const kPhone = { viewport: { width: 360, height: 740 }, hasTouch: true, colorScheme: 'dark' };
const kFolder = new URL('../../../deploy/families/', import.meta.url);
// Families that need a rotary axis, and the machine that has it.
const kOn = { 'seal-ring': 'sinumerik-810d-lathe', worm: 'mazak-vcn', 'worm-turned': 'mazak-integrex' };
const { url, tokens } = await rig.base();

const dimension = (page, name) => page.locator(`[data-dimension="${name}"]`).first();
const field = (page, name) => page.locator(`[data-parameter="${name}"]`);
const isLit = async (page, name) => (await dimension(page, name).getAttribute('data-lit')) === 'true';

async function upload(file) {
  const text = await readFile(new URL(file, kFolder), 'utf8');
  const { status, body } = await rig.call('POST', '/families', { text });
  expect(status === 201, `${file} is stored (${status})`);
  return body.name;
}

async function lights(page) {
  await rig.machine('drawn', { jobs: 0 });
  const name = await upload('hyperbolic-roll.family');
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}/#/families/${name}`);
  await dimension(page, 'roll_length').waitFor();
  await soon(async () => !(await isLit(page, 'roll_length')), 'nothing is lit at first');
  await field(page, 'roll_length').hover();
  await until(() => isLit(page, 'roll_length'), 'the field lights its dimension');
  await soon(async () => !(await isLit(page, 'clearance')), 'and no other one');
  await shot(page, 'drawing-lit-by-field');
  await dimension(page, 'clearance').locator('text').hover();
  await until(() => isLit(page, 'clearance'), 'a dimension is lit by itself');
  await until(async () => /parameter-lit/.test(await field(page, 'clearance').getAttribute('class')), 'and lights its field');
  await soon(async () => !(await isLit(page, 'roll_length')), 'the one before is dark again');
  await dimension(page, 'half_axis_x').locator('text').click();
  await until(() => field(page, 'half_axis_x').locator('input').first().evaluate((one) => one === document.activeElement), 'a click on a dimension leads to its field');
}

async function dragged(page) {
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}/#/families/hyperbolic-roll`);
  await dimension(page, 'roll_length').waitFor();
  const before = await dimension(page, 'roll_length').locator('text').innerHTML();
  const slide = field(page, 'roll_length').locator('input[type="range"]');
  await slide.scrollIntoViewIfNeeded();
  const box = await slide.boundingBox();
  const seen = [];
  await page.mouse.move(box.x + box.width * 0.5, box.y + box.height / 2);
  await page.mouse.down();
  for (const share of [0.52, 0.54, 0.56, 0.58]) {
    await page.mouse.move(box.x + box.width * share, box.y + box.height / 2);
    await until(async () => {
      const now = await dimension(page, 'roll_length').locator('text').innerHTML();
      return now !== (seen.at(-1) ?? before) && seen.push(now);
    }, 'the drawing follows while the value is dragged');
  }
  await page.mouse.up();
  const typed = await field(page, 'roll_length').locator('input').first().inputValue();
  await until(async () => (await dimension(page, 'roll_length').locator('text').innerHTML()) === `roll_length ${typed}`, `it ends at the value: ${typed}`);
  await shot(page, 'drawing-dragged');
}

// The rectangles of the texts as the browser has them, a pixel less on each side.
const covered = (page) =>
  page.locator('.drawing svg').evaluateAll((pictures) =>
    pictures.flatMap((picture) => {
      const all = [...picture.querySelectorAll('text')].map((one) => ({ text: one.textContent, at: one.getBoundingClientRect() }));
      return all.flatMap((a, index) =>
        all.slice(index + 1).flatMap((b) => (a.at.left + 1 < b.at.right - 1 && b.at.left + 1 < a.at.right - 1 && a.at.top + 1 < b.at.bottom - 1 && b.at.top + 1 < a.at.bottom - 1 ? [`${a.text} | ${b.text}`] : [])),
      );
    }),
  );

async function machines() {
  for (const preset of ['fanuc-0i-lathe', 'fanuc-0i-mill', 'sinumerik-840d-lathe', 'sinumerik-840d-mill', ...Object.values(kOn)]) {
    const profile = JSON.parse(await readFile(new URL(`../machines/${preset}.json`, kFolder), 'utf8'));
    profile.link.url = 'tcp://127.0.0.1:9';
    await rig.call('POST', '/machines', profile);
  }
}

const everyFamily = (size) => async (page) => {
  await machines();
  await signIn(page, url, tokens.programmer);
  const wrong = [];
  let drawn = 0;
  const files = (await readdir(kFolder)).filter((one) => one.endsWith('.family')).sort();
  for (const file of files) {
    const name = file.replace('.family', '');
    if ((await rig.call('GET', `/families/${name}`)).status === 404) await upload(file);
    await page.goto(`${url}/#/families/${name}`);
    await page.locator('[data-parameter]').first().waitFor();
    if (kOn[name]) await page.getByRole('region', { name: 'Preview' }).getByLabel('Machine').selectOption(kOn[name]);
    const isDrawn = await page.locator('[data-dimension]').first().waitFor({ timeout: 20_000 }).then(() => true, () => false);
    if (!isDrawn) {
      wrong.push(`${name}: no drawing: ${await page.locator('main [role="alert"]').allInnerTexts()}`);
      continue;
    }
    drawn += 1;
    for (const pair of await covered(page)) wrong.push(`${name}: ${pair}`);
    await fits(page, `${name}, ${size}`);
    await page.locator('.drawing').first().scrollIntoViewIfNeeded();
    await shot(page, `drawing-${size}-${name}`);
  }
  expect(drawn === files.length && drawn > 16, `${drawn} of ${files.length} families are drawn: ${wrong.join('; ')}`);
  expect(wrong.length === 0, `no text covers another one in ${drawn} drawings: ${wrong.join('; ')}`);
};

await main([
  ['a parameter and its dimension light each other', () => withPage(kDesk, lights)],
  ['a value is dragged', () => withPage(kDesk, dragged)],
  ['every family, desk', () => withPage(kDesk, everyFamily('desk'))],
  ['every family, phone', () => withPage(kPhone, everyFamily('phone'))],
]);
