// Time along a toolpath, the stock that its cuts leave and plots over time, against the real server: a roll on a lathe and
// a pocket on a mill from the shipped families, and programs of which less is known.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { accessible, expect, kSoftwarePictures, live, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1360, height: 1000 }, args: kSoftwarePictures };
const kSizes = { desk: kDesk.viewport, tablet: { width: 820, height: 1180 }, phone: { width: 360, height: 740 } };
const { url, tokens } = await rig.base();
const fileOf = (path) => readFileSync(fileURLToPath(new URL(`../../../deploy/${path}`, import.meta.url)), 'utf8');

// No tool of it is in the machine's profile, and it is of no family.
const kPlain = `%
O0830 (PLAIN)
G21 G17 G90 G94 G54
T1 M6
S3000 M3
G0 X0 Y0 Z5.
G1 Z-2. F100
X30. F600
T77 M6
G0 X30. Y0 Z5.
G1 Z-2. F100
Y20.
G0 Z20.
M30
%
`;

const panel = (page) => page.getByRole('region', { name: 'Toolpath' });
const canvas = (page) => page.locator('.path-host canvas');
const button = (page, name) => page.getByRole('button', { name, exact: true });
const timeSlider = (page) => page.getByRole('slider', { name: 'Time' });
const place = (page) => page.locator('.path-place').last();
const timeNow = async (page) => Number(await timeSlider(page).inputValue());

async function add(name, text) {
  return (await rig.call('POST', '/programs', { name, dialect: 'fanuc', text })).body.id;
}

let rendered = null;
// The roll and the pocket, rendered for a machine that has their tools.
async function programs() {
  if (rendered) return rendered;
  rendered = {};
  for (const [family, preset] of [
    ['hyperbolic-roll', 'fanuc-0i-lathe'],
    ['round-pocket', 'fanuc-0i-mill'],
  ]) {
    const profile = JSON.parse(fileOf(`machines/${preset}.json`));
    profile.link.url = 'tcp://127.0.0.1:9';
    await rig.call('POST', '/machines', profile);
    await rig.call('POST', '/families', { text: fileOf(`families/${family}.family`) });
    await rig.call('POST', '/parts', { number: `P-${family}`, family, values: {} });
    const { body } = await rig.call('POST', '/render', { part: `P-${family}`, machine: profile.name, delivery: 'drip' });
    rendered[family] = { id: body.program, machine: profile.name };
  }
  return rendered;
}

async function open(page, { id, machine }) {
  await page.goto(`${url}/#/programs/${id}?path=1&machine=${machine}`);
  await canvas(page).waitFor();
}

