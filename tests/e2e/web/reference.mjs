// The reference of the API: all routes and documents of the description, without an outside host and within the strict policy; a link
// opens what it names; fit for a phone.
import { accessible, expect, main, shot, soon, withPage } from './browser.mjs';
import { rig } from './rig.mjs';

const { url } = await rig.base();

async function reference(page) {
  const others = [];
  page.on('request', (request) => request.url().startsWith(url) || others.push(request.url()));
  await page.goto(`${url}/docs/api-reference`);
  await page.locator('details').first().waitFor();
  const described = await (await fetch(`${url}/api/openapi.json`)).json();
  const routes = Object.values(described.paths).flatMap((item) => Object.values(item));
  const schemas = Object.keys(described.components.schemas);
  const ids = await page.locator('details').evaluateAll((all) => all.map((one) => one.id));
  const wanted = [...routes.map((one) => one.operationId), ...schemas.map((name) => `schema-${name}`)];
  expect(wanted.every((id) => ids.includes(id)) && ids.length === wanted.length, `${routes.length} routes and ${schemas.length} documents`);
  await shot(page, 'reference');
  await page.locator('#post_jobs summary').click();
  await page.locator('#post_jobs').getByRole('link', { name: 'NewJob' }).click();
  await page.locator('#schema-NewJob').getByText('"release": 17').waitFor();
  await soon(() => page.locator('#schema-NewJob').evaluate((one) => one.open), 'a link opens the document that it names');
  await shot(page, 'reference-document');
  await page.locator('#post_jobs').scrollIntoViewIfNeeded();
  await shot(page, 'reference-route');
  await page.goto(`${url}/docs/api-reference#schema-Problem`);
  await page.reload();
  await page.locator('#schema-Problem[open]').waitFor();
  await accessible(page, 'the reference');
  await page.setViewportSize({ width: 390, height: 800 });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  expect(wide <= 0, `nothing is wider than a phone (${wide})`);
  await shot(page, 'reference-phone');
  expect(others.length === 0, `no outside host is asked (${others.join(', ') || 'none'})`);
}

await main([['reference', () => withPage({}, reference)]]);
