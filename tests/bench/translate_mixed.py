"""Programs for translate_moves.py of what translations lost most easily: corners, chains of increments in inch and mm, drilling cycles with all of their parameters, frames, and writes to outputs, offsets and variables. Maker.written holds the numbers that were written for others to read: each of them must stand in a translation."""

import random


class Mixed:
    kind = "mill"

    def __init__(self, seed):
        self.chance = random.Random(seed)
        self.lines, self.written = [], []
        self.inch = self.chance.random() < 0.4

    def put(self, *lines):
        self.lines += lines

    def one_of(self, *choices):
        return self.chance.choice(choices)

    def maybe(self, text, share=0.5):
        return text if self.chance.random() < share else ""

    def length(self, low, high):
        """In the program's unit, given in mm."""
        return f"{self.chance.uniform(low, high) / (25.4 if self.inch else 1.0):.{4 if self.inch else 3}f}"

    def unique(self):
        """A number that stands nowhere else."""
        self.written.append(f"{self.chance.randint(100, 999)}.{self.chance.randint(10, 99)}{self.chance.randint(1, 9)}")
        return self.written[-1]

    def contour(self):
        """Legs of at least 20 mm, with corners of up to 4 mm."""
        x, y = self.chance.uniform(-40, 40), self.chance.uniform(-40, 40)
        self.put("G90 " + self.fast + f" X{self.scaled(x)} Y{self.scaled(y)}")
        feed = " F" + self.one_of("100.", "250.", "80.")
        begin = self.modal_corner()
        dx, dy = 0, 0
        for n in range(self.chance.randint(2, 6)):
            legs = ((25, 0), (0, 25), (-25, 0), (0, -25), (22, 21), (21, -22))
            dx, dy = self.one_of(*(leg for leg in legs if n == 0 or (dx * leg[1] != dy * leg[0] and dx * leg[0] + dy * leg[1] > -100)))
            x, y = x + dx, y + dy
            words = [f"X{self.scaled(x)}", f"Y{self.scaled(y)}"]
            axes = words if dx and dy else [words[0] if dx else words[1]]
            self.put((self.straight + " " if n == 0 else "") + " ".join(axes) + (" " + self.corner() if self.chance.random() < 0.7 else "") + (feed if n == 0 else ""))
        out = (dx - dy, dx + dy)
        self.put(self.straight + f" X{self.scaled(x + out[0])} Y{self.scaled(y + out[1])}", *begin)

    def scaled(self, mm):
        return f"{mm / (25.4 if self.inch else 1.0):.{4 if self.inch else 3}f}"

    def modal_corner(self):
        return []

    def chain(self):
        step = 0.0001 if self.inch else 0.001
        self.put(self.straight + " F" + self.one_of("120.", "60."), "G91")
        for _ in range(self.chance.randint(3, 40)):
            self.put(f"X{step * self.chance.uniform(-9, 9):.5f} Y{step * self.chance.uniform(-9, 9):.5f}" if self.fine else f"X{step * self.chance.randint(-9, 9):.4f} Y{step * self.chance.randint(-9, 9):.4f}")
        self.put("G90")

    fine = False

    def move(self):
        self.put(self.one_of(self.fast, self.straight + " F100.") + f" X{self.length(-50, 50)}" + self.maybe(f" Y{self.length(-50, 50)}") + self.maybe(f" Z{self.length(20, 40)}"))

    def text(self):
        self.head()
        kinds = [self.contour, self.contour, self.chain, self.move, self.drill, self.drill, self.frame]
        for _ in range(self.chance.randint(2, 5)):
            self.chance.choice(kinds)()
        if self.chance.random() < 0.35:
            self.lines.insert(self.chance.randint(5, len(self.lines)), self.write())
        self.end()
        return "\n".join(self.lines) + "\n"


