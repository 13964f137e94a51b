// A headless Chromium with an empty profile of its own, and what the browser tests share: steps, expectations,
// screenshots (into the folder SCREENSHOTS, where it is set), and that the page reports no fault of its own.
import { mkdtemp, mkdir, readFile, rm } from 'node:fs/promises';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';

const require = createRequire(new URL('../../../web/package.json', import.meta.url));
const { chromium } = require('playwright-core');

const kFlags = [
  '--headless',
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

// With what a computer without a graphics card draws pictures in three dimensions.
export const kSoftwarePictures = [...kFlags, '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

export async function withPage(options, test) {
  const profile = await mkdtemp(path.join(os.tmpdir(), 'dripfeed-browser-'));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: kFlags,
    viewport: { width: 1280, height: 800 },
    ...options,
  });
  const page = context.pages()[0] ?? (await context.newPage());
  page.setDefaultTimeout(20_000);
  const faults = [];
  page.on('pageerror', (error) => faults.push(`error in the page: ${error.message}`));
  page.on('console', (message) => {
    if (/Content Security Policy/i.test(message.text())) faults.push(message.text());
  });
  try {
    await test(page, context);
    expect(faults.length === 0, `no fault in the page (${faults.join('; ') || 'none'})`);
  } catch (error) {
    await shot(page, 'failed').catch(() => undefined);
    throw error;
  } finally {
    await context.close();
    await rm(profile, { recursive: true, force: true });
  }
}

export function expect(holds, text) {
  if (!holds) throw new Error(`does not hold: ${text}`);
  console.log(`  ok: ${text}`);
}

export async function shot(page, name) {
  const folder = process.env.SCREENSHOTS;
  if (!folder) return;
  await mkdir(folder, { recursive: true });
  await page.screenshot({ path: path.join(folder, `${name}.png`) });
}

export async function signIn(page, url, token) {
  await page.goto(url);
  await page.getByLabel('Token').fill(token);
  await page.getByRole('button', { name: 'Sign in', exact: true }).click();
  await live(page);
}

export const live = (page) => page.locator('[data-phase="live"]').waitFor();

// What axe finds wrong in the page as it stands now. The source is given to the browser's own debugger, because the
// page's policy lets no other script in.
const axeSource = await readFile(require.resolve('axe-core/axe.min.js'), 'utf8');
export async function accessible(page, what) {
  await page.evaluate(axeSource);
  const found = await page.evaluate(async () => {
    const { violations } = await window.axe.run(document, { resultTypes: ['violations'] });
    return violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.target.join(' ')).join(', ')}`);
  });
  expect(found.length === 0, `axe finds nothing: ${what} (${found.join('; ') || 'nothing'})`);
}

// Counts what a person does: clicks and keys. Tests print it.
export class Person {
  steps = 0;
  async click(locator) {
    this.steps += 1;
    await locator.click();
  }
  async type(locator, text) {
    this.steps += 1;
    await locator.fill(text);
  }
}

export const focused = (page) => page.evaluate(() => document.activeElement?.tagName ?? 'none');

// Asks again and again. (The page's policy forbids the eval by which the browser could wait by itself.)
export async function until(check, what, timeout_ms = 20_000) {
  const end = Date.now() + timeout_ms;
  while (!(await check())) {
    if (Date.now() > end) throw new Error(`waited too long until ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

// What the page shows as soon as its answers are there: it is drawn in several steps, and a first look may come between two of them.
export async function soon(check, text, timeout_ms = 5_000) {
  const end = Date.now() + timeout_ms;
  let holds = await check();
  while (!holds && Date.now() < end) {
    await new Promise((resolve) => setTimeout(resolve, 50));
    holds = await check();
  }
  expect(holds, text);
}

// Names what is wider than the screen.
export async function fits(page, what) {
  const wide = await page.evaluate(() => {
    const most = document.documentElement.clientWidth;
    if (document.documentElement.scrollWidth <= most) return [];
    return [...document.body.querySelectorAll('*')].filter((one) => one.getBoundingClientRect().right > most).map((one) => `${one.tagName}.${one.className}`);
  });
  expect(wide.length === 0, `nothing is wider than the screen: ${what} (${wide.join(', ')})`);
}

export const card = (page, machine) => page.getByRole('article', { name: `Machine ${machine}`, exact: true });

// Every state that the machine's card showed, in order, however short.
export async function recordLine(page, machine) {
  await page.evaluate((label) => {
    const seen = [];
    const look = () => {
      const line = document.querySelector(`article[aria-label="${label}"]`)?.dataset.line;
      if (line && seen.at(-1) !== line) seen.push(line);
    };
    look();
    new MutationObserver(look).observe(document.body, { subtree: true, childList: true, attributes: true });
    window.seenLines = seen;
  }, `Machine ${machine}`);
  return () => page.evaluate(() => window.seenLines);
}

// All of them, or those whose name holds the first argument. What fails does not hide what comes after it.
export async function main(tests) {
  const [only] = process.argv.slice(2);
  const failed = [];
  for (const [name, test] of tests) {
    if (only && !name.includes(only)) continue;
    console.log(name);
    try {
      await test();
    } catch (error) {
      console.error(error);
      failed.push(name);
    }
  }
  if (failed.length > 0) {
    console.error(`failed: ${failed.join(', ')}`);
    process.exit(1);
  }
  console.log('all passed');
}
