// What a page can do to a feed: nothing. A control notes the pauses between the characters that arrive: with no page at
// all, beside six tabs that watch, beside six whose network stalls, and
// beside a page that asks as fast as it can with forty requests at once, orders among them.
//   python3 tests/e2e/page.py build/dev/dripfeed ../../bench/page_hostile.mjs
import { expect, signIn, withPage } from '../e2e/web/browser.mjs';
import { rig } from '../e2e/web/rig.mjs';

const kWatchS = 15;
const { url, tokens } = await rig.base();
const sleep = (seconds) => new Promise((resolve) => setTimeout(resolve, seconds * 1000));

async function measure(what) {
  await rig.watchGaps('fed');
  const before = await rig.got('fed');
  await sleep(kWatchS);
  const bytes_s = ((await rig.got('fed')) - before) / kWatchS;
  const gaps = (await rig.gaps('fed')).sort((a, b) => a - b).map((one) => one * 1000);
  const at = (share) => gaps[Math.min(gaps.length - 1, Math.floor(gaps.length * share))].toFixed(1);
  console.log(`${what}: ${bytes_s.toFixed(0)} bytes a second in ${gaps.length} arrivals, pause median ${at(0.5)}, p99 ${at(0.99)}, worst ${gaps.at(-1).toFixed(1)} ms`);
}

const [job] = await rig.machine('fed', { blocks: 6500, baud: 9600 });
await rig.machine('other', { blocks: 50, jobs: 3 });
const armed = await rig.call('POST', `/jobs/${job}/arm`, {}, 'operator');
expect(armed.status === 200, 'armed');
await rig.say('fed', 'dc1');
await rig.waitLine('fed', 'feeding');
await sleep(2);
await measure('no page');
await withPage({}, async (page, context) => {
  await signIn(page, url, tokens.operator);
  for (let tab = 1; tab < 6; ++tab) await (await context.newPage()).goto(url);
  await measure('six tabs');
  for (const one of context.pages()) {
    const cdp = await context.newCDPSession(one);
    await cdp.send('Network.enable');
    await cdp.send('Network.emulateNetworkConditions', { offline: false, latency: 2000, downloadThroughput: 500, uploadThroughput: 500 });
  }
  await measure('six tabs whose network stalls');
});
await withPage({}, async (page) => {
  await signIn(page, url, tokens.operator);
  await page.evaluate(() => {
    const paths = ['/api/v1/machines', '/api/v1/jobs?limit=200', '/api/v1/alarms', '/api/v1/programs/1/lines?revision=1&from=1&count=200', '/api/v1/events'];
    const again = async (n) => {
      for (let i = n; ; ++i) {
        const order = i % 7 === 0;
        const init = order ? { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: '{"before":null}' } : {};
        const abort = new AbortController();
        const timer = setTimeout(() => abort.abort(), 300);
        await fetch(order ? '/api/v1/jobs/2/move' : paths[i % paths.length], { ...init, signal: abort.signal }).then((answer) => answer.text()).catch(() => undefined);
        clearTimeout(timer);
      }
    };
    for (let n = 0; n < 40; ++n) void again(n);
  });
  await measure('a page that asks as fast as it can');
});
await measure('the page is closed');
