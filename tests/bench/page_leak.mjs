// Whether the page's memory grows while it is open for long: 100 machines that feed, five reports a second each. Once a
// minute a machine is opened and left again, as people do. The heap is read after a forced collection at the start, in
// the middle and at the end. Ends with 1 where it grew from the middle to the end.
//   PAGE_TIMEOUT_S=5000 python3 tests/e2e/page.py build/dev/dripfeed ../../bench/page_leak.mjs [minutes] [machines]
import { expect, signIn, withPage } from '../e2e/web/browser.mjs';
import { rig } from '../e2e/web/rig.mjs';

const kMinutes = Number(process.argv[2] ?? 60);
const kMachines = Number(process.argv[3] ?? 100);
const kBaud = 300; // slow enough that a program lasts, and quick enough that every report has news
const kBytesOfBlock = 14; // at the least
const kMostGrowth = 1.05;
const kMostGrowth_MB = 1;
const { url, tokens } = await rig.base();
const sleep = (seconds) => new Promise((resolve) => setTimeout(resolve, seconds * 1000));

async function startAll() {
  const blocks = Math.ceil(((kMinutes + 10) * 60 * (kBaud / 10)) / kBytesOfBlock);
  for (let i = 1; i <= kMachines; ++i) {
    const name = `m${String(i).padStart(3, '0')}`;
    const [job] = await rig.machine(name, { blocks, baud: kBaud });
    const armed = await rig.call('POST', `/jobs/${job}/arm`, {}, 'operator');
    if (armed.status !== 200) throw new Error(`${name} is not armed: ${JSON.stringify(armed)}`);
    await rig.say(name, 'dc1');
  }
}

async function heap(cdp, what) {
  for (let i = 0; i < 3; ++i) {
    await cdp.send('HeapProfiler.collectGarbage');
    await sleep(0.3);
  }
  const { metrics } = await cdp.send('Performance.getMetrics');
  const of = Object.fromEntries(metrics.map(({ name, value }) => [name, value]));
  const mb = of.JSHeapUsedSize / 1e6;
  console.log(`${what}: heap ${mb.toFixed(2)} MB, ${of.Nodes} nodes, ${of.JSEventListeners} listeners, ${of.Documents} documents`);
  return { mb, nodes: of.Nodes, listeners: of.JSEventListeners };
}

// So many minutes of looking, with a visit of a machine in each.
async function look(page, minutes) {
  const end = Date.now() + minutes * 60_000;
  for (let visit = 0; Date.now() < end; ++visit) {
    const name = `m${String(1 + (visit % kMachines)).padStart(3, '0')}`;
    await page.goto(`${url}/#/machines/${name}`);
    await page.getByRole('heading', { level: 1, name }).waitFor();
    await sleep(3);
    await page.goto(`${url}/#/floor`);
    await page.getByRole('article').nth(kMachines - 1).waitFor();
    await sleep(Math.max(0, Math.min(57, (end - Date.now()) / 1000)));
  }
}

await startAll();
await withPage({ viewport: { width: 1280, height: 800 } }, async (page, context) => {
  await signIn(page, url, tokens.operator);
  await page.getByRole('article').nth(kMachines - 1).waitFor();
  const cdp = await context.newCDPSession(page);
  await cdp.send('Performance.enable');
  await look(page, 1); // what is made once is there
  const begun = Date.now();
  await heap(cdp, 'start');
  await look(page, kMinutes / 2);
  const middle = await heap(cdp, `after ${((Date.now() - begun) / 60_000).toFixed(1)} min`);
  await look(page, kMinutes / 2);
  const end = await heap(cdp, `after ${((Date.now() - begun) / 60_000).toFixed(1)} min`);
  const { body } = await rig.call('GET', '/machines/m001');
  expect(body.status.line === 'feeding', `the machines feed to the end: ${body.status.line}, ${body.status.handed} of ${body.status.total} bytes`);
  expect(end.mb < middle.mb * kMostGrowth + kMostGrowth_MB, `the heap does not grow: ${middle.mb.toFixed(2)} to ${end.mb.toFixed(2)} MB`);
  expect(end.nodes <= middle.nodes * kMostGrowth + 100, `nor do the nodes: ${middle.nodes} to ${end.nodes}`);
});
