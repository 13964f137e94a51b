// The name that a received program gives itself, by a table of the controls' methods, and the programs of one punch.
// Names are not judged: what may be stored or asked for under a name is the caller's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dripfeed::receive {

enum class NameStyle : std::uint8_t {
  okuma,       // $O1234.MIN%
  sinumerik,   // %_N_SHAFT_MPF, its folder in ;$PATH=
  fagor,       // %name,MX,
  heidenhain,  // 0 BEGIN PGM name MM
  header,      // %MPF123, %1234
  number,      // O1234, :1234
  angle,       // <NAME>
  comment,     // the first comment, where nothing else is
};
std::string_view name(NameStyle style);

struct ProgramName {
  NameStyle style = NameStyle::number;
  std::string name;
  std::string path;  // sinumerik: "/_N_WKS_DIR/_N_SPIGOT_WPD"
};

// Lines that are looked at.
inline constexpr std::size_t kNameLines = 10;

// Text with LF as EOB. Nothing when it gives itself no name.
std::optional<ProgramName> find_name(std::string_view text);

// The first comment of the text, in parentheses or after ';', within so many lines; "" without one.
std::string_view first_comment(std::string_view text, std::size_t lines);

// The programs of one punch: several between pairs of '%' part at their O numbers, an archive at its %_N_ headers.
// One program is the text itself; so is a text with more after a '%' than programs.
std::vector<std::string> split_programs(std::string_view text);

}  // namespace dripfeed::receive
