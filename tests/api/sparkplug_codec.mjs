// Sparkplug payloads by the codec of Eclipse Tahu, which is not ours. Standard input has lines "TOPIC HEX", and each is
// answered by a line of JSON; null for what is no payload. With the argument `write` the input is one JSON payload, and the answer is its bytes as hex.
import { createRequire } from 'node:module';
import { createInterface } from 'node:readline';

const codec = createRequire(new URL('../../web/package.json', import.meta.url))('sparkplug-payload').get('spBv1.0');
const plain = (_, value) => (value !== null && typeof value === 'object' && 'low' in value ? value.high * 4294967296 + (value.low >>> 0) : value);
const read = (hex) => {
  try {
    return codec.decodePayload(Buffer.from(hex, 'hex'));
  } catch {
    return null;
  }
};

for await (const line of createInterface({ input: process.stdin })) {
  if (process.argv[2] === 'write') {
    console.log(Buffer.from(codec.encodePayload(JSON.parse(line))).toString('hex'));
  } else {
    const [hex, topic] = [line.slice(line.lastIndexOf(' ') + 1), line.slice(0, line.lastIndexOf(' '))];
    console.log(JSON.stringify({ topic, payload: read(hex) }, plain));
  }
}
