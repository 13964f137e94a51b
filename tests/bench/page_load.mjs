// What the page costs and how quick it is while a whole shop feeds: many machines, five reports a second each, six tabs
// of one browser.  python3 tests/e2e/page.py build/dev/dripfeed ../../bench/page_load.mjs [machines]
// Prints the load of the page's main thread, its frames a second with a processor four times slower, how long a Stop
// takes from the click to the server's answer, what the server pays, and whether memory grows.
import { expect, signIn, until, withPage } from '../e2e/web/browser.mjs';
import { rig } from '../e2e/web/rig.mjs';

const kMachines = Number(process.argv[2] ?? 100);
const kTabs = 6;
const kWatchS = 10;
const { url, tokens } = await rig.base();
const names = Array.from({ length: kMachines }, (_, i) => `m${String(i + 1).padStart(3, '0')}`);

const sleep = (seconds) => new Promise((resolve) => setTimeout(resolve, seconds * 1000));
const quantile = (values, share) => [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(values.length * share))];

async function startAll() {
  const jobs = new Map();
  for (const name of names) {
    const [job] = await rig.machine(name, { blocks: 1500, baud: 2400 });
    const armed = await rig.call('POST', `/jobs/${job}/arm`, {}, 'operator');
    expect(armed.status === 200, `${name} is armed`);
    jobs.set(name, job);
  }
  for (const name of names) await rig.say(name, 'dc1');
  return jobs;
}

async function metrics(cdp) {
  const { metrics: all } = await cdp.send('Performance.getMetrics');
  return Object.fromEntries(all.map(({ name, value }) => [name, value]));
}
const metric = async (cdp, name) => (await metrics(cdp))[name];

async function mainThread(cdp, what) {
  const before = await metrics(cdp);
  const server = await rig.cpu_s();
  await sleep(kWatchS);
  const after = await metrics(cdp);
  const share = (name) => `${(((after[name] - before[name]) / kWatchS) * 100).toFixed(1)} %`;
  console.log(
    `${what}: main thread ${share('TaskDuration')} (script ${share('ScriptDuration')}, style ${share('RecalcStyleDuration')}, layout ${share('LayoutDuration')}), ` +
      `server ${((((await rig.cpu_s()) - server) / kWatchS) * 100).toFixed(1)} % of a core`,
  );
}

const framesIn = (page, seconds) =>
  page.evaluate(
    (ms) =>
      new Promise((resolve) => {
        let frames = 0;
        const end = performance.now() + ms;
        const count = (now) => {
          frames += 1;
          if (now < end) requestAnimationFrame(count);
          else resolve(frames);
        };
        requestAnimationFrame(count);
      }),
    seconds * 1000,
  );

async function stopAll(page, jobs) {
  const took = [];
  page.on('requestfinished', (request) => {
    if (!request.url().endsWith('/stop')) return;
    const { requestStart, responseEnd } = request.timing();
    if (requestStart >= 0) took.push(responseEnd);
  });
  const handled = [];
  for (const [name, job] of jobs) {
    const place = page.getByRole('article', { name: `Machine ${name}`, exact: true });
    const button = place.getByRole('button', { name: `Stop at block end, job ${job}` });
    handled.push(
      await button.evaluate(async (one) => {
        const begin = performance.now();
        one.click();
        while (!/Stopping/.test(one.textContent) && one.getAttribute('aria-disabled') !== 'true') await new Promise((next) => requestAnimationFrame(next));
        return performance.now() - begin;
      }),
    );
    await sleep(0.05);
  }
  await until(() => took.length >= jobs.size, 'every stop is answered', 30_000);
  const show = (values) => `median ${quantile(values, 0.5).toFixed(1)}, p99 ${quantile(values, 0.99).toFixed(1)}, worst ${Math.max(...values).toFixed(1)} ms`;
  console.log(`${jobs.size} stops, click to the server's answer: ${show(took)}; click to "Stopping…" on the screen: ${show(handled)}`);
}

await withPage({ viewport: { width: 1280, height: 800 } }, async (page, context) => {
  const jobs = await startAll();
  await signIn(page, url, tokens.operator);
  const streams = [];
  context.on('request', (request) => request.url().endsWith('/events') && streams.push(request));
  for (let tab = 1; tab < kTabs; ++tab) await (await context.newPage()).goto(url);
  await page.bringToFront();
  await page.getByRole('article').nth(kMachines - 1).waitFor();
  expect(streams.length === 0, `no tab opened a stream of its own (${streams.length})`);
  const cdp = await context.newCDPSession(page);
  // The thread's own time: what others do on this machine does not count.
  await cdp.send('Performance.setTimeDomain', { timeDomain: 'threadTicks' });
  await cdp.send('Performance.enable');
  await mainThread(cdp, `${kMachines} cards, ${kTabs} tabs`);
  console.log(`frames a second: ${(await framesIn(page, 5)) / 5}`);
  await cdp.send('Emulation.setCPUThrottlingRate', { rate: 4 });
  console.log(`frames a second, processor four times slower: ${(await framesIn(page, 5)) / 5}`);
  await cdp.send('Emulation.setCPUThrottlingRate', { rate: 1 });
  await cdp.send('HeapProfiler.collectGarbage');
  const before = await metric(cdp, 'JSHeapUsedSize');
  await sleep(20);
  await cdp.send('HeapProfiler.collectGarbage');
  console.log(`heap ${(before / 1e6).toFixed(1)} MB, after 20 s ${((await metric(cdp, 'JSHeapUsedSize')) / 1e6).toFixed(1)} MB`);
  await stopAll(page, jobs);
});
