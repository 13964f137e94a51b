// Which options are on, for us and for the other side. Answers only what changes something (RFC 1143), so that two ends
// never talk in circles; what is not in the list is refused.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "protocol/telnet/codes.h"
#include "protocol/telnet/output.h"

namespace dripfeed::telnet {

struct OptionRow {
  std::uint8_t option = 0;
  bool ours = false;    // we do it, when asked or by our own asking
  bool theirs = false;  // we let the other side do it
};

class Options {
 public:
  static constexpr std::size_t kMaxRows = 8;

  explicit Options(std::span<const OptionRow> rows);
  // Offers and asks for all of the list.
  void ask(Output& out);
  void receive(Verb verb, std::uint8_t option, Output& out);

  enum class Side : std::uint8_t { off, asked, on, refused };
  [[nodiscard]] Side ours(std::uint8_t option) const;
  [[nodiscard]] Side theirs(std::uint8_t option) const;

 private:
  struct Entry {
    OptionRow row;
    Side ours = Side::off;
    Side theirs = Side::off;
  };
  [[nodiscard]] const Entry* find(std::uint8_t option) const;

  std::array<Entry, kMaxRows> entries_{};
  std::size_t count_ = 0;
};

}  // namespace dripfeed::telnet
