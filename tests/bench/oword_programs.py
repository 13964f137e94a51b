"""Seeded programs in LinuxCNC's language: parameters, expressions, every o-word structure, subprograms with arguments and values that they give back,
and moves that depend on all of it. What would be an alarm (a root of a negative number, a division by nothing) is kept out of the expressions."""

import random

LINE_AT_MOST = 240  # rs274 reads 255 characters
UNARY = ("ABS[{}]", "SIN[{}]", "COS[{}]", "FIX[{}+0.0037]", "FUP[{}+0.0037]", "ROUND[{}+0.0037]", "SQRT[ABS[{}]]", "LN[1+ABS[{}]]", "EXP[SIN[{}]]", "ASIN[SIN[{}]]",
         "ACOS[COS[{}]]", "[-{}]")
BINARY = ("[{}+{}]", "[{}-{}]", "[{}*{}]", "[{}/[1+ABS[{}]]]", "[{} MOD [1+ABS[{}]]]", "ATAN[{}]/[1+ABS[{}]]", "[[1+ABS[{}]]**[COS[{}]]]")
CONDITIONS = ("EQ", "NE", "GT", "GE", "LT", "LE")
LOGIC = ("AND", "OR", "XOR")


class Scope:
    """The parameters that are set in one program or subprogram."""

    def __init__(self, names):
        self.names = names


