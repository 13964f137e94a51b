// What a browser test asks of the rig that started it (tests/e2e/page.py): a person at a control, an administrator.
const url = process.env.DRIPFEED_RIG;
if (!url) {
  console.error('run this by tests/e2e/page.py');
  process.exit(2);
}

async function ask(word, values, named = {}) {
  const answer = await fetch(url, { method: 'POST', body: JSON.stringify({ do: word, with: values, named }) });
  const { result, error } = await answer.json();
  if (error) throw new Error(`rig: ${word}: ${error}`);
  return result;
}

export const rig = {
  base: () => ask('base', []),
  do: (word) => ask(word, []), // a word of a test's own rig
  machine: (name, options = {}) => ask('machine', [name], options),
  plc: (name, options = {}) => ask('plc', [name], options),
  say: (machine, code) => ask('say', [machine, code]),
  punch: (machine, text) => ask('punch', [machine, text]),
  got: (machine) => ask('got', [machine]),
  bridge: (machine, on = true) => ask('bridge', [machine, on]),
  holdOften: (machine, times, pause_s = 0.05) => ask('hold_often', [machine, times, pause_s]),
  tear: (machine) => ask('tear', [machine]),
  waitLine: (machine, ...states) => ask('wait_line', [machine, ...states]),
  job: (id) => ask('job', [id]),
  queue: (machine) => ask('queue', [machine]),
  call: (method, path, body = null, role = 'admin', headers = null) => ask('call', [method, path, body, role, headers]),
  text: (path) => ask('text', [path]),
  restart: (hard = false) => ask('restart', [hard]),
  killServer: () => ask('kill_server', []),
  startServer: () => ask('start_server', []),
  token: (role, name) => ask('token', [role, name]),
  revoke: (name) => ask('revoke', [name]),
  watchGaps: (machine) => ask('watch_gaps', [machine]),
  gaps: (machine) => ask('gaps', [machine]),
  login: () => ask('login', []),
  setGroups: (name, groups) => ask('set_groups', [name, groups]),
  providerEnds: () => ask('provider_ends', []),
  cpu_s: () => ask('cpu_s', []),
};
