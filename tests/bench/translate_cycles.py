"""Programs for translate_moves.py: what mills in cycles (pockets, slots, spigots, faces), drills at patterns in all planes, and turns several spindles. Maker.machine names the machine of the source, whose tools the milling cycles ask for."""

from translate_mixed import MixedFanuc, MixedSinumerik, MixedSinumerikLathe


class CyclesSinumerik(MixedSinumerik):
    """Milling cycles once or modal, holes at patterns, under frames, in three planes; a second spindle now and then."""

    machine = "sinumerik-840d-mill"

    def head(self):
        self.plane = self.one_of("G17", "G17", "G17", "G18", "G19")
        super().head()
        self.lines[0] = self.lines[0].replace("G17", self.plane)
        self.lines[1] = self.one_of("T1 M6\nD1", "T2 M6\nD1", "T1 D1 M6")

    def levels(self):
        """RTP, RFP, SDIS, DP and DPR, of which one is given; the plane of a G17 tool lies at Z0."""
        surface = self.chance.choice((0, 0, 2, -3))
        depth = self.chance.uniform(3, 14)
        head = f"{self.scaled(surface + 12)},{self.scaled(surface)},{self.one_of('0', self.scaled(1), self.scaled(2.5))}"
        return head, (f"{self.scaled(surface - depth)},", f",{self.scaled(depth)}"), self.scaled(surface - depth)

    def feeds(self):
        return self.one_of("300", "220.5"), self.one_of("90", "100", "0")

    def milling(self):
        head, (absolute, relative), depth = self.levels()
        both = self.one_of(absolute, relative)
        along, down = self.feeds()
        size, wide = self.length(34, 60), self.length(22, 33)
        corner, place = self.length(6.5, 10), f"{self.length(-20, 20)},{self.length(-20, 20)}"
        turn, infeed = self.one_of("0", "30", "-45", "90", "123"), self.one_of("0", self.length(1, 4), self.scaled(50))
        side, base = self.one_of("0", self.scaled(0.3)), self.one_of("0", self.scaled(0.2))
        direction = self.one_of(0, 1, 2, 3)
        entry = self.one_of((11, ""), (21, f",,,,{self.scaled(3)},{self.scaled(1.5)}"), (31, f",,,,15,{self.scaled(1)}"), (12, ""), (14, ""), (1, ""))
        rays = f"{self.chance.randint(1, 4)},{self.length(32, 45)}"
        ring = f"{place},{self.length(14, 25)},{turn},{self.one_of('90', '72', '45')}"
        wide_slot = self.length(13, 20)
        step = self.one_of("", self.length(2, 5))
        three = entry[1].removeprefix(",") if entry[1] else ""
        call = self.one_of(
            f"POCKET3({head},{depth},{size},{wide},{corner},{place},{turn},{infeed},{side},{base},{along},{down},{direction},{entry[0]},{step}" + (f",,,,{three.lstrip(',')}" if three else "") + ")",
            f"POCKET4({head},{depth},{self.length(15, 25)},{place},{infeed},{side},{base},{along},{down},{direction},{entry[0]},{step}" + (f",,,{three.lstrip(',')}" if three else "") + ")",
            f"POCKET1({head},{both},{size},{wide},{corner},{place},{turn},{down},{along},{infeed},{self.one_of(2, 3)},{side},{self.one_of(0, 1, 2)},{self.one_of('', self.scaled(5))},{self.one_of('', '250')})",
            f"POCKET2({head},{both},{self.length(15, 25)},{place},{down},{along},{infeed},{self.one_of(2, 3)},{side},{self.one_of(0, 1, 2)})",
            f"SLOT1({head},{both},{rays},{wide_slot},{ring},{down},{along},{infeed},{direction},{side},{self.one_of(0, 1, 2)},{self.one_of('', self.scaled(5))},{self.one_of('', '250')})",
            f"SLOT1({head},{both},{rays},{wide_slot},{ring},{down},{along},{infeed},{direction},{side},{self.one_of(21, 31)},,,,{base},5,{self.scaled(1)})",
            f"LONGHOLE({head},{both},{rays},{ring},{down},{along},{infeed}{self.one_of('', ',0', ',11')})",
            f"CYCLE61({head},{depth},{place},{size},{wide},{infeed},{self.length(2, 5)},{base},{along},{self.one_of(11, 21, 31, 41, 12)})",
            f"CYCLE71({head},{depth},{place},{self.one_of('', '-')}{size},{wide},{turn},{infeed},{self.length(2, 5)},{self.scaled(3)},{base},{along},{self.one_of(11, 21, 31, 41, 32)}{self.one_of('', ',' + self.scaled(2))})",
            f"CYCLE76({head},{both},{size},{wide},{corner},{place},{turn},{infeed},{side},{base},{along},{down},{direction},{self.one_of(1, 2)},{self.scaled(66)},{self.scaled(50)})",
            f"CYCLE77({head},{both},{wide},{place},{infeed},{side},{base},{along},{down},{direction},{self.one_of(1, 2)},{self.scaled(50)})",
        )
        self.put(self.one_of("G0", "G1 F200") + f" {self.across()}", f"G0 {self.deep}{self.scaled(30)}")
        if self.chance.random() < 0.05:
            self.put("MCALL " + call, self.across(), self.across(), "MCALL")
        else:
            self.put(call)
        self.put(f"{self.one_of('G0', 'G1 F130')} {self.across()}")

    @property
    def deep(self):
        return {"G17": "Z", "G18": "Y", "G19": "X"}[self.plane]

    def across(self):
        first, second = {"G17": "XY", "G18": "ZX", "G19": "YZ"}[self.plane]
        return f"{first}{self.length(-30, 30)} {second}{self.length(-30, 30)}"

    def pattern(self):
        """Each drilling cycle, modal, at rows, circles, grids of positions and plain positions; with a jump aside in between."""
        head, (absolute, relative), depth = self.levels()
        both = self.one_of(absolute, relative)
        cycle = self.one_of(f"CYCLE81({head},{both})", f"CYCLE82({head},{both},{self.one_of('0.3', '1', '-2')})", f"CYCLE83({head},{both},{self.pecks()})", f"CYCLE85({head},{both},0.2,80,150)",
                            f"CYCLE86({head},{both},0.2,{self.one_of(3, 4)},0,0,{self.scaled(0.5)},0)", f"CYCLE87({head},{both},3)", f"CYCLE88({head},{both},0.2,3)", f"CYCLE89({head},{both},0.3)",
                            f"CYCLE84({head},{both},0.1,{self.one_of(3, 4, 5)},,{self.one_of('1.5', '-1')},0,300,{self.one_of('300', '300', '450')})", f"CYCLE840({head},{both},0,{self.one_of(0, 4)},{self.one_of(3, 4)},0,,1.25)")
        holes = [self.one_of(f"HOLES1({self.length(-9, 9)},{self.length(-9, 9)},{self.one_of('0', '90', '37.5', '-20')},{self.length(0, 5)},{self.length(5, 9)},{self.chance.randint(1, 5)})",
                             f"HOLES2({self.length(-9, 9)},{self.length(-9, 9)},{self.length(9, 20)},{self.one_of('0', '45', '-30')},{self.one_of('0', '30', '-25')},{self.chance.randint(1, 6)})",
                             f"CYCLE802(111111111,111111111,{self.length(-9, 9)},{self.length(-9, 9)},{self.length(-9, 9)},{self.length(-9, 9)})", self.across(), self.across() + "\n" + self.across())
                 for _ in range(self.chance.randint(1, 2))]
        self.put(f"G0 {self.across()} F{self.one_of('120', '95.5')}", "MCALL " + cycle, *holes, "MCALL", "M3 S500", f"G1 {self.across()} F130")

    def spindle(self):
        self.put(self.one_of("S2=1200 M2=3", "M2=5", "SPOS[2]=90", f"SETMS(2)\nS400 M3\nG1 {self.across()} F100\nSETMS", "SPOS=45\nM3", f"S1=700 M1=4\nG1 {self.across()}\nM1=3", "M4\nG1 " + self.across() + "\nM3"))

    def frame(self):
        begin = self.one_of(f"TRANS X{self.length(-9, 9)} Y{self.length(-9, 9)}", f"TRANS X{self.length(-9, 9)}\nAROT RPL={self.chance.randint(5, 80)}", f"ROT RPL={self.chance.randint(5, 80)}", "MIRROR X0", "G55")
        self.put(begin, f"G0 {self.across()} {self.deep}{self.scaled(40)}")
        self.one_of(self.milling, self.pattern)()
        self.put("G54" if begin == "G55" else "TRANS", f"G0 {self.across()} {self.deep}{self.scaled(40)}")

    def text(self):
        self.head()
        kinds = [self.milling, self.milling, self.pattern, self.pattern, self.frame, self.move]
        for _ in range(self.chance.randint(1, 4)):
            self.chance.choice(kinds)()
        if self.chance.random() < 0.15:
            self.spindle()
        self.end()
        return "\n".join(self.lines) + "\n"


