// Checks `dripfeed openapi` by the recommended rules of Redocly, all of them, with warnings as faults.
//   node schema/lint.mjs       the description of ../build/dev/dripfeed, or of $DRIPFEED
// Spectral's are run by hand: tests/bench/api_lint.sh.
import { execFileSync } from 'node:child_process';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { createConfig, lintFromString } from '@redocly/openapi-core';

const here = path.dirname(fileURLToPath(import.meta.url));
const binary = process.env.DRIPFEED ?? path.join(here, '..', '..', 'build', 'dev', 'dripfeed');
const config = await createConfig({ extends: ['recommended'] });
const lint = (source) => lintFromString({ source, absoluteRef: 'openapi.json', config });

const described = execFileSync(binary, ['openapi'], { encoding: 'utf8', maxBuffer: 1 << 26 });
const found = await lint(described);
for (const { ruleId, severity, message, location } of found) console.error(`${severity} ${ruleId} ${location[0]?.pointer ?? ''}: ${message}`);

// The check can fail: of a document that says less, the rules say so.
const broken = JSON.parse(described);
delete broken.info.license;
broken.paths['/healthz'].get.responses = { 200: { description: 'good' } };
const rules = new Set((await lint(JSON.stringify(broken))).map(({ ruleId }) => ruleId));
for (const rule of ['info-license', 'operation-4xx-response']) {
  if (rules.has(rule)) continue;
  console.error(`a document that breaks ${rule} passes`);
  found.push(rule);
}
process.exit(found.length === 0 ? 0 : 1);
