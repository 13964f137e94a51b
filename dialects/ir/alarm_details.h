// Further values of AlarmDetail: which of several alarms a control has for what types, arguments and indices do wrong.
// The interpreter and readers give them, and a control's table answers them.
#pragma once

#include "dialects/ir/control.h"

namespace dripfeed::ir {

inline constexpr AlarmDetail kValueOfWord{100};      // a word's type, not a variable's
inline constexpr AlarmDetail kPassedValue{101};      // … an argument's
inline constexpr AlarmDetail kPassedReference{102};  // … of an argument that must be a variable
inline constexpr AlarmDetail kToCharacter{103};      // a text where a CHAR is needed
inline constexpr AlarmDetail kToAxis{104};           // … where the name of an axis is
inline constexpr AlarmDetail kToNumber{105};         // … where a number is
inline constexpr AlarmDetail kTooManyPassed{106};    // arguments
inline constexpr AlarmDetail kLeftOut{107};          // an argument that has no default
inline constexpr AlarmDetail kFirstIndex{108};       // of an array or of variables by number
inline constexpr AlarmDetail kSecondIndex{109};
inline constexpr AlarmDetail kPasses{110};          // how often a program runs
inline constexpr AlarmDetail kJoined{111};          // texts put together
inline constexpr AlarmDetail kNegative{112};        // a feed
inline constexpr AlarmDetail kNameOfVariable{113};  // [#NAME] with what no name begins with
inline constexpr AlarmDetail kNoHoles{114};         // a hole pattern without a number of them
inline constexpr AlarmDetail kNoSpacing{115};       // … without the angle between them
inline constexpr AlarmDetail kForeignWord{116};     // … with a word that it does not take

}  // namespace dripfeed::ir