// How many dots of the picture have about this colour.
async function dots(page, [red, green, blue], within = 40) {
  const png = await canvas(page).screenshot();
  return page.evaluate(
    async ([base64, wanted, far]) => {
      const bytes = Uint8Array.from(atob(base64), (one) => one.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const on = new OffscreenCanvas(image.width, image.height).getContext('2d');
      on.drawImage(image, 0, 0);
      const { data } = on.getImageData(0, 0, image.width, image.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) if (Math.abs(data[i] - wanted[0]) + Math.abs(data[i + 1] - wanted[1]) + Math.abs(data[i + 2] - wanted[2]) < far) count += 1;
      return count;
    },
    [png.toString('base64'), [red, green, blue], within],
  );
}

async function time(page) {
  const { 'hyperbolic-roll': roll } = await programs();
  await signIn(page, url, tokens.programmer);
  await open(page, roll);
  await timeSlider(page).waitFor();
  const end = Number(await timeSlider(page).getAttribute('max'));
  const forecast = (await rig.call('POST', '/timing', { program: roll.id, machine: roll.machine, delivery: 'memory' })).body;
  expect(end > 0.8 * forecast.cycle_s && end <= forecast.cycle_s * 1.001, `the time is the forecast's (${end} of ${forecast.cycle_s} s)`);
  await accessible(page, 'time along a toolpath');
  for (const by of ['Feed as reached', 'Deviation', 'Time']) {
    await button(page, by).click();
    await page.getByRole('list', { name: 'Legend' }).getByText('not known').waitFor();
    await shot(page, `time-by-${by.replaceAll(' ', '-').toLowerCase()}`);
  }
  await soon(async () => /T0?6: the insert with its nose of 0\.8 mm/.test(await page.locator('.path-tool').innerText()), "the tool's insert and nose are its profile's");
  // A slider along time leads tool and text.
  await timeSlider(page).focus();
  await page.keyboard.press('Home');
  for (let i = 0; i < 10; i += 1) await page.keyboard.press('PageUp');
  const text = await timeSlider(page).getAttribute('aria-valuetext');
  expect(/ of .*Line \d+/.test(text), `it says time and place in words (${text})`);
  const line = Number(/Line (\d+)/.exec(await place(page).innerText())[1]);
  await until(async () => new RegExp(`Line ${line}\\b`).test(await page.locator('.writing-state').innerText()), 'the cursor follows');
  // Play, and pause.
  await page.getByLabel('Pace').selectOption('10');
  await page.keyboard.press('Home');
  await timeSlider(page).evaluate((one) => {
    one.value = '0';
    one.dispatchEvent(new Event('input', { bubbles: true }));
  });
  await button(page, 'Play').click();
  await until(async () => (await timeNow(page)) > 2, 'it runs');
  await button(page, 'Pause').click();
  const paused = await timeNow(page);
  await page.waitForTimeout(400);
  await soon(async () => (await timeNow(page)) === paused, 'and it stands still when it is paused');
  await shot(page, 'time-played');
}

async function plots(page) {
  const { 'hyperbolic-roll': roll } = await programs();
  await signIn(page, url, tokens.programmer);
  await open(page, roll);
  await page.locator('.path-head').getByLabel('Delivery').selectOption('drip');
  await timeSlider(page).waitFor();
  await button(page, 'Plots').click();
  const region = page.getByRole('region', { name: 'Plots over time' });
  await region.locator('canvas').nth(2).waitFor();
  await soon(async () => (await region.locator('figcaption').allInnerTexts()).join() === 'Feed along the path, mm/min; rapids run off the top,Buffer of the control, bytes,Deviation from the nominal, µm', 'feed, buffer and deviation');
  await region.scrollIntoViewIfNeeded();
  await shot(page, 'plots');
  await accessible(page, 'plots');
  const spanText = () => region.locator('.plots-bar .path-clock').innerText();
  const whole = await spanText();
  const box = await region.locator('.u-over').first().boundingBox();
  await page.mouse.move(box.x + box.width * 0.4, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.6, box.y + box.height / 2, { steps: 8 });
  await page.mouse.up();
  await until(async () => (await spanText()) !== whole, 'a drag zooms all three');
  const dragged = await spanText();
  await region.getByRole('application').focus();
  await page.keyboard.press('+');
  await until(async () => (await spanText()) !== dragged, 'so do keys');
  await page.keyboard.press('ArrowRight');
  await shot(page, 'plots-zoomed');
  await page.keyboard.press('0');
  await until(async () => (await spanText()) === whole, 'and 0 shows all of it');
  const before = await place(page).innerText();
  await page.mouse.click(box.x + box.width * 0.3, box.y + box.height / 2);
  await until(async () => (await place(page).innerText()) !== before, 'a click leads to the place');
  await until(async () => /Line \d+/.test(await page.locator('.writing-state').innerText()), 'and the text to its line');
}

async function pocket(page) {
  const { 'round-pocket': of } = await programs();
  await signIn(page, url, tokens.viewer);
  await open(page, of);
  await button(page, 'Stock').click();
  await page.getByText(/Heights every .* mm/).waitFor();
  await until(async () => (await dots(page, [150, 160, 168], 110)) > 3000, 'the block is drawn');
  await accessible(page, 'a stock');
  await shot(page, 'stock-pocket');
  await button(page, 'Against the nominal').click();
  const legend = page.getByRole('list', { name: 'Stock in the end' });
  await soon(async () => /within the tolerance/.test(await legend.innerText()), 'against the nominal');
  await shot(page, 'stock-pocket-nominal');
  await page.getByRole('group', { name: 'Cut open along' }).getByRole('button', { name: 'Y', exact: true }).click();
  await until(async () => (await dots(page, [138, 90, 60])) > 500, 'the section is open');
  await page.getByRole('slider', { name: 'Cut open at Y' }).focus();
  await page.keyboard.press('ArrowLeft');
  await shot(page, 'stock-pocket-section');
  // As it was in the middle of the time: less is cut.
  await page.getByRole('group', { name: 'Cut open along' }).getByRole('button', { name: 'Whole', exact: true }).click();
  await button(page, 'Against the nominal').click();
  await button(page, 'Top').click();
  const cut = async () => (await canvas(page).screenshot()).toString('base64');
  const end = await cut();
  await timeSlider(page).focus();
  for (let i = 0; i < 6; i += 1) await page.keyboard.press('PageDown');
  await until(async () => (await cut()) !== end, 'the stock is that of the time');
  await button(page, 'Oblique').click();
  await shot(page, 'stock-pocket-midway');
  // Two clicks measure.
  await button(page, 'Top').click();
  await button(page, 'Measure').click();
  const box = await canvas(page).boundingBox();
  await page.mouse.click(box.x + box.width * 0.45, box.y + box.height * 0.3);
  await page.mouse.click(box.x + box.width * 0.55, box.y + box.height * 0.3);
  await page.getByText(/[\d.]+ mm apart/).waitFor();
  const [, apart] = /([\d.]+) mm apart/.exec(await page.getByText(/mm apart/).innerText());
  expect(Number(apart) > 1 && Number(apart) < 200, `two places of the block are ${apart} mm apart`);
  await button(page, 'Take the tool’s place').click();
  await page.getByText(/Click on the second place/).waitFor();
  expect(true, 'the keyboard measures from the tool');
  await shot(page, 'stock-measured');
}

async function roll(page) {
  const { 'hyperbolic-roll': of } = await programs();
  await signIn(page, url, tokens.viewer);
  await open(page, of);
  await button(page, 'Stock').click();
  await page.getByText(/Radii every .* mm/).waitFor();
  await button(page, 'Oblique').click();
  await button(page, 'Against the nominal').click();
  await page.getByRole('list', { name: 'Stock in the end' }).waitFor();
  await shot(page, 'stock-roll');
  await page.getByRole('group', { name: 'Cut open along' }).getByRole('button', { name: 'Y', exact: true }).click();
  await until(async () => (await dots(page, [138, 90, 60])) > 500, 'the section is open');
  await shot(page, 'stock-roll-section');
}

async function plain(page) {
  const { 'round-pocket': { machine } } = await programs();
  const id = await add('O0830', kPlain);
  await signIn(page, url, tokens.programmer);
  await open(page, { id, machine });
  await button(page, 'Stock').click();
  await panel(page).getByText(/no stock is known/).waitFor();
  await page.getByLabel('Y to, mm').fill('20');
  await shot(page, 'stock-form');
  await accessible(page, 'a form for a blank');
  await button(page, 'State the blank').click();
  await page.getByText(/Heights every .* mm/).waitFor();
  await page.getByText(/The stock leaves out/).click();
  await panel(page).getByText(/diameter of tool 77 is not known/).waitFor();
  expect(true, 'a tool that is in no profile cuts nothing, and that is stated');
  await shot(page, 'stock-stated');
  await until(async () => /T77: its shape is in no profile/.test(await page.locator('.path-tool').innerText()), 'a mark stands for it');
  await timeSlider(page).focus();
  await page.keyboard.press('Home');
  await until(async () => {
    await page.keyboard.press('PageUp');
    return /T1: ⌀ 10 mm, 100 mm long.*Shank and holder begin 38 mm above the tip, up to ⌀ 63 mm/.test(await page.locator('.path-tool').innerText());
  }, 'one that is in it is drawn with its figures');
  await shot(page, 'stock-tool');
  // Without a machine there is no time.
  await page.goto(`${url}/#/programs/${id}?path=1`);
  await page.reload();
  await panel(page).getByText('Times along the toolpath are of a machine').waitFor();
  await soon(async () => (await timeSlider(page).count()) === 0, 'without a machine there is no time');
}

// From a change of a value to the new text and to the new path on the screen. What it costs is printed; that it follows is
// tested.
async function preview(page) {
  await programs();
  await signIn(page, url, tokens.programmer);
  await page.goto(`${url}/#/families/hyperbolic-roll`);
  await page.locator('.preview').getByLabel('Machine').selectOption('fanuc-0i-lathe');
  const field = page.getByLabel(/length of the barrel|roll_length/).first();
  const times = async (watched, values) => {
    const all = [];
    for (const value of values) {
      const took = await field.evaluate(
        async (input, [selector, text]) => {
          const before = document.querySelector(selector).textContent;
          const began = performance.now();
          Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, 'value').set.call(input, text);
          input.dispatchEvent(new Event('input', { bubbles: true }));
          while (document.querySelector(selector).textContent === before) {
            if (performance.now() - began > 15_000) return null;
            await new Promise((resolve) => {
              requestAnimationFrame(resolve);
            });
          }
          return performance.now() - began;
        },
        [watched, value],
      );
      if (took === null) throw new Error(`the preview did not follow ${value}`);
      all.push(took);
      await page.waitForTimeout(300);
    }
    all.sort((a, b) => a - b);
    return all;
  };
  const shown = (all) => `median ${Math.round(all[Math.floor(all.length / 2)])} ms, worst ${Math.round(all.at(-1))} ms`;
  await page.locator('.preview pre').waitFor();
  const texts = await times('.preview pre', ['150', '151.5', '162', '173', '184', '195', '140', '131', '122', '113.5']);
  console.log(`  text after a change of a value: ${shown(texts)}`);
  await button(page, 'Toolpath').click();
  await canvas(page).waitFor();
  await page.locator('.path-facts').waitFor();
  const paths = await times('.path-facts', ['150', '152', '163', '174', '185', '196', '141', '132', '123', '114']);
  console.log(`  toolpath and time after a change of a value: ${shown(paths)}`);
  await soon(async () => /Time on the machine/.test(await page.locator('.path-facts').innerText()), 'with the time on the machine');
  expect(paths.at(-1) < 15_000, 'it follows');
}

