// Canonical text, and that printing what was printed changes nothing.
#include <string>

#include "tests/unit/dialects/sinumerik/reading.h"

namespace dripfeed::sinumerik {
namespace {

TEST(Print, WordsInOneOrderAndPointsOnPositions) {
  EXPECT_EQ(printed(good("m8 f900 x10 g1 t6 y-.5 g90 s500 d1 m3")), "G1 G90 X10. Y-0.5 F900 T6 S500 D1 M8 M3\n");
  EXPECT_EQ(printed(good("G2X=IC(1)Y=AC(R1)CR=5 I=AC(2)")), "G2 X=IC(1.) Y=AC(R1) CR=5. I=AC(2.)\n");
  EXPECT_EQ(printed(good("SETMS(2)\nSETMS")), "SETMS(2)\nSETMS\n");
  EXPECT_EQ(printed(good("S2=500 M2=3 T=\"A\" G505 DIAM90 G642")), "G505 DIAM90 G642 S2=500 T=\"A\" M2=3\n");
}

TEST(Print, PolynomialsAreOneWord) {
  EXPECT_EQ(printed(good("poly x10 po[y]=(R1,-4.0000001) PL=2.5")), "POLY X10. PO[Y]=(R1,-4.0000001) PL=2.5\n");
  EXPECT_EQ(printed(good("PO[X]=(1,5) PL=0.0632455532034")), "PO[X]=(1.,5) PL=0.0632455532034\n");
  EXPECT_EQ(printed(good("POLY X=PO(10) Z=PO(IC(5),0,R2*2,-1.5,1) F5")),
            "POLY PO[X]=(10.,0) PO[Z]=(IC(5.),0,R2*2,-1.5,1) F5\n");
}

TEST(Print, ThePositionsOfATraceAreKept) { EXPECT_EQ(printed(good("G0 X1.23456")), "G0 X1.23456\n"); }

TEST(Print, StatementsOfEveryKind) {
  const std::string text =
      "PROC PART(REAL A, VAR INT B, STRING[20] C=\"x\") SAVE\n"
      "DEF INT N1=3, LIST[2,3]\n"
      "EXTERN OTHER(REAL)\n"
      "START1: IF A>1 GOTOF N20\n"
      "IF (A==1) AND (B<>2)\n"
      "LIST[1,B]=LIST[0,0]+1\n"
      "ELSE\n"
      "WHILE N1<10\n"
      "N1=N1+1\n"
      "ENDWHILE\n"
      "ENDIF\n"
      "FOR R1=1 TO 5\n"
      "ENDFOR\n"
      "REPEAT\n"
      "UNTIL R1>5\n"
      "LOOP\n"
      "GOTOC NOWHERE\n"
      "ENDLOOP\n"
      "/1 N20 OTHER(1,,A) P=2\n"
      "MSG(\"at \" << R1)\n"
      "MSG()\n"
      "SETAL(65000,\"stop\")\n"
      "MCALL CYCLE81(20,0,5,,2)\n"
      "MCALL\n"
      "$P_PFRAME=CTRANS(X,10):CROT(Z,45)\n"
      "$P_UIFR[1,X,TR]=5\n"
      "RET(\"THERE\")\n"
      "G4 F2.5\n"
      "RET\n";
  EXPECT_EQ(printed(good(text)), text);
}

TEST(Print, AssignmentsOfOneLineStayTogether) {
  EXPECT_EQ(printed(good("R1=1 R2=2 G0 X=R1")), "R1=1 R2=2\nG0 X=R1\n");
  EXPECT_EQ(printed(good("R1=1\nR2=2")), "R1=1\nR2=2\n");
}

// Block search finds its place by them, whether a jump leads there or not.
TEST(Print, BlockNumbersStay) {
  const std::string text = "N10 R1=1\nN20 R1=R1+1\nN30 IF R1<5 GOTOB N20\nN40 M30\n";
  EXPECT_EQ(printed(good(text)), text);
}

TEST(Print, OriginsAndVariables) {
  const ir::Control c = control(ir::MachineKind::mill);
  const ir::Program p = raise(good("; head\nR1=1\n\nG0 X=R1+R2\nM30"), c, c).program;
  const ir::PrintResult result = print(p, c);
  EXPECT_EQ(result.text, "R1=1\nG0 X=R1+R2\nM30\n");
  EXPECT_EQ(result.origin_lines, (std::vector<std::uint32_t>{2, 4, 5}));
  EXPECT_EQ(result.variables, 2U);
}

// Each looks for its program by a method of its own (PGA, "CALL", "EXTCALL"): none may become another.
TEST(Print, CallsByTextStayAsTheyAreWritten) {
  const std::string text =
      "EXTCALL(\"A:/parts/GROOVE.SPF\")\nCALL NAME\nPCALL /_N_SPF_DIR/_N_GROOVE_SPF(1,2)\nGROOVE(1)\nM30\n";
  EXPECT_EQ(printed(good(text)), text);
}

TEST(Print, AxesFramesAndArcsByName) {
  const std::string text =
      "DEF AXIS A1\nROT RPL=45\nG0 AX[A1]=5.\nCIP X10. Y0. I1=5. J1=5.\nG1 X1. RND=2.\nG0 AP=30 RP=5\nM30\n";
  EXPECT_EQ(printed(good(printed(good(text)))), printed(good(text)));
}

}  // namespace
}  // namespace dripfeed::sinumerik