class OWordProgram:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.lines, self.next_o = [], 100
        self.globals = ["#<_one>", "#<_two>", "#101", "#102"]
        self.subs = []  # (o-word, arguments)
        self.loops = []

    def text(self):
        self.put("G21 G90 G17 G40 G80 G94 G64 F400")
        for name in self.globals:
            self.put(f"{name}={self.constant()}")
        for _ in range(self.random.randint(1, 3)):
            self.subprogram()
        scope = Scope(self.globals + ["#<a>", "#<long name>", "#5"])
        for name in scope.names[len(self.globals):]:
            self.put(f"{name}=[{self.constant()}]")
        for _ in range(self.random.randint(8, 16)):
            self.statement(scope, 0)
        return "\n".join(self.lines) + "\nM2\n"

    # --- pieces

    def put(self, line):
        self.lines.append(line)

    def pick(self, what):
        return self.random.choice(what)

    def constant(self):
        return self.pick((f"{self.random.uniform(-30, 30):.3f}", str(self.random.randint(-9, 9)), f"{self.random.randint(1, 60) * 0.25}"))

    def expression(self, scope, depth=3):
        kind = self.random.random()
        if depth == 0 or kind < 0.2:
            return self.pick(scope.names) if self.random.random() < 0.65 else f"[{self.constant()}]"
        if kind < 0.5:
            return self.pick(UNARY).format(self.expression(scope, depth - 1))
        if kind < 0.9:
            return self.pick(BINARY).format(self.expression(scope, depth - 1), self.expression(scope, depth - 1))
        # Without brackets between: the ranks decide.
        parts = [self.expression(scope, 1) for _ in range(3)]
        return f"[{parts[0]}{self.pick('+-*')}{parts[1]}{self.pick('+-*')}{parts[2]}]"

    def bounded(self, scope):
        """An expression whose value stays small and is read the same whatever the last bits are."""
        while True:
            line = f"[ROUND[[[{self.expression(scope)}]*100+0.0037] MOD 5000]/100]"
            if len(line) < LINE_AT_MOST - 60:
                return line

    def condition(self, scope):
        one = f"{self.bounded_short(scope)} {self.pick(CONDITIONS)} {self.constant()}"
        if self.random.random() < 0.7:
            return f"[{one}]"
        return f"[[{one}] {self.pick(LOGIC)} [{self.bounded_short(scope)} {self.pick(CONDITIONS)} {self.constant()}]]"

    def bounded_short(self, scope):
        # Not on the edge of a comparison.
        return f"[ROUND[{self.pick(scope.names)}*10]/10+0.03]"

    def o(self):
        self.next_o += 1
        return f"o{self.next_o}" if self.random.random() < 0.7 else f"o<loop{self.next_o}>"

    # --- statements

    def statement(self, scope, depth):
        kinds = [self.assign, self.assign, self.move, self.move, self.show, self.several]
        if depth < 3:
            kinds += [self.if_else, self.while_loop, self.do_loop, self.repeat]
        if self.subs:
            kinds += [self.call]
        if self.loops:
            kinds += [self.leave]
        self.pick(kinds)(scope, depth)

    def body(self, scope, depth):
        for _ in range(self.random.randint(1, 3)):
            self.statement(scope, depth + 1)

    def assign(self, scope, _):
        self.put(f"{self.pick(scope.names)} = {self.bounded(scope)}")

    def several(self, scope, _):
        """Assignments in the same block as a move: all values are read first."""
        one, other = self.random.sample(scope.names, 2)
        self.put(f"G0 X[{one}] {one}=[{other}] Y[{other}] {other}=[{one}+0.5]")

    def move(self, scope, _):
        axes = self.random.sample("XYZ", self.random.randint(1, 3))
        words = " ".join(f"{axis}{self.bounded(scope)}" for axis in axes)
        line = f"{self.pick(('G0', 'G1', 'G1'))} {words}"
        if len(line) < LINE_AT_MOST:
            self.put(line)

    def show(self, scope, _):
        self.put(f"(DEBUG, a {self.pick(scope.names)} b {self.pick(scope.names)})")

    def if_else(self, scope, depth):
        o = self.o()
        self.put(f"{o} if {self.condition(scope)}")
        self.body(scope, depth)
        for _ in range(self.random.randint(0, 2)):
            self.put(f"{o} elseif {self.condition(scope)}")
            self.body(scope, depth)
        if self.random.random() < 0.6:
            self.put(f"{o} else")
            self.body(scope, depth)
        self.put(f"{o} endif")

    def counted(self):
        """An o-word with a counter of its own, so that the loop ends whatever is in it."""
        o = self.o()
        return o, f"#<count{self.next_o}>"

    def while_loop(self, scope, depth):
        o, counter = self.counted()
        self.put(f"{counter}=0")
        self.put(f"{o} while [[{counter} LT {self.random.randint(1, 3)}] AND {self.condition(scope)}]")
        self.put(f"{counter}=[{counter}+1]")
        self.loops.append((o, ("continue",)))
        self.body(scope, depth)
        self.loops.pop()
        self.put(f"{o} endwhile")

    def do_loop(self, scope, depth):
        o, counter = self.counted()
        self.put(f"{counter}=0")
        self.put(f"{o} do")
        self.put(f"{counter}=[{counter}+1]")
        # LinuxCNC: after a continue in a do the loops around it do not end, after a break of a while the next do makes one pass. Both are left out.
        self.loops.append((o, ("break",)))
        self.body(scope, depth)
        self.loops.pop()
        self.put(f"{o} while [{counter} LE {self.random.randint(0, 2)}]")

    def repeat(self, scope, depth):
        o = self.o()
        self.put(f"{o} repeat [{self.random.randint(0, 3)}]")
        loops, self.loops = self.loops, []  # LinuxCNC leaves no repeat before its end
        self.body(scope, depth)
        self.loops = loops
        self.put(f"{o} endrepeat")

    def leave(self, scope, _):
        o = self.o()
        self.put(f"{o} if {self.condition(scope)}")
        loop, branches = self.loops[-1]
        self.put(f"{loop} {self.pick(branches)}")
        self.put(f"{o} endif")

    def subprogram(self):
        o = self.o()
        count = self.random.randint(0, 4)
        scope = Scope(self.globals + [f"#{n + 1}" for n in range(max(count, 1))] + ["#<a>"])
        self.put(f"{o} sub")
        self.put(f"#<a>={self.constant()}")
        loops, self.loops = self.loops, []
        for _ in range(self.random.randint(1, 4)):
            self.statement(scope, 1)
        # LinuxCNC reads these when it passes over the definition, where the subprogram's own names are not set.
        scope = Scope(scope.names[:-1])
        if self.random.random() < 0.5:
            inner = self.o()
            self.put(f"{inner} if {self.condition(scope)}")
            self.put(f"{o} return [{self.bounded(scope)}]")
            self.put(f"{inner} endif")
        self.loops = loops
        self.put(f"{o} endsub" + (f" [{self.bounded(scope)}]" if self.random.random() < 0.6 else ""))
        self.subs.append((o, count))

    def call(self, scope, _):
        o, count = self.pick(self.subs)
        arguments = " ".join(f"[{self.pick(scope.names)}+{index}]" for index in range(count))
        self.put(f"{o} call {arguments}".rstrip())
        self.put(f"{self.pick(scope.names)}=[#<_value>+#<_value_returned>]")
