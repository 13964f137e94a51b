// The lists of names, from the overviews of statements in the Programming Manuals Fundamentals and Job Planning, and
// of standard cycles in the Commissioning and Operating Manuals.
#include "dialects/sinumerik/tables/vocabulary.h"

#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/called_cycles.h"
#include "dialects/sinumerik/tables/codes.h"

namespace dripfeed::sinumerik {

namespace {

// Functions that give a value and have no counterpart in ir. What they answer is the control's: never zero.
constexpr std::string_view kForeign[] = {
    "SPRINT",     "AX",        "AXTOSPI",    "SPI",        "CROTS",      "INVFRAME",  "ADDFRAME", "CALCDAT",
    "CALCPOSI",   "GETT",      "ISAXIS",     "ISFILE",     "INTERSEC",   "CTAB",      "CTABINV",  "CTABTSV",
    "CTABTEV",    "CTABSSV",   "CTABSEV",    "CTABEXISTS", "CTABTSP",    "CTABTEP",   "CTABID",   "GETACTTD",
    "GETDNO",     "GETSELT",   "GETEXET",    "CHKDM",      "CHKDNO",     "CORRTRAFO", "QU",       "AXCTSWEC",
    "MODAXVAL",   "GETVARTYP", "GETVARPHU",  "GETVARAP",   "GETVARLIM",  "GETVARDFT", "GETTCOR",  "GETFREELOC",
    "ISOPENTYPE", "DELOBJ",    "STRINGIS",   "MEAFRAME",   "MEASURE",    "GETTENV",   "SETTCOR",  "GETVARDIM",
    "GETACTT",    "TOOLGNT",   "TOOLGT",     "NEWMT",      "DELMLOWNER", "DELMLRES",  "CHECKSUM", "COLLPAIR",
    "CORRTC",     "LENTOAX",   "MATCH",      "NAMETOINT",  "ORISOLH",    "POSRANGE",  "SIRELAY",  "CTABFNO",
    "CTABFPOL",   "CTABFSEG",  "CTABISLOCK", "CTABMEMTYP", "CTABMPOL",   "CTABMSEG",  "CTABNO",   "CTABNOMEM",
    "CTABPERIOD", "CTABPOL",   "CTABPOLID",  "CTABSEG",    "CTABSEGID",  "CTABTMAX",  "CTABTMIN", "BTOI",
    "BTOR",       "ITOB",      "ITOR",       "RTOB",       "RTOI",       "GP",        "PM",       "PR"};

// Around the value of one word: X=AC(10).
constexpr std::string_view kWordMode[] = {"AC",  "IC",   "DC",   "ACP", "ACN", "CAC", "CIC",
                                          "CDC", "CACP", "CACN", "DAC", "DIC", "RAC", "RIC"};

// Words with a name that are kept as they are written.
constexpr std::string_view kAddress[] = {
    "FRC",       "FRCM",     "FL",       "ADIS",      "ADISPOS",  "DISC",     "DISCL",    "DISR",      "DISRP",
    "DISPR",     "SF",       "SPOS",     "SPOSA",     "POS",      "POSA",     "POSP",     "FA",        "OVR",
    "OVRRAP",    "OVRA",     "ACC",      "VELOLIM",   "ACCLIM",   "JERKLIM",  "PACCLIM",  "FLIM",      "SCC",
    "PO",        "CTOL",     "OTOL",     "ATOL",      "CTOLG0",   "OTOLG0",   "STOLF",    "MEASA",     "MEAWA",
    "MEAC",      "OS",       "OSP1",     "OSP2",      "OST1",     "OST2",     "OSE",      "OSNSC",     "OSCTRL",
    "OSB",       "OSCILL",   "FD",       "FDA",       "FXS",      "FXST",     "FXSW",     "FOC",       "FOCON",
    "FOCOF",     "FZ",       "SVC",      "FMA",       "FAD",      "DITS",     "DITE",     "DILF",      "ALF",
    "FP",        "SR",       "SRA",      "ST",        "STA",      "STAT",     "TU",       "THETA",     "PSI",
    "PHI",       "TILT",     "LEAD",     "FGREF",     "VELOLIMA", "ACCLIMA",  "JERKLIMA", "CFTOL",     "BLSYNC",
    "TOFF",      "TOFFL",    "TOFFR",    "TOFFLR",    "MOV",      "MOVT",     "PRIO",     "DL",        "ISD",
    "IP",        "IR",       "JR",       "KR",        "ORIS",     "SCPARA",   "OMA1",     "OMA2",      "OMA3",
    "OMA4",      "OMA5",     "CPBC",     "CPFMOF",    "CPFMON",   "CPFMSON",  "CPFPOS",   "CPFRS",     "CPLA",
    "CPLCTID",   "CPLDEN",   "CPLINSC",  "CPLINTR",   "CPLNUM",   "CPLOUTSC", "CPLOUTTR", "CPLPOS",    "CPLSETVAL",
    "CPMALARM",  "CPMBRAKE", "CPMPRT",   "CPMRESET",  "CPMSTART", "CPMVDI",   "CPRES",    "CPSETTYPE", "CPSYNCOP",
    "CPSYNCOP2", "CPSYNCOV", "CPSYNFIP", "CPSYNFIP2", "CPSYNFIV", "ANG1",     "ANG2"};

// Procedures that are kept as they are written, and of which is not known here what they change.
constexpr std::string_view kProcedure[] = {
    "CALLPATH",  "ID",        "IDS",        "WHEN",      "WHENEVER", "FROM",       "EVERY",    "DO",         "CANCEL",
    "CANCELSUB", "LOCK",      "UNLOCK",     "SETINT",    "DISABLE",  "ENABLE",     "CLRINT",   "INIT",       "START",
    "WAITM",     "WAITMC",    "WAITE",      "SETM",      "CLEARM",   "WAITENC",    "WAITV",    "WAITC",      "SETMS",
    "SETMTH",    "FCTDEF",    "SYNFCT",     "GET",       "GETD",     "RELEASE",    "AXTOCHAN", "CTABDEF",    "CTABEND",
    "CTABDEL",   "CTABLOCK",  "CTABUNLOCK", "PUNCHACC",  "PON",      "PONS",       "SON",      "SONS",       "SPOF",
    "PDELAYON",  "PDELAYOF",  "SPP",        "SPN",       "CONTPRON", "CONTDCON",   "EXECUTE",  "DIAMONA",    "DIAM90A",
    "DIAMOFA",   "DIAMCHANA", "DIAMCHAN",   "DIACYCOFA", "DACA",     "NEWT",       "DELT",     "DELMT",      "DELTC",
    "SETPIECE",  "SETTA",     "SETTIA",     "RESETMON",  "DELDL",    "SETDNO",     "DZERO",    "DELTOOLENV", "TOOLENV",
    "TCARR",     "TCOABS",    "TCOFR",      "TCOFRX",    "TCOFRY",   "TCOFRZ",     "TCI",      "TCA",        "MVTOOL",
    "POSM",      "POSMT",     "NEWCONF",    "CUTMOD",    "CUTMODK",  "STOPREOF",   "RDISABLE", "OVERSTORE",  "LIFTFAST",
    "POLF",      "POLFMASK",  "POLFMLIN",   "FXSOF",     "IPOBRKA",  "ADISPOSA",   "COARSEA",  "FINEA",      "IPOENDA",
    "PROTA",     "PROTD",     "PROTS",      "PROTSET",   "NPROT",    "NPROTDEF",   "CPROT",    "CPROTDEF",   "TML",
    "ORIROTA",   "ORIROTR",   "ORIROTT",    "ORIROTC",   "ORIRESET", "SPLINEPATH", "POLYPATH", "FPR",        "FPRAON",
    "FPRAOF",    "FPO",       "GWPSON",     "GWPSOF",    "CADAPTON", "CADAPTOF",   "ESRR",     "ESRS",       "DRVPRD",
    "DRVPWR",    "RESET",     "RETB",       "SIRELIN",   "SIRELOUT", "SIRELTIME",  "TANGDEL",  "TLIFT",      "COUPDEF",
    "COUPDEL",   "EGDEF",     "EGDEL",      "MASLDEF",   "MASLDEL",  "CPDEF",      "CPDEL",    "CPLDEF",     "CPLDEL",
    "INITIAL",   "READ",      "FILEDATE",   "FILEINFO",  "FILESIZE", "FILESTAT",   "FILETIME"};

// Procedures after which axes may be anywhere: couplings that carry axes along, retracts, measuring, exchange of axes.
constexpr std::string_view kMovingProcedure[] = {
    "EXECTAB",  "POLFA",   "TANG",    "TANGON",  "TANGOF",  "COUPON",   "COUPONC", "COUPOF",   "COUPOFS",
    "COUPRES",  "TRAILON", "TRAILOF", "LEADON",  "LEADOF",  "EGON",     "EGONSYN", "EGONSYNE", "EGOFS",
    "EGOFC",    "MASLON",  "MASLOF",  "MASLOFS", "CPON",    "CPOF",     "CPLON",   "CPLOF",    "AXCTSWE",
    "AXCTSWED", "FTOC",    "FTOCON",  "FTOCOF",  "PUTFTOC", "PUTFTOCF", "DELDTG"};

// Procedures that change where coordinates lie: transformations, exchange of geometry axes, overlays, actual values.
constexpr std::string_view kShiftingProcedure[] = {"GEOAX",    "TRANSMIT",  "TRACYL",  "TRAANG", "TRAORI",
                                                   "TRACON",   "TRACOOF",   "TRAFOON", "TOFFON", "TOFFOF",
                                                   "PRESETON", "PRESETONS", "ROTS",    "AROTS",  "CORROF"};

// Procedures that change nothing of motion or state that is modelled: displays and groups of the editor, files, blank
// declarations, acceleration, monitoring, position control of spindles, attributes of data.
constexpr std::string_view kQuietProcedure[] = {
    "WORKPIECE", "WRITE",       "MMC",        "EXTOPEN",      "EXTCLOSE", "DELETE",     "WAITP",    "WAITS",
    "WRTPR",     "GROUP_BEGIN", "GROUP_END",  "GROUP_ADDEND", "BRISKA",   "SOFTA",      "DRIVEA",   "JERKA",
    "AFISON",    "AFISOF",      "TMON",       "TMOF",         "REDEF",    "UNDEF",      "AUXFUDEL", "AUXFUDELG",
    "AUXFUMSEQ", "AUXFUSYNC",   "DELAYFSTON", "DELAYFSTOF",   "IPTRLOCK", "IPTRUNLOCK", "ENDPROC",  "CHANDATA",
    "METRIC",    "INCH",        "SPCON",      "SPCOF"};

// Which axes feeds count along (PG, "Feedrate").
constexpr std::string_view kPacingProcedure[] = {"FGROUP"};

// Standard cycles that are not read. They move, but for those of the list after it.
constexpr std::string_view kCycle[] = {
    "CYCLE60",   "CYCLE63",   "CYCLE64",   "CYCLE70",   "CYCLE78",   "CYCLE79",   "CYCLE90",   "CYCLE92",  "CYCLE93",
    "CYCLE94",   "CYCLE96",   "CYCLE98",   "CYCLE99",   "CYCLE116",  "CYCLE150",  "CYCLE160",  "CYCLE206", "CYCLE207",
    "CYCLE208",  "CYCLE209",  "CYCLE210",  "CYCLE435",  "CYCLE495",  "CYCLE750",  "CYCLE751",  "CYCLE752", "CYCLE753",
    "CYCLE754",  "CYCLE755",  "CYCLE756",  "CYCLE757",  "CYCLE758",  "CYCLE759",  "CYCLE782",  "CYCLE801", "CYCLE802",
    "CYCLE805",  "CYCLE806",  "CYCLE860",  "CYCLE899",  "CYCLE930",  "CYCLE940",  "CYCLE950",  "CYCLE951", "CYCLE952",
    "CYCLE4071", "CYCLE4072", "CYCLE4073", "CYCLE4074", "CYCLE4075", "CYCLE4077", "CYCLE4078", "CYCLE4079"};

// … and change where coordinates lie: swivelled planes, measured work offsets and tools.
constexpr std::string_view kShiftingCycle[] = {"CYCLE800", "CYCLE830", "CYCLE961", "CYCLE971", "CYCLE972", "CYCLE973",
                                               "CYCLE974", "CYCLE976", "CYCLE977", "CYCLE978", "CYCLE979", "CYCLE982",
                                               "CYCLE994", "CYCLE995", "CYCLE996", "CYCLE997", "CYCLE998", "CYCLE9960"};

// Settings of the path: a machine tool builder's part of it may switch more.
constexpr std::string_view kSettingCycle[] = {"CYCLE832"};

// A contour is only named: the cycle after it moves.
constexpr std::string_view kNamingCycle[] = {"CYCLE62"};

// Words inside other statements and definitions.
constexpr std::string_view kAttribute[] = {"TO",    "OF",    "DEFAULT", "BLOCK", "SET",  "REP",   "AS",    "SAVE",
                                           "VAR",   "NCK",   "CHAN",    "SYNR",  "SYNW", "SYNRW", "INIRE", "INIPO",
                                           "INICF", "PRLOC", "CPRLOC",  "LLI",   "ULI",  "PHU",   "APR",   "APW",
                                           "APRP",  "APWP",  "APRB",    "APWB",  "APX",  "APXP",  "APXB"};

constexpr WordList kLists[] = {
    {Role::foreign, Effect::none, kForeign},
    {Role::word_mode, Effect::none, kWordMode},
    {Role::address, Effect::unknown, kAddress},
    {Role::procedure, Effect::unknown, kProcedure},
    {Role::procedure, Effect::moves, kMovingProcedure},
    {Role::procedure, Effect::shifts, kShiftingProcedure},
    {Role::procedure, Effect::none, kQuietProcedure},
    {Role::procedure, Effect::paces, kPacingProcedure},
    {Role::cycle, Effect::moves, kCycle},
    {Role::cycle, Effect::shifts, kShiftingCycle},
    {Role::cycle, Effect::smooths, kSettingCycle},
    {Role::cycle, Effect::none, kNamingCycle},
    {Role::attribute, Effect::none, kAttribute},
};

}  // namespace

std::span<const WordList> vocabulary() { return kLists; }

bool is_word_of_control(std::string_view name) {
  return find_keyword(name) != nullptr || find_named_code(name) != nullptr || !standard_cycle(name).empty() ||
         find_called_cycle(name) != nullptr;
}

}  // namespace dripfeed::sinumerik