class MixedSinumerik(Mixed):
    fast, straight = "G0", "G1"

    def __init__(self, seed):
        super().__init__(seed)
        self.fine = self.chance.random() < 0.3

    def head(self):
        self.put("G17 G90 G94 G40 " + ("G700" if self.inch else "G710"), self.one_of("T1 D1", "T1 M6\nD1"), "S500 M3 F150", f"G0 X{self.length(-9, 9)} Y{self.length(-9, 9)} Z{self.scaled(30)}", f"G1 X{self.length(-9, 9)}")

    def end(self):
        self.put(f"G0 Z{self.scaled(60)}", "M30")

    def corner(self):
        return self.one_of("CHR=", "CHF=", "RND=") + self.length(0.5, 4)

    def modal_corner(self):
        if self.chance.random() < 0.3:
            self.put("RNDM=" + self.length(0.5, 3))
            return ["RNDM=0"]
        return []

    def drill(self):
        rtp, rfp, sdis, depth = self.scaled(self.one_of(10, 12)), self.scaled(self.one_of(0, 2)), self.scaled(self.one_of(0, 1, 2)), self.length(-40, -5)
        place = self.one_of(f"{rtp},{rfp},{sdis},{depth}", f"{rtp},{rfp},{sdis},,{depth.lstrip('-')}")
        five = place if place.count(",") == 4 else place + ","
        tap = f"{five},{self.one_of('', '0.2')},{self.one_of('0', '3', '4', '5')},{self.one_of(',1.5', '6,', ',-1.25')},0,{self.one_of('300', '400')},{self.one_of('', '300', '600')},3,0,0,{self.one_of(0, 0, 1, 2)},{self.length(2, 6)},{self.one_of('0', self.length(0.5, 2))}"
        cycle = self.one_of(f"CYCLE81({five})", f"CYCLE82({five},{self.one_of('0.3', '1')})", f"CYCLE83({five},{self.pecks()})", f"CYCLE84({tap})", f"CYCLE85({five},{self.one_of('0', '0.3')},{self.one_of('80', '120')},{self.one_of('100', '200')})",
                            f"CYCLE86({five},0.2,3,{self.length(0.5, 1)},{self.length(0.5, 1)},{self.length(0.5, 1)},0)", f"CYCLE88({five},0.2,3)", f"CYCLE89({five},0.3)", f"CYCLE840({five},0,0,3,0,0,1.25)")
        if self.chance.random() < 0.5:
            self.put(f"G0 X{self.length(-30, 30)} Y{self.length(-30, 30)}", cycle)
        else:
            holes = self.one_of(f"X{self.length(-30, 30)} Y{self.length(-30, 30)}\nX{self.length(-30, 30)}", f"HOLES1({self.length(-9, 9)},{self.length(-9, 9)},{self.chance.randint(0, 90)},{self.length(2, 5)},{self.length(5, 9)},{self.chance.randint(2, 5)})",
                                f"HOLES2({self.length(-9, 9)},{self.length(-9, 9)},{self.length(9, 20)},{self.chance.randint(0, 90)},{self.one_of('0', '30')},{self.chance.randint(2, 5)})")
            self.put(f"G0 X{self.length(-30, 30)} Y{self.length(-30, 30)}", "MCALL " + cycle, holes, "MCALL")
        self.put(self.one_of("", "M3 S500 G0"), f"G1 X{self.length(-30, 30)} F130")
        self.lines = [line for line in self.lines if line]

    def pecks(self):
        return f"{self.maybe(self.length(-9, -4))},{self.length(3, 9)},{self.one_of('0', '0', self.length(0.5, 3), '-0.5', '-0.8')},{self.one_of('0', '0.3')},{self.one_of('0', '0.2')},{self.one_of('1', '1', '0.5')},{self.one_of(0, 1)},{self.one_of('0', '3')},{self.one_of('0', self.length(0.5, 2))},{self.one_of('0', self.length(0.5, 2))},{self.one_of('0', '0.4')},{self.one_of('0', self.length(0.3, 2))}"

    def frame(self):
        begin = self.one_of(f"TRANS X{self.length(-9, 9)} Y{self.length(-9, 9)}", f"TRANS Z{self.length(1, 3)}\nAROT RPL={self.chance.randint(5, 80)}", f"ROT RPL={self.chance.randint(5, 80)}", "MIRROR X0", f"TRANS X{self.length(-9, 9)}\nASCALE X2 Y2", "G54", "G55")
        self.put(begin, f"G1 X{self.length(-20, 20)} Y{self.length(-20, 20)} F90", f"G2 X=IC({self.scaled(10)}) Y=IC(0) I{self.scaled(5)} J0" if "ROT" not in begin else f"G1 Y{self.length(-20, 20)}")
        self.put(begin if begin in ("G54", "G55") else "TRANS")

    def write(self):
        value = self.unique()
        return self.one_of(f"$A_OUT[1]=1 R7={value}", f"R5={value}", f"$P_UIFR[1]=CTRANS(X,{value})", f"$P_UIFR[1,X,TR]={value}", f"$P_BFRAME=CTRANS(Y,{value})", f"$AC_PARAM[3]={value}", f"$TC_DP3[1,1]={value}", f"R6=R6+{value}")


