// The main views of each role, as that role sees them, at a desk, on a tablet in both orientations and on a phone, light and
// dark, of the demo shop: nothing is wider than the screen, and axe finds nothing. DRIPFEED_URL and DRIPFEED_TOKEN (of an
// administrator) as for round.mjs.
import { accessible, expect, fits, live, main, shot, signIn, until, withPage } from './browser.mjs';

const url = process.env.DRIPFEED_URL;
const token = process.env.DRIPFEED_TOKEN;
const kSizes = { desk: [1440, 900], landscape: [1024, 768], portrait: [768, 1024], phone: [390, 844] };

async function call(path, body) {
  const headers = { Authorization: `Bearer ${token}`, 'Content-Type': 'application/json' };
  const answer = await fetch(`${url}/api/v1${path}`, { method: body ? 'POST' : 'GET', headers, body: body && JSON.stringify(body) });
  expect(answer.ok, `${body ? 'POST' : 'GET'} ${path}: ${answer.status}${answer.ok ? '' : ` ${await answer.text()}`}`);
  return answer.json();
}

// Who does the work of a view, by the first word of its name.
const kRoles = { programmer: 'programmer', engineer: 'programmer', approver: 'approver', administrator: 'admin', operator: 'operator', viewer: 'viewer' };
async function tokenOf(role) {
  return (await call('/tokens', { name: `looks ${role}`, role })).token;
}

// What each role works with, by the address of the view.
async function views() {
  const program = (await call('/programs')).items[0].id;
  const release = (await call('/releases')).items[0].id;
  const family = (await call('/families'))[0]?.name ?? (await call('/families')).items[0].name;
  const machines = await call('/machines');
  const machine = (Array.isArray(machines) ? machines : machines.items)[0].name;
  return [
    ['programmer-library', 'library'],
    ['programmer-program', `programs/${program}`],
    ['programmer-path', `programs/${program}?path=1`],
    ['programmer-translation', `programs/${program}?to=${'sinumerik-840d'}&figures=1`],
    ['programmer-checks', `programs/${program}/checks`],
    ['engineer-parts', 'parts'],
    ['engineer-family', `families/${family}`],
    ['engineer-jobs', 'jobs'],
    ['approver-review', 'review'],
    ['approver-release', `review/${release}`],
    ['administrator-users', 'people/users'],
    ['administrator-store', 'people/store'],
    ['administrator-profile', `machines/${machine}/profile`],
    ['operator-floor', ''],
    ['operator-machine', `machines/${machine}`],
    ['operator-orders', 'orders'],
    ['operator-received', 'received'],
    ['operator-alarms', 'alarms'],
    ['viewer-floor', ''],
    ['viewer-machine', `machines/${machine}`],
    ['viewer-program', `programs/${program}`],
    ['viewer-files', `programs/${program}/files`],
    ['viewer-part', 'parts'],
    ['viewer-history', 'history'],
  ];
}

async function walk(page, size, scheme, all) {
  let who = '';
  for (const [name, address] of all) {
    const [role] = name.split('-');
    if (role !== who) {
      who = role;
      await page.context().clearCookies();
      await page.goto('about:blank');
      await signIn(page, url, tokens[kRoles[role]]);
    }
    await page.goto(`${url}/#/${address}`);
    await live(page);
    await page.locator('h1, main h2, article').first().waitFor();
    await until(async () => (await page.locator('[aria-busy="true"], [role="status"]:text-matches("Loading|Rendering|running")').count()) === 0, `${address} is there`).catch(() => undefined);
    await page.waitForTimeout(100);
    await fits(page, `${name}, ${size}, ${scheme}`);
    await accessible(page, `${name}, ${size}, ${scheme}`);
    await shot(page, `looks-${size}-${scheme}-${name}`);
  }
}

const all = await views();
const tokens = {};
for (const role of new Set(Object.values(kRoles))) tokens[role] = await tokenOf(role);
await main(
  Object.entries(kSizes).flatMap(([size, [width, height]]) =>
    ['light', 'dark'].map((colorScheme) => [
      `${size}, ${colorScheme}`,
      () => withPage({ viewport: { width, height }, colorScheme, hasTouch: size !== 'desk' }, (page) => walk(page, size, colorScheme, all)),
    ]),
  ),
);
