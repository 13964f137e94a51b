// Writes src/api/schema.d.ts from `dripfeed openapi`.
//   npm run schema                      the types of ../build/dev/dripfeed, or of $DRIPFEED
//   npm run schema -- --check           fails where the file is not what the binary describes
import { execFileSync } from 'node:child_process';
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import openapiTypescript, { astToString } from 'openapi-typescript';

const here = path.dirname(fileURLToPath(import.meta.url));
const file = path.join(here, '..', 'src', 'api', 'schema.d.ts');
const binary = process.env.DRIPFEED ?? path.join(here, '..', '..', 'build', 'dev', 'dripfeed');
const kHead = '// Written by `npm run schema` from `dripfeed openapi`: do not change it by hand.\n';

const described = JSON.parse(execFileSync(binary, ['openapi'], { encoding: 'utf8', maxBuffer: 1 << 26 }));
const written = kHead + astToString(await openapiTypescript(described));

if (!process.argv.includes('--check')) {
  await writeFile(file, written);
} else if ((await readFile(file, 'utf8')) !== written) {
  console.error('src/api/schema.d.ts is not what the binary describes: run npm run schema in web/');
  process.exit(1);
}