class CyclesFanuc(MixedFanuc):
    """Every drilling and boring cycle in three planes, absolute and by increments, repeated, with both planes of return, in loops and at patterns by arithmetic."""

    def head(self):
        super().head()
        self.plane = self.one_of("G17", "G17", "G17", "G18", "G19")
        self.lines[2] = self.lines[2].replace("G17", self.plane)

    @property
    def deep(self):
        return {"G17": "Z", "G18": "Y", "G19": "X"}[self.plane]

    def across(self, low=-30, high=30):
        first, second = {"G17": "XY", "G18": "ZX", "G19": "YZ"}[self.plane]
        return f"{first}{self.length(low, high)} {second}{self.length(low, high)}"

    CYCLES = {"G73": "Q", "G74": "", "G76": "Q", "G81": "", "G82": "P", "G83": "Q", "G84": "", "G85": "", "G86": "", "G89": "P"}
    REPEATED = "K"

    def words(self, code):
        kind = self.CYCLES[code]
        more = {"Q": f" Q{self.length(0.3, 0.6) if code == 'G76' else self.length(2, 9)}", "P": f" P{self.chance.randint(100, 900)}", "": ""}[kind]
        return more + (f" F{'25.' if self.inch else '625.'}" if code in ("G74", "G84") else self.one_of(" F90.", " F75.5"))

    def drill(self):
        code = self.chance.choice(list(self.CYCLES))
        self.put(f"G90 G00 {self.deep}{self.scaled(30)}", f"G00 {self.across()}")
        if self.chance.random() < 0.5:
            self.put(self.one_of("G98", "G99") + f" {code} {self.across()} {self.deep}{self.length(-30, -5)} R{self.length(1, 5)}{self.words(code)}")
            for _ in range(self.chance.randint(0, 4)):
                self.put(self.one_of(self.across(), self.across().split(" ")[0], self.across() + f" R{self.length(1, 5)}", self.across() + f" {self.deep}{self.length(-30, -5)}", "M08"))
        else:
            times = f" {self.REPEATED}{self.one_of(0, 2, 3)}" if self.REPEATED else ""
            self.put("G91 " + self.one_of("G98", "G99") + f" {code} {self.across(3, 9)} {self.deep}{self.length(-20, -5)} R{self.length(-28, -20)}{self.words(code)}" + self.maybe(times))
            for _ in range(self.chance.randint(0, 3)):
                self.put(self.across(-9, 9) + self.maybe(times))
        self.put("G80", f"G90 {self.one_of('G00', 'G01 F130.')} {self.deep}{self.scaled(30)}")

    def circle(self):
        """A bolt circle by arithmetic, in a loop."""
        first, second = {"G17": "XY", "G18": "ZX", "G19": "YZ"}[self.plane]
        code = self.one_of("G81", "G82", "G83", "G85")
        self.put(f"G00 {self.deep}{self.scaled(30)}", "#1=0", f"{self.one_of('G98', 'G99')} {code} {self.across()} {self.deep}{self.length(-20, -5)} R{self.length(1, 5)}{self.words(code)}", f"WHILE[#1LT{self.chance.randint(2, 5)}]DO1",
                 f"{first}[{self.length(9, 20)}*COS[#1*60.]] {second}[{self.length(9, 20)}*SIN[#1*60.]]", "#1=#1+1.", "END1", "G80", f"G00 {self.deep}{self.scaled(30)}")

    def spindle(self):
        self.put(self.one_of("M04\nG01 " + self.across() + " F90.\nM03", "M05\nG04 P200\nM03 S700", "S650"))

    def milled(self):
        self.move()

    def text(self):
        self.head()
        for _ in range(self.chance.randint(1, 4)):
            self.chance.choice([self.drill, self.drill, self.drill, self.circle, self.frame, self.spindle, self.milled])()
        self.end()
        return "\n".join(self.lines) + "\n"