class MixedFanuc(Mixed):
    fast, straight = "G00", "G01"

    def head(self):
        self.put("%", "O0001 (MIXED)", "G17 G90 G94 G40 G49 G80 " + ("G20" if self.inch else "G21"), "T1 M06", "S500 M03 F150.", f"G00 X{self.length(-9, 9)} Y{self.length(-9, 9)} Z{self.scaled(30)}", f"G01 X{self.length(-9, 9)}")

    def end(self):
        self.put(f"G00 Z{self.scaled(60)}", "M30", "%")

    def corner(self):
        return self.one_of(",C", ",R") + self.length(0.5, 4)

    def drill(self):
        depth, level = self.length(-40, -5), self.length(1, 5)
        code = self.one_of("G81", "G82", "G83", "G73", "G85", "G86", "G89", "G84", "G74", "G76")
        words = {"G82": " P300", "G83": f" Q{self.length(2, 9)}", "G73": f" Q{self.length(2, 9)}", "G89": " P200", "G84": self.maybe(" P200"), "G74": "", "G76": f" Q{self.length(0.2, 0.5)}"}.get(code, "")
        feed = " F625." if code in ("G84", "G74") else " F90."
        if self.inch and code in ("G84", "G74"):
            feed = " F25."
        self.put(self.one_of("G98", "G99") + f" {code} X{self.length(-30, 30)} Y{self.length(-30, 30)} Z{depth} R{level}{words}{feed}" + self.maybe(" K2" if self.chance.random() < 0.3 else "", 0.5))
        for _ in range(self.chance.randint(0, 3)):
            self.put(f"X{self.length(-30, 30)}" + self.maybe(f" Y{self.length(-30, 30)}"))
        self.put("G80", self.one_of("G00", "G01 F130.") + f" Z{self.scaled(30)}")

    def frame(self):
        begin, end = self.one_of((f"G52 X{self.length(-9, 9)} Y{self.length(-9, 9)}", "G52 X0. Y0."), (f"G68 X0. Y0. R{self.chance.randint(5, 80)}.", "G69"), ("G51.1 X0.", "G50.1 X0."), ("G54", "G54"), ("G55", "G54"), ("G51 X0. Y0. P2000", "G50"))
        self.put(begin, f"G01 X{self.length(-20, 20)} Y{self.length(-20, 20)} F90.", f"G01 Y{self.length(-20, 20)}", end)

    def write(self):
        value = self.unique()
        return self.one_of(f"#1132=1\n#500={value}", f"#101={value}", f"#500={value}", f"G10 L2 P1 X{value}", f"#5221={value}", f"G10 L10 P1 R{value}", f"#500=#500+{value}", f"#2001={value}")


class MixedOther(MixedFanuc):
    """Of the other controls with numbered variables: no words but those that all of them have."""

    def drill(self):
        super().drill()
        self.lines = [line.replace(" K2", "") for line in self.lines]


class MixedLathe:
    """Contours in Z and X with corners, chains of increments, and turning cycles, in inch and mm."""

    kind = "lathe"

    def turned(self):
        z, x = self.chance.uniform(-5, 5), self.chance.uniform(20, 60)
        self.put(f"{self.fast} X{self.scaled(x)} Z{self.scaled(z)}")
        dz, dx = 0, 0
        for n in range(self.chance.randint(2, 5)):
            legs = ((-15, 0), (0, 24), (-12, 12))
            dz, dx = self.one_of(*(leg for leg in legs if n == 0 or dz * leg[1] != dx * leg[0]))
            z, x = z + dz, x + dx
            words = ([f"X{self.scaled(x)}"] if dx else []) + ([f"Z{self.scaled(z)}"] if dz else [])
            self.put((self.straight + " " if n == 0 else "") + " ".join(words) + (" " + self.corner() if self.chance.random() < 0.7 else "") + (f" F{self.feed()}" if n == 0 else ""))
        out = (0, 30) if dz else (-15, 0)
        self.put(f"{self.straight} X{self.scaled(x + out[1])} Z{self.scaled(z + out[0])}", f"{self.fast} X{self.scaled(x + 60)}", f"Z{self.scaled(20)}")

    def feed(self):
        return f"{0.2 / (25.4 if self.inch else 1):.4f}"

    def plain(self):
        self.put(self.one_of(f"{self.fast} X{self.length(62, 90)} Z{self.length(5, 20)}", f"{self.straight} X{self.length(62, 90)} F{self.feed()}"))

    def text(self):
        self.head()
        for _ in range(self.chance.randint(2, 5)):
            self.chance.choice((self.turned, self.turned, self.cycle, self.steps, self.plain))()
        if self.chance.random() < 0.3:
            self.lines.insert(self.chance.randint(5, len(self.lines)), self.write())
        self.end()
        return "\n".join(self.lines) + "\n"


