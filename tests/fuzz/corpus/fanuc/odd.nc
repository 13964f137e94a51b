leader before the tape
%
<SEED-NAME>
N0010G0X1Y2Z3(a (b)
G1 X1.2.3 Y--4
#1=[[[[[[1]]]]]]
#=5
G999 M77 X
IF[1]GOTO
END3
)stray [
WHILE[#1LT2]DO4
:0044
М30
% M02
