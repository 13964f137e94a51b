// What is known of one modal fact before one statement, on all control-flow paths that lead there: the value and which
// statement set it, a second value where paths disagree, and whether something whose effect is not in the text may have
// changed it.
#pragma once

#include <cstdint>

#include "dialects/ir/statement.h"

namespace dripfeed::facts {

// Who set a value: the index of a statement, or one of these.
inline constexpr std::uint32_t kNoStatement = ir::kNoIndex;
inline constexpr std::uint32_t kPowerOn = ir::kNoIndex - 1;
inline constexpr std::uint32_t kCaller = ir::kNoIndex - 2;  // stated for the caller, outside the program

template <class T>
struct Known {
  T value{};                            // what the first path brings, where `origin` is not kNobody
  std::uint32_t origin = kNoStatement;  // kNobody: no path sets it
  T other{};                            // what another path brings, where `other_origin` is not kNobody
  std::uint32_t other_origin = kNoStatement;
  // On some path a statement may have changed it to what is not known; kPowerOn: how it begins is not known.
  std::uint32_t changer = kNoStatement;
  bool inherited = false;    // on some path it is what a caller outside of the text has set
  bool more = false;         // paths bring a third value
  bool at_power_on = false;  // on some path nothing has stated it: it is as the control begins

  void set(const T& to, std::uint32_t by) { *this = Known{.value = to, .origin = by}; }
  void forget(std::uint32_t by) {
    if (changer == kNoStatement || changer == kPowerOn) changer = by;
  }
  void begin(const T& with) {
    set(with, kPowerOn);
    at_power_on = true;
  }
  void begin_unknown() {
    forget(kPowerOn);
    at_power_on = true;
  }
  // On some path it is as the control begins, and nothing unknown may have stated it since.
  [[nodiscard]] bool may_be_unstated() const { return at_power_on && (changer == kNoStatement || changer == kPowerOn); }
  // All paths of the text agree; what `changer` did is not looked at.
  [[nodiscard]] bool agrees() const { return origin != kNoStatement && other_origin == kNoStatement && !inherited; }
  [[nodiscard]] bool is_certain() const { return agrees() && changer == kNoStatement; }
  // nullptr where it is not certain.
  [[nodiscard]] const T* certain() const { return is_certain() ? &value : nullptr; }
  [[nodiscard]] bool is(const T& wanted) const { return is_certain() && value == wanted; }
  // It may be something else than `value` and `other`.
  [[nodiscard]] bool is_open() const { return inherited || more || changer != kNoStatement || origin == kNoStatement; }
  // Whether all paths of the text have brought a value of that kind; what `changer` did is not looked at.
  template <class Is>
  [[nodiscard]] bool is_always(Is&& is) const {
    return origin != kNoStatement && !inherited && !more && is(value) && (other_origin == kNoStatement || is(other));
  }
  // Whether it may be that value as far as is known.
  [[nodiscard]] bool may_be(const T& wanted) const {
    if (is_open()) return true;
    return value == wanted || (other_origin != kNoStatement && other == wanted);
  }

  // What is left where two paths join; true when that is less than before.
  bool join(const Known& with) {
    const Known old = *this;
    if (with.origin != kNoStatement) take(with.value, with.origin);
    if (with.other_origin != kNoStatement) take(with.other, with.other_origin);
    inherited |= with.inherited;
    more |= with.more;
    at_power_on |= with.at_power_on;
    if (changer == kNoStatement) changer = with.changer;
    return *this != old;
  }
  friend bool operator==(const Known&, const Known&) = default;

 private:
  void take(const T& incoming, std::uint32_t by) {
    if (origin == kNoStatement) {
      value = incoming;
      origin = by;
    } else if (incoming == value) {
      return;
    } else if (other_origin == kNoStatement) {
      other = incoming;
      other_origin = by;
    } else {
      more |= !(incoming == other);
    }
  }
};

}  // namespace dripfeed::facts