class MixedFanucLathe(MixedLathe, MixedFanuc):
    def head(self):
        self.put("%", "O0001 (MIXED LATHE)", "G18 G40 G97 G99 " + ("G20" if self.inch else "G21"), "T0101", "S500 M03", f"G00 X{self.scaled(62)} Z{self.scaled(5)}")

    def end(self):
        self.put(f"G00 X{self.scaled(120)}", "M30", "%")

    def steps(self):
        step = 0.0001 if self.inch else 0.001
        self.put("G01 F" + self.feed())
        for _ in range(self.chance.randint(3, 30)):
            self.put(f"U{step * self.chance.randint(-9, 9) * 2:.4f} W{step * self.chance.randint(-9, 9):.4f}")

    def cycle(self):
        self.put(f"G00 X{self.scaled(62)} Z{self.scaled(5)}")
        kind = self.chance.randrange(4)
        if kind == 0:
            self.put(f"G90 X{self.length(40, 60)} Z{self.length(-40, -5)} F{self.feed()}", f"X{self.length(30, 40)}", "G00 Z" + self.scaled(6))
        elif kind == 1:
            self.put(f"G92 X{self.length(50, 58)} Z{self.length(-40, -5)} F{1.5 / (25.4 if self.inch else 1):.4f}", f"X{self.length(45, 50)}", "G00 Z" + self.scaled(6))
        elif kind == 2:
            self.put(f"G94 X{self.length(20, 40)} Z{self.length(-5, 4)} F{self.feed()}", "G00 Z" + self.scaled(6))
        else:
            self.put(f"G76 P020060 Q{self.chance.randint(5, 20)} R0.0{self.chance.randint(10, 50)}" if not self.inch else f"G76 P020060 Q{self.chance.randint(5, 20)} R0.00{self.chance.randint(10, 50)}",
                     f"G76 X{self.length(56, 58)} Z{self.length(-40, -20)} P{500 if not self.inch else 200} Q{200 if not self.inch else 80} F{1.5 / (25.4 if self.inch else 1):.4f}", "G00 Z" + self.scaled(6))


class MixedSinumerikLathe(MixedLathe, MixedSinumerik):
    def head(self):
        self.put("G18 G90 G95 G40 DIAMON " + ("G700" if self.inch else "G710"), "T1 D1", "G97 S500 M3", f"G0 X{self.scaled(62)} Z{self.scaled(5)}", "G1 F" + self.feed())

    def end(self):
        self.put(f"G0 X{self.scaled(120)}", "M30")

    def steps(self):
        step = 0.0001 if self.inch else 0.001
        self.put("G1 F" + self.feed(), "G91")
        for _ in range(self.chance.randint(3, 30)):
            self.put(f"X{step * self.chance.randint(-9, 9) * 2:.4f} Z{step * self.chance.randint(-9, 9):.4f}")
        self.put("G90")

    def cycle(self):
        d = self.chance.uniform(30, 50)
        self.put(f"G0 X{self.scaled(62)} Z{self.scaled(5)}", f"CYCLE97({1.5 / (25.4 if self.inch else 1):.4f},,{self.scaled(0)},{self.length(-40, -20)},{self.scaled(d)},{self.scaled(d)},{self.scaled(3)},{self.scaled(2)},{self.scaled(0.92)},{self.scaled(0.05)},{self.one_of(0, 29)},0,{self.chance.randint(3, 8)},{self.chance.randint(0, 2)},{self.one_of(1, 3)},1)", f"G0 X{self.scaled(70)}")


MIXED = {"mixed-sinumerik": ("sinumerik-840d", MixedSinumerik), "mixed-fanuc": ("fanuc", MixedFanuc), "mixed-haas": ("haas", MixedOther), "mixed-mazak": ("mazak", MixedOther), "mixed-mitsubishi": ("mitsubishi-m80", MixedOther), "turned-sinumerik": ("sinumerik-840d", MixedSinumerikLathe), "turned-fanuc": ("fanuc", MixedFanucLathe), "turned-haas": ("haas", MixedFanucLathe), "turned-mazak": ("mazak", MixedFanucLathe), "turned-mitsubishi": ("mitsubishi-m80", MixedFanucLathe)}
