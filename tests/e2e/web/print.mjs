// A job with its ledger, and a verdict, on paper: without navigation and orders, in light colours, with nothing cut off.
import { writeFile } from 'node:fs/promises';
import path from 'node:path';
import { expect, main, shot, signIn, soon, until, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDark = { viewport: { width: 1280, height: 900 }, colorScheme: 'dark' };
const kPaper = { width: 718, height: 1000 }; // A4 within its margins, at 96 points an inch
const { url, tokens } = await rig.base();

async function onPaper(page, name) {
  await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  await page.setViewportSize(kPaper);
  const found = await page.evaluate(() => {
    const isSeen = (one) => !one.closest('.unseen') && one.checkVisibility() && one.getClientRects().length > 0;
    const all = [...document.querySelectorAll('body *')].filter(isSeen);
    const cut = (one) => {
      const { overflowX, overflowY } = getComputedStyle(one);
      return (overflowX !== 'visible' && one.scrollWidth > one.clientWidth + 1) || (overflowY !== 'visible' && one.scrollHeight > one.clientHeight + 1);
    };
    const name = (one) => `${one.tagName.toLowerCase()}.${one.className}`;
    return {
      orders: all.filter((one) => one.matches('nav, button, input, select, header.top, dialog')).map(name),
      cut: all.filter((one) => !(one instanceof SVGElement) && cut(one)).map(name),
      wide: document.documentElement.scrollWidth - document.documentElement.clientWidth,
      ink: getComputedStyle(document.body).color,
      scheme: getComputedStyle(document.documentElement).colorScheme,
      head: document.querySelector('.print-head')?.textContent ?? '',
    };
  });
  expect(found.orders.length === 0, `no navigation and no order on paper: ${name} (${found.orders.join(', ') || 'none'})`);
  expect(found.cut.length === 0 && found.wide <= 0, `nothing is cut off: ${name} (${found.cut.join(', ') || 'nothing'}, ${found.wide})`);
  expect(found.ink === 'rgb(22, 32, 42)' && found.scheme === 'light', `dark ink on white, though the screen is dark: ${found.ink}, ${found.scheme}`);
  expect(/printed by the approver at \d{4}-\d\d-\d\d/.test(found.head), `who printed it, and when: ${found.head}`);
  await shot(page, `print-${name}`);
  const pdf = await page.pdf({ format: 'A4', preferCSSPageSize: true });
  expect(pdf.length > 5000 && pdf.subarray(0, 5).toString() === '%PDF-', `it prints: ${pdf.length} bytes`);
  if (process.env.SCREENSHOTS) await writeFile(path.join(process.env.SCREENSHOTS, `print-${name}.pdf`), pdf);
  await page.emulateMedia({ media: 'screen', colorScheme: 'dark' });
  await page.setViewportSize(kDark.viewport);
}

async function jobAndLedger(page) {
  const [job] = await rig.machine('paper', { blocks: 400 });
  await rig.call('POST', `/jobs/${job}/arm`, {}, 'operator');
  await rig.say('paper', 'dc1');
  await rig.waitLine('paper', 'feeding');
  await rig.holdOften('paper', 20);
  await until(async () => (await rig.job(job)).state === 'done', 'the job is done', 60_000);
  await signIn(page, url, tokens.approver);
  await page.goto(`${url}/#/jobs/${job}`);
  await page.getByRole('table', { name: 'Ledger' }).getByRole('row').nth(20).waitFor();
  await onPaper(page, 'job');
  await soon(async () => await page.getByText((await rig.job(job)).sha256).count().then((n) => n > 0), 'the whole hash is there');
}

async function verdict(page) {
  await rig.machine('judged', { jobs: 0 });
  const text = '%\nO0099\n(A PROGRAM WITH FINDINGS)\nG0X1000.Z5.\nG1X10.Z-5.F0.2\nG999\nM30\n%\n';
  const program = await rig.call('POST', '/programs', { name: 'O0099', dialect: 'fanuc', text });
  const check = await rig.call('POST', '/checks', { program: program.body.id, machine: 'judged' });
  await signIn(page, url, tokens.approver);
  await page.goto(`${url}/#/programs/${program.body.id}/checks?check=${check.body.id}`);
  await page.locator('.fault').first().waitFor();
  await onPaper(page, 'verdict');
}

await main([
  ['job and ledger', () => withPage(kDark, jobAndLedger)],
  ['verdict', () => withPage(kDark, verdict)],
]);