class CyclesHaas(CyclesFanuc):
    """Bolt holes by G70 to G72 and back boring; now and then a circular pocket, which is not interpreted."""

    REPEATED = "L"

    def milled(self):
        if self.chance.random() < 0.2:
            self.put(f"G01 {self.deep}-1. F80.", self.one_of("G12", "G13") + f" I{self.length(5, 9)} F90. D01")
            return
        code = self.one_of("G81", "G82", "G83", "G85")
        self.put(f"G00 {self.deep}{self.scaled(30)}", f"G00 {self.across()}", f"{self.one_of('G98', 'G99')} {code} {self.deep}{self.length(-20, -5)} R{self.length(1, 5)}{self.words(code)} L0")
        self.put(self.one_of(f"G70 I{self.length(10, 20)} J{self.one_of('0.', '45.', '-30.')} L{self.chance.randint(2, 6)}", f"G71 I{self.length(10, 20)} J15. K{self.one_of('30.', '-25.')} L{self.chance.randint(2, 5)}",
                             f"G72 I{self.length(4, 9)} J{self.one_of('0.', '90.', '33.')} L{self.chance.randint(2, 5)}"))
        self.put("G80", f"G00 {self.deep}{self.scaled(30)}")


class CyclesFigures(CyclesFanuc):
    """Mazak and Mitsubishi."""

    CYCLES = {name: what for name, what in CyclesFanuc.CYCLES.items() if name != "G76"}

    def milled(self):
        if self.plane != "G17":
            return
        code = self.one_of("G81", "G82", "G83", "G85")
        self.put(f"G00 Z{self.scaled(30)}", f"G00 {self.across()}", f"{self.one_of('G98', 'G99')} {code} Z{self.length(-20, -5)} R{self.length(1, 5)}{self.words(code)} L0")
        at = self.across()
        self.put(self.one_of(f"G34 {at} I{self.length(5, 20)} J{self.chance.randint(0, 90)}. K{self.one_of(3, 4, -5)}", f"G35 {at} I{self.length(3, 9)} J{self.chance.randint(0, 180)}. K3",
                             f"G36 {at} I{self.length(5, 20)} J10. P{self.one_of('15.', '-20.')} K{self.chance.randint(2, 5)}", f"G37.1 {at} I{self.length(4, 8)} P3 J{self.length(4, 8)} K2"))
        self.put("G80", f"G00 Z{self.scaled(30)}")

    REPEATED = ""


