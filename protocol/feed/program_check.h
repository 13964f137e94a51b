// May this text be drip-fed at all? Checks, piece by piece, what the reading of a tape depends on: '%' first and last
// and nowhere else, an end code in the last block. Only a text that passed yields ProgramFacts, and only with these the
// feed can be armed. What the program does is the checks' business, not this file's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string_view>

namespace dripfeed::feed {

// A comment of the dialect: '(' to ')', or ';' to the end of the block (close is LF then). open 0: no such comment.
struct CommentStyle {
  char open = 0;
  char close = '\n';
};

// What the check needs to know of the dialect, as data.
struct ProgramSyntax {
  std::array<CommentStyle, 2> comments{CommentStyle{'(', ')'}, CommentStyle{}};
  bool quoted_strings = false;                          // "..." hides codes and comment signs
  bool long_names = false;                              // names of several letters and digits exist, so M30A is no M30
  std::array<std::uint16_t, 4> end_codes{30, 2, 0, 0};  // M codes that end a program; 0 = unused
  bool start_percent = true;  // the text must begin with '%' (what precedes is skipped by controls)
  bool final_percent = true;  // the text must end with '%'
  bool end_code = true;       // the last block must hold an end code (off for a memory load)
};

// Ready-made: comments in parentheses and M30, M02; comments after ';' and M30, M2, M17 with strings.
inline constexpr ProgramSyntax kParenthesesSyntax{};
inline constexpr ProgramSyntax kSemicolonSyntax{.comments = {CommentStyle{';', '\n'}, CommentStyle{}},
                                                .quoted_strings = true,
                                                .long_names = true,
                                                .end_codes = {30, 2, 17, 0}};

enum class ProgramFault : std::uint8_t {
  empty,
  no_start_percent,         // something other than '%' comes first
  no_final_percent,         // fewer '%' than the reading needs
  percent_in_comment,       // '%' inside a comment (or string) ends the reading there
  percent_inside,           // '%' between the first and the last one
  percent_not_block_start,  // the block before the final '%' has no EOB
  text_after_percent,       // something other than EOBs follows the final '%'
  no_end_code,              // the last block does not end the program
  no_final_eob,             // the last block has no EOB and no '%' follows
  comment_open,             // a comment in parentheses has no end in its block
};
std::string_view message(ProgramFault fault);

struct ProgramRefusal {
  ProgramFault fault = ProgramFault::empty;
  std::uint64_t line = 1;    // 1-based count of EOBs
  std::uint64_t column = 1;  // 1-based byte
};

// What is known of a text that passed. Only ProgramCheck makes one.
class ProgramFacts {
 public:
  std::uint64_t text_bytes() const { return text_bytes_; }
  std::uint64_t eobs() const { return eobs_; }
  // Characters up to and with the final '%' (or the whole text where no '%' is due): once they are out, the program is.
  std::uint64_t program_bytes() const { return program_bytes_; }
  // EOBs among these.
  std::uint64_t program_eobs() const { return program_eobs_; }
  // Blocks that have an odd number of characters, EOB counted as one, in the text and in the program.
  std::uint64_t odd_blocks() const { return odd_blocks_; }
  std::uint64_t program_odd_blocks() const { return program_odd_blocks_; }

 private:
  friend class ProgramCheck;
  ProgramFacts() = default;
  std::uint64_t text_bytes_ = 0;
  std::uint64_t eobs_ = 0;
  std::uint64_t program_bytes_ = 0;
  std::uint64_t program_eobs_ = 0;
  std::uint64_t odd_blocks_ = 0;
  std::uint64_t program_odd_blocks_ = 0;
};

// Text with LF as EOB, in any pieces.
class ProgramCheck {
 public:
  explicit ProgramCheck(const ProgramSyntax& syntax) : syntax_(syntax) {}
  void append(std::span<const char> text);
  std::expected<ProgramFacts, ProgramRefusal> finish();

 private:
  struct Place {
    std::uint64_t line = 1;
    std::uint64_t column = 1;
    std::uint64_t offset = 0;
  };
  enum class Word : std::uint8_t { none, m_seen, digits };

  void put(char character);
  void put_percent();
  void put_in_comment(char character);
  void put_code(char character);
  void put_in_word(char character);
  void end_word();
  void end_block();
  bool opens_comment(char character);
  void refuse(ProgramFault fault, const Place& place);

  ProgramSyntax syntax_;
  Place at_;
  std::uint64_t eobs_ = 0;
  std::uint64_t odd_blocks_ = 0;             // with an odd number of characters
  std::uint64_t odd_blocks_at_percent_ = 0;  // of these before the final '%'
  std::optional<ProgramRefusal> refusal_;
  bool begun_ = false;            // a character other than EOB was seen
  std::optional<Place> percent_;  // a '%' after the first character: the final one, if nothing follows
  bool in_comment_ = false;
  char comment_close_ = 0;
  bool in_string_ = false;

  // The present block.
  struct Block {
    bool any = false;                // holds any character
    bool skipped_by_reader = false;  // begins with the first '%': controls skip it up to its EOB
    bool label = false;              // is inside its N word
    bool code = false;               // holds something to act on besides the N word
    bool optional = false;           // begins with '/', so it may be left out
    bool ends_program = false;       // holds an end code
  };
  Block block_;
  bool last_block_ends_program_ = false;
  Place last_code_;

  Word word_ = Word::none;
  char before_ = '\n';  // the character before the present one
  std::uint32_t number_ = 0;
};

}  // namespace dripfeed::feed
