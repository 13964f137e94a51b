// A person signs in at the shop's provider: by its own page and password, with the rights that its groups give, and in
// words where it does not work. Tokens and passwords go on while the provider is away.
import { accessible, expect, live, main, shot, signIn, soon, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const kDesk = { viewport: { width: 1280, height: 900 } };
const { url, tokens } = await rig.base();
const { password } = await rig.login();
const button = (page) => page.getByRole('button', { name: "Sign in with the shop's login" });
const session = (page) => page.evaluate(async () => (await fetch('/api/v1/session')).json());

// At the provider: its own page, its own password, and what it asks a person before it names them to us.
async function atProvider(page, name) {
  await page.locator('#username').fill(name);
  await page.locator('#password').fill(password);
  await shot(page, `provider-${name}`);
  await page.getByRole('button', { name: 'OK' }).click();
  await page.getByText('Connection to dripfeed').waitFor();
  await page.getByText('Continue', { exact: true }).click();
}

async function signsIn(page) {
  await page.goto(`${url}/#/alarms`);
  await button(page).waitFor();
  await accessible(page, 'the page of signing in with a provider');
  await shot(page, 'sign-in-provider');
  await button(page).click();
  await atProvider(page, 'olga');
  await live(page);
  expect(!page.url().includes('code='), `nothing of the provider's answer stays in the address (${page.url()})`);
  const who = await session(page);
  expect(who.name === 'olga' && who.role === 'approver' && who.by === 'provider', `she is who the provider says (${JSON.stringify(who)})`);
  await shot(page, 'signed-in-by-provider');
  await page.reload();
  await live(page);
  await soon(async () => (await session(page)).name === 'olga', 'the session stays');
}

const users = async () => (await rig.call('GET', '/users')).body.items.map(({ name }) => name);

async function withoutAGroup(page) {
  await page.goto(url);
  await button(page).click();
  await atProvider(page, 'carl');
  await page.getByText('no group of carl at the provider gives a role here').waitFor();
  await shot(page, 'no-role');
  await soon(async () => !(await users()).includes('carl'), 'no one is added without a role');
  await page.getByRole('button', { name: 'Badge or token' }).waitFor();
}

async function losesAGroup(page) {
  await rig.setGroups('olga', ['dnc']);
  await page.goto(url);
  await button(page).click();
  await atProvider(page, 'olga');
  await live(page);
  await soon(async () => (await session(page)).role === 'operator', 'the groups count at each sign-in');
}

async function isShownToAdministrators(page) {
  await signIn(page, url, tokens.admin);
  await page.goto(`${url}/#/people/users`);
  await page.getByRole('row').filter({ hasText: 'olga' }).getByText(/by http:/).waitFor();
  await shot(page, 'users-of-provider');
}

async function aForgedReturn(page) {
  await page.goto(`${url}/sign-in?code=x&state=y`);
  await page.getByText('this browser did not begin this sign-in').waitFor();
  expect(!page.url().includes('code='), 'nothing of it stays in the address');
}

async function isAway(page) {
  await rig.providerEnds();
  await rig.restart();
  await page.goto(url);
  await button(page).click();
  await page.getByText('provider gives no answer').waitFor();
  await shot(page, 'provider-away');
  await signIn(page, url, tokens.operator);
  await soon(async () => (await session(page)).by === 'token', 'a token goes on');
}

const at = (test) => () => withPage(kDesk, test);
await main([
  ['a person signs in at the provider', at(signsIn)],
  ['a person without a group stays out', at(withoutAGroup)],
  ['groups count at each sign-in', at(losesAGroup)],
  ['an administrator sees whose account it is', at(isShownToAdministrators)],
  ['an answer that no one asked for', at(aForgedReturn)],
  ['the provider is away', at(isAway)],
]);
