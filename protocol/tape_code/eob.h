// The end of block (EOB): how it is written on the wire, and how any of its four forms is read back as one LF.
// Line numbers everywhere are the 1-based count of these.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace dripfeed::tape_code {

enum class Eob : std::uint8_t { lf, cr_lf, lf_cr_cr, cr };

// The characters of an EOB, without parity.
std::string_view characters(Eob eob);
// "LF", "CR LF", "LF CR CR", "CR", as a machine profile names them; any other name gives nothing.
std::optional<Eob> parse_eob(std::string_view name);
std::string_view name(Eob eob);

// Turns LF, CR LF, CR and LF CR CR into one LF each, character by character. A CR is held back until what follows it is
// known, so at most one EOB is pending; finish() gives it.
class EobReader {
 public:
  // Appends what is known after this character: nothing, the character, or one or two of LF and the character.
  void put(char character, std::string& out);
  void finish(std::string& out);

 private:
  enum class Seen : std::uint8_t { plain, cr, lf, lf_cr };
  Seen seen_ = Seen::plain;
};

}  // namespace dripfeed::tape_code
