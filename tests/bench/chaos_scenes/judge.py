"""The judge of the chaos test. Each line has a permit: what may come over it now, by what people and the control did. The control asks for every piece that
arrives, so no byte escapes. What breaks a rule is kept with the line, the scene and the server run."""

import threading

RULES = {1: "no motion started or resumed by itself", 2: "no torn block completed", 3: "no claim beyond what is known", 4: "no feed delayed but by its own line"}
WORST_MS, P99_MS = 200, 50
EOB = b"\n\x8a\x8d\r"


class Permit:
    """Of one line: `silent`, `armed` and `torn` let nothing through, `sending` and `answer` everything, `stopping` the rest of a block."""

    CLOSED = {"silent": 1, "armed": 1, "torn": 2}

    def __init__(self, judge, line):
        self.judge, self.line = judge, line
        self.state, self.why = "silent", "nothing was asked for"
        self.blocks_left = 0
        self.complained = False

    def set(self, state, why="", blocks_left=0):
        with self.line.loop.lock:
            self.line.control.poll()  # what arrived by now came under the permit before, however late it is read
            self.state, self.why, self.blocks_left, self.complained = state, why, blocks_left, False

    def __call__(self, control, data):
        rule, sentence = 0, ""
        if self.state in self.CLOSED:
            rule, sentence = self.CLOSED[self.state], f"{bytes(b & 127 for b in data[:24])!r} came while {self.state}: {self.why}"
        elif self.state == "stopping":
            for byte in data:
                if self.blocks_left <= 0:
                    rule, sentence = 1, f"more than the rest of a block came after a person's stop: {self.why}"
                self.blocks_left -= byte in EOB
        if rule and not self.complained:
            self.complained = True
            self.judge.violation(rule, self.line.name, self.line.scene, sentence)


class Judge:
    def __init__(self, seed):
        self.seed = seed
        self.run = 0
        self.lock = threading.Lock()
        self.violations = []
        self.delays_ms = []
        self.scenes = {}
        self.refusals = {}

    def violation(self, rule, line, scene, sentence):
        with self.lock:
            self.violations.append((rule, self.run, line, scene, sentence))
        print(f"  VIOLATION of rule {rule} ({RULES[rule]}): run {self.run}, {line}, {scene}: {sentence}", flush=True)

    def scene(self, name, outcome):
        with self.lock:
            counts = self.scenes.setdefault(name, {})
            counts[outcome] = counts.get(outcome, 0) + 1

    def refused(self, reason):
        with self.lock:
            self.refusals[reason] = self.refusals.get(reason, 0) + 1

    def count(self):
        """Scenes that were played; one that was refused at its start is none."""
        with self.lock:
            return sum(n for counts in self.scenes.values() for outcome, n in counts.items() if outcome != "refused")

    def delays(self, line, scene, delays_s):
        """Of one transfer whose line held nothing."""
        delays_ms = [delay * 1000 for delay in delays_s]
        with self.lock:
            self.delays_ms += delays_ms
        worst = max(delays_ms, default=0)
        if worst > WORST_MS:
            self.violation(4, line, scene, f"a feed waited {worst:.0f} ms")

    def interval(self, line, scene, count, interval, slack=0):
        """`count` bytes arrived; `slack` more may have, unseen."""
        if not interval["low"] <= count + slack or not count <= interval["high"]:
            self.violation(3, line, scene, f"{count} bytes arrived (at most {slack} more unseen), the ledger says {interval['low']} to {interval['high']}")

    def report(self):
        """Prints the tables; whether all held."""
        print(f"\n{'scene':24} {'count':>6}  outcomes")
        for name, counts in sorted(self.scenes.items()):
            print(f"{name:24} {sum(counts.values()):6}  " + ", ".join(f"{n} {outcome}" for outcome, n in sorted(counts.items())))
        delays = sorted(self.delays_ms)
        held = not self.violations
        if delays:
            p50, p99, worst = delays[len(delays) // 2], delays[int(len(delays) * 0.99)], delays[-1]
            print(f"\ndelays of feeds beyond their own line: {len(delays)} arrivals, median {p50:.1f} ms, p99 {p99:.1f} ms (limit {P99_MS}), "
                  f"worst {worst:.1f} ms (limit {WORST_MS})")
            if p99 > P99_MS:
                held = False
        for reason, n in sorted(self.refusals.items(), key=lambda one: -one[1])[:12]:
            print(f"refused {n} times: {reason}")
        print(f"\n{self.count()} scenes, {self.run} runs of the server, seed {self.seed}")
        for rule, text in RULES.items():
            broken = [one for one in self.violations if one[0] == rule]
            print(f"rule {rule}, {text}: {len(broken)} violations")
            by_scene = {}
            for _, run, line, scene, sentence in broken:
                by_scene.setdefault(scene, []).append((run, line, sentence))
            for scene, ones in by_scene.items():
                run, line, sentence = ones[0]
                print(f"    {len(ones)} in {scene}, first in run {run} on {line}: {sentence}")
        return held
