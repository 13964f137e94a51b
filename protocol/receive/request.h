// What an operator asks for by punching a small program: "%", "O9999 (LOAD 1234)", "%". The grammar alone: verbs,
// arguments and where they may stand. What may be given, and how it is answered, is the server's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace dripfeed::receive {

enum class Verb : std::uint8_t {
  load,     // (LOAD 1234), (PRG=1234), (GET name): for the control's memory
  drip,     // (DNC name), (DRIP name)
  dir,      // (DIR), (DIR mask)
  save,     // (SAVE name): the program itself is what is sent
  cancel,   // (CANCEL)
  status,   // (STATUS)
  restart,  // (RESTART name N500): known and refused
  parts,    // (PARTS 5): good parts that were made since the last such message
  scrap,    // (SCRAP 1): the others
};
std::string_view name(Verb verb);

struct RequestGrammar {
  std::uint32_t program_number = 9999;  // the O number of a request; 0: any program's first comment is looked at
  std::string marker{};                 // for controls with names: a request's name holds it; empty: the number
  std::size_t scan_lines = 5;
};

struct Request {
  Verb verb = Verb::load;
  std::string argument;    // upper case, without spaces; "" where none was given
  bool legal = true;       // the argument has only A-Z 0-9 _ . - (and * ? in a mask), and is no longer than 32
  std::string as_written;  // the comment
};

// Nothing when the text is an ordinary program.
std::optional<Request> find_request(std::string_view text, const RequestGrammar& grammar);

// Whether a name fits a mask of '*' and '?', letters of either case.
bool fits_mask(std::string_view name, std::string_view mask);

}  // namespace dripfeed::receive
