// The end of block (EOB): how it is written on the wire, and how any of its forms is read back as one LF. Line numbers
// everywhere are the 1-based count of these.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace dripfeed::tape_code {

// The characters that end a block on the wire, without parity: one of the usual four, or 1 to 4 control characters that
// a shop chose.
class Eob {
 public:
  static constexpr std::size_t kMaxCharacters = 4;

  constexpr Eob() : Eob("\n") {}
  static const Eob lf, cr_lf, lf_cr_cr, cr;

  constexpr std::string_view characters() const { return {characters_.data(), size_}; }
  friend constexpr bool operator==(const Eob&, const Eob&) = default;

 private:
  friend std::optional<Eob> parse_eob(std::string_view name);
  constexpr explicit Eob(std::string_view characters) : size_(static_cast<std::uint8_t>(characters.size())) {
    std::copy(characters.begin(), characters.end(), characters_.begin());
  }

  std::array<char, kMaxCharacters> characters_{};
  std::uint8_t size_ = 0;
};
inline constexpr Eob Eob::lf{"\n"};
inline constexpr Eob Eob::cr_lf{"\r\n"};
inline constexpr Eob Eob::lf_cr_cr{"\n\r\r"};
inline constexpr Eob Eob::cr{"\r"};

constexpr std::string_view characters(const Eob& eob) { return eob.characters(); }
std::string_view characters(const Eob&& eob) = delete;  // the view would outlive it

// "LF", "CR LF", "LF CR CR", "CR", or any 1 to 4 of LF, CR and two hex digits with a blank between: "CR LF LF", "1E".
// Only control characters that mean nothing else on a line: not NUL, DC1 to DC4, NAK or SYN. Other names give nothing.
std::optional<Eob> parse_eob(std::string_view name);
std::string name(const Eob& eob);

// Turns LF, CR LF, CR and LF CR CR into one LF each, character by character. A CR is held back until what follows it is
// known, so at most one EOB is pending; finish() gives it. A reader that is given another EOB knows that one, too.
class EobReader {
 public:
  EobReader() = default;
  explicit EobReader(const Eob& own) : own_(own) {}

  // Appends what is known after this character: nothing, or up to kMaxPut characters.
  void put(char character, std::string& out);
  void finish(std::string& out);
  static constexpr std::size_t kMaxPut = 2 * Eob::kMaxCharacters;

 private:
  enum class Seen : std::uint8_t { plain, cr, lf, lf_cr };
  void put_usual(char character, std::string& out);
  void finish_usual(std::string& out);

  Seen seen_ = Seen::plain;
  Eob own_;
  std::array<char, Eob::kMaxCharacters> held_{};  // the beginning of own_, as far as it came
  std::size_t held_count_ = 0;
};

}  // namespace dripfeed::tape_code
