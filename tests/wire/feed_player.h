// Plays a dialog against a feed in virtual time, as a driver would: whole, byte by byte or at random splits.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>

#include "protocol/feed/feed.h"
#include "tests/wire/dialog.h"

namespace dripfeed::wire {

// A text that can be kept back or broken off by the dialog.
class StagedSource final : public tape_code::TextSource {
 public:
  explicit StagedSource(std::string text) : text_(std::move(text)) {}
  tape_code::TextPiece next() noexcept override;
  // Characters that next() may give; the rest is "not ready", or failed if broken is set.
  std::size_t ready = SIZE_MAX;
  bool broken = false;
  std::uint32_t rounds = 1;  // so often in all

 private:
  std::string text_;
  std::size_t given_ = 0;
};

// The facts of a text that must pass the check.
feed::ProgramFacts facts_of(const std::string& text, const feed::ProgramSyntax& syntax = feed::kParenthesesSyntax);

enum class Splits { whole, single_bytes, random };

class FeedPlayer {
 public:
  FeedPlayer(Splits splits, unsigned seed, std::set<std::size_t>* rows) : splits_(splits), random_(seed), rows_(rows) {}
  // Empty if all went as written, else what did not.
  std::string play(const Dialog& dialog);

 private:
  std::string step(const Step& step);
  std::string set(const std::string& rest);
  std::string expect_out(const std::string& rest);
  std::string late_write(const std::string& rest);
  std::string give_in(const std::string& rest);
  std::string pass_time(const std::string& rest);
  std::string expect_event(const std::string& rest);
  std::string command(const std::string& rest);
  std::string one_command(const std::string& name, const std::string& argument);
  std::string check(const std::string& rest);
  std::string wire(const std::string& text) const;
  std::size_t piece(std::size_t most);
  feed::Feed& feed();
  void drain();

  Splits splits_;
  std::mt19937 random_;
  std::set<std::size_t>* rows_;
  feed::Settings settings_;
  std::string text_ = "%\nO1\nG1X1\nM30\n%\n";
  std::optional<feed::Feed> feed_;
  std::unique_ptr<StagedSource> source_;
  std::size_t ready_ = SIZE_MAX;
  feed::Time now_{1'000'000'000};
  std::deque<std::string> events_;
};

}  // namespace dripfeed::wire
