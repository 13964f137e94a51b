// The lists of names, from the overviews of statements in the Programming Manuals Fundamentals and Job Planning.
#include "dialects/sinumerik/plain_names.h"

namespace dripfeed::sinumerik {

namespace {

// Functions that give a value and have no counterpart in ir.
constexpr std::string_view kForeign[] = {"SPRINT",    "AX",         "AXTOSPI",  "SPI",        "CROTS",      "INVFRAME",
                                         "ADDFRAME",  "CALCDAT",    "CALCPOSI", "GETT",       "ISAXIS",     "ISFILE",
                                         "INTERSEC",  "CTAB",       "CTABINV",  "CTABTSV",    "CTABTEV",    "CTABSSV",
                                         "CTABSEV",   "CTABEXISTS", "CTABTSP",  "CTABTEP",    "CTABID",     "GETACTTD",
                                         "GETDNO",    "GETSELT",    "GETEXET",  "CHKDM",      "CHKDNO",     "CORRTRAFO",
                                         "QU",        "AXCTSWEC",   "MODAXVAL", "GETVARTYP",  "GETVARPHU",  "GETVARAP",
                                         "GETVARLIM", "GETVARDFT",  "GETTCOR",  "GETFREELOC", "ISOPENTYPE", "DELOBJ"};

// Around the value of one word: X=AC(10).
constexpr std::string_view kWordMode[] = {"AC",  "IC",   "DC",   "ACP", "ACN", "CAC", "CIC",
                                          "CDC", "CACP", "CACN", "DAC", "DIC", "RAC", "RIC"};

// Words with a name that are kept as they are written.
constexpr std::string_view kAddress[] = {
    "FRC",     "FRCM",   "FL",    "ADIS",  "ADISPOS", "DISC",  "DISCL",  "DISR",  "DISRP",    "SF",      "SPOS",
    "SPOSA",   "POS",    "POSA",  "POSP",  "FA",      "OVR",   "OVRRAP", "OVRA",  "ACC",      "VELOLIM", "ACCLIM",
    "JERKLIM", "SCC",    "PO",    "CTOL",  "OTOL",    "ATOL",  "STOLF",  "MEASA", "MEAWA",    "MEAC",    "OS",
    "OSP1",    "OSP2",   "OST1",  "OST2",  "OSE",     "OSNSC", "OSCTRL", "OSB",   "FD",       "FDA",     "FXS",
    "FXST",    "FXSW",   "FZ",    "SVC",   "FMA",     "FAD",   "DITS",   "DITE",  "DILF",     "RFP",     "FP",
    "SR",      "ST",     "THETA", "PSI",   "PHI",     "TILT",  "LEAD",   "FGREF", "VELOLIMA", "ACCLIMA", "JERKLIMA",
    "CFTOL",   "BLSYNC", "TOFF",  "TOFFL", "TOFFR",   "MOV",   "PRIO"};

// Statements that are kept as they are written, effects unknown.
constexpr std::string_view kNative[] = {
    "CALLPATH",   "EXECTAB",   "REDEF",     "UNDEF",     "ID",       "IDS",        "WHEN",     "WHENEVER",  "FROM",
    "EVERY",      "DO",        "CANCEL",    "CANCELSUB", "LOCK",     "UNLOCK",     "SETINT",   "DISABLE",   "ENABLE",
    "CLRINT",     "INIT",      "START",     "WAITM",     "WAITMC",   "WAITE",      "SETM",     "CLEARM",    "WAITENC",
    "WAITV",      "SETMS",     "SPCON",     "SPCOF",     "FGROUP",   "FCTDEF",     "FTOC",     "FTOCON",    "FTOCOF",
    "PUTFTOC",    "PUTFTOCF",  "SYNFCT",    "GEOAX",     "GET",      "GETD",       "RELEASE",  "AXTOCHAN",  "TRANSMIT",
    "TRACYL",     "TRAANG",    "TRAORI",    "TRACON",    "TRACOOF",  "TRAFOON",    "PRESETON", "PRESETONS", "DELDTG",
    "COUPDEF",    "COUPDEL",   "COUPON",    "COUPONC",   "COUPOF",   "COUPOFS",    "COUPRES",  "TRAILON",   "TRAILOF",
    "LEADON",     "LEADOF",    "EGDEF",     "EGON",      "EGONSYN",  "EGONSYNE",   "EGOFS",    "EGOFC",     "EGDEL",
    "TANG",       "TANGON",    "TANGOF",    "TANGDEL",   "TLIFT",    "CTABDEF",    "CTABEND",  "CTABDEL",   "CTABLOCK",
    "CTABUNLOCK", "MASLON",    "MASLOF",    "MASLDEF",   "MASLDEL",  "PUNCHACC",   "PON",      "PONS",      "SON",
    "SONS",       "SPOF",      "PDELAYON",  "PDELAYOF",  "SPP",      "SPN",        "CONTPRON", "CONTDCON",  "EXECUTE",
    "DIAMONA",    "DIAM90A",   "DIAMOFA",   "DIAMCHANA", "DIAMCHAN", "DACA",       "NEWT",     "DELT",      "SETPIECE",
    "SETTA",      "RESETMON",  "DELDL",     "SETDNO",    "DZERO",    "DELTOOLENV", "TOOLENV",  "TCARR",     "TCOABS",
    "TCOFR",      "TCOFRX",    "TCOFRY",    "TCOFRZ",    "TCI",      "TCA",        "MVTOOL",   "NEWCONF",   "CUTMOD",
    "CUTMODK",    "PREC",      "STOPREOF",  "RDISABLE",  "INITIAL",  "OVERSTORE",  "LIFTFAST", "POLFA",     "POLF",
    "POLFMASK",   "POLFMLIN",  "POLFMIN",   "FXSOF",     "IPOBRKA",  "ADISPOSA",   "COARSEA",  "FINEA",     "IPOENDA",
    "AXCTSWE",    "AXCTSWED",  "PROTA",     "PROTD",     "PROTSET",  "NPROT",      "NPROTDEF", "CPROT",     "CPROTDEF",
    "CPDEF",      "CPDEL",     "CPLDEF",    "CPLDEL",    "CPON",     "CPOF",       "CPLON",    "CPLOF",     "TML",
    "AUXFUDEL",   "AUXFUDELG", "AUXFUMSEQ", "AUXFUSYNC", "ORIROTA",  "ORIROTR",    "ORIROTT",  "ORIROTC",   "ORIRESET",
    "SPLINEPATH", "POLYPATH"};

// Standard cycles: they move and are not read.
constexpr std::string_view kCycle[] = {
    "CYCLE60",   "CYCLE61",   "CYCLE62",   "CYCLE63",   "CYCLE64",   "CYCLE70",   "CYCLE71",   "CYCLE72",   "CYCLE76",
    "CYCLE77",   "CYCLE78",   "CYCLE79",   "CYCLE90",   "CYCLE92",   "CYCLE93",   "CYCLE94",   "CYCLE96",   "CYCLE98",
    "CYCLE99",   "CYCLE435",  "CYCLE495",  "CYCLE800",  "CYCLE801",  "CYCLE802",  "CYCLE832",  "CYCLE899",  "CYCLE930",
    "CYCLE940",  "CYCLE950",  "CYCLE951",  "CYCLE952",  "CYCLE961",  "CYCLE971",  "CYCLE973",  "CYCLE974",  "CYCLE976",
    "CYCLE977",  "CYCLE978",  "CYCLE979",  "CYCLE982",  "CYCLE994",  "CYCLE995",  "CYCLE996",  "CYCLE997",  "CYCLE998",
    "CYCLE4071", "CYCLE4072", "CYCLE4073", "CYCLE4074", "CYCLE4075", "CYCLE4077", "CYCLE4078", "CYCLE4079", "POCKET1",
    "POCKET2",   "POCKET3",   "POCKET4",   "SLOT1",     "SLOT2",     "LONGHOLE"};

// Kept as they are written; they neither move nor change state: displays, files, blank declarations.
constexpr std::string_view kDisplay[] = {"WORKPIECE", "WRITE",  "READ",  "MMC",  "EXTOPEN",
                                         "EXTCLOSE",  "DELETE", "WAITP", "WAITS"};

// Words inside other statements and definitions.
constexpr std::string_view kAttribute[] = {
    "TO",    "OF",    "DEFAULT", "BLOCK", "SET",    "REP", "AS",  "SAVE", "VAR", "NCK", "CHAN", "SYNR", "SYNW", "SYNRW",
    "INIRE", "INIPO", "INICF",   "PRLOC", "CPRLOC", "LLI", "ULI", "PHU",  "APR", "APW", "APRP", "APWP", "APRB", "APWB"};

constexpr PlainNames kLists[] = {
    {Role::foreign, kForeign}, {Role::word_mode, kWordMode}, {Role::address, kAddress},     {Role::native, kNative},
    {Role::native, kCycle},    {Role::display, kDisplay},    {Role::attribute, kAttribute},
};

}  // namespace

std::span<const PlainNames> plain_names() { return kLists; }

}  // namespace dripfeed::sinumerik