async function everyLook(page) {
  const { 'round-pocket': of } = await programs();
  await signIn(page, url, tokens.programmer);
  for (const [name, viewport] of Object.entries(kSizes)) {
    await page.setViewportSize(viewport);
    const german = name === 'tablet';
    await page.evaluate((language) => localStorage.setItem('dripfeed.language', language), german ? 'de' : 'en');
    for (const scheme of ['light', 'dark']) {
      await page.emulateMedia({ colorScheme: scheme });
      await open(page, of);
      await page.reload();
      await live(page);
      await canvas(page).waitFor();
      await button(page, german ? 'Rohteil' : 'Stock').click();
      await page.getByText(german ? /Höhen alle/ : /Heights every/).waitFor();
      await button(page, german ? 'Verläufe' : 'Plots').click();
      await page.locator('.plot canvas').first().waitFor();
      const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      expect(wider <= 0, `${name}, ${scheme}: as wide as the screen (${wider})`);
      await accessible(page, `${name}, ${scheme}`);
      await canvas(page).scrollIntoViewIfNeeded();
      await shot(page, `stock-look-${name}-${scheme}`);
      await page.locator('.plots').scrollIntoViewIfNeeded();
      await shot(page, `plots-look-${name}-${scheme}`);
    }
  }
}

await main([
  ['time along a toolpath', () => withPage(kDesk, time)],
  ['plots over time', () => withPage(kDesk, plots)],
  ['a pocket: stock, nominal, section, measure', () => withPage(kDesk, pocket)],
  ['a roll: stock of a lathe', () => withPage(kDesk, roll)],
  ['a plain program: a stated blank, an unknown tool', () => withPage(kDesk, plain)],
  ['a preview follows values', () => withPage(kDesk, preview)],
  ['every look', () => withPage(kDesk, everyLook)],
]);