class SpindlesSinumerik(MixedSinumerikLathe):
    """A lathe with a second spindle and a driven tool."""

    def cycle(self):
        if self.chance.random() < 0.5:
            super().cycle()
            return
        x = f"X{self.length(62, 80)}"
        self.put(self.one_of(f"S2=1200 M2=3\nG1 {x} F{self.feed()}\nM2=5", f"SETMS(2)\nS800 M4\nG95 G1 {x} F{self.feed()}\nSETMS\nG1 Z{self.scaled(7)}", f"SPOS=30\nG0 {x}\nM3", f"SPOS[2]=90\nG0 {x}",
                             f"S1=600 M1=3\nG1 {x} F{self.feed()}", f"G96 S150 LIMS=2000 M3\nG1 {x} F{self.feed()}\nG97 S500", f"G96 S150 LIMS=1800 M4\nG1 {x} F{self.feed()}\nG97 S500 M3", f"M4\nG1 {x} F{self.feed()}\nM3"))


CYCLES = {"cycles-sinumerik": ("sinumerik-840d", CyclesSinumerik), "cycles-fanuc": ("fanuc", CyclesFanuc), "cycles-haas": ("haas", CyclesHaas), "cycles-mazak": ("mazak", CyclesFigures),
          "cycles-mitsubishi": ("mitsubishi-m80", CyclesFigures), "spindles-sinumerik": ("sinumerik-840d", SpindlesSinumerik)}
