// Programs made from a seed, with what facts follow: for facts_oracle_test.cpp.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"

namespace dripfeed::compile::test {

// What a control writes for each thing that may be in effect.
struct Spelling {
  std::string_view dialect;
  ir::MachineKind kind;
  std::vector<std::string_view> lines;       // single blocks without flow
  std::vector<std::string_view> axis_words;  // of moves, {} is a number
  std::string_view snapshot;                 // a message
  bool has_names = false;                    // SINUMERIK
};

const std::vector<Spelling>& spellings();

class Generator {
 public:
  Generator(const Spelling& spelling, std::uint32_t seed) : spelling_(spelling), random_(seed) {}

  std::string straight(std::size_t statements);
  std::string branching(std::size_t statements);

 private:
  int below(int bound) { return static_cast<int>(random_() % static_cast<std::uint32_t>(bound)); }
  template <class T>
  const T& any(const std::vector<T>& of) {
    return of[static_cast<std::size_t>(below(static_cast<int>(of.size())))];
  }
  void line(std::string_view text);
  void begin();
  void end() { line("M30"); }
  // A number with one digit after the point or none: sums stay exact enough to compare.
  std::string number() { return std::to_string(below(40) - 20); }
  void plain();
  std::string condition();
  void piece(int depth);
  void body(int depth);
  void jump(int depth);
  void loop(int depth);
  void call();
  void subprogram(int number);

  const Spelling& spelling_;
  std::mt19937 random_;
  std::string text_;
  std::size_t made_ = 0;
  int labels_ = 0;
  bool in_subprogram_ = false;
};

}  // namespace dripfeed::compile::test
