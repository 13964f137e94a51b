// The check of a text before it may be fed: where '%' stands, and whether the last block ends the program.
#include "protocol/feed/program_check.h"

#include <algorithm>
#include <utility>

namespace dripfeed::feed {
namespace {

constexpr std::array<std::pair<ProgramFault, std::string_view>, 10> kMessages{{
    {ProgramFault::empty, "the text is empty"},
    {ProgramFault::no_start_percent, "the text does not begin with '%': a control skips all before the first EOB"},
    {ProgramFault::no_final_percent, "the text does not end with '%'"},
    {ProgramFault::percent_in_comment, "'%' in a comment or string ends the reading there"},
    {ProgramFault::percent_inside, "'%' ends the reading before the end of the text"},
    {ProgramFault::percent_not_block_start, "the final '%' follows a block that has no EOB"},
    {ProgramFault::text_after_percent, "text follows the final '%'"},
    {ProgramFault::no_end_code, "the last block does not end the program (M30, M02)"},
    {ProgramFault::no_final_eob, "the last block has no EOB"},
    {ProgramFault::comment_open, "a comment is not closed in its block"},
}};

// Numbers of M codes are short; more digits are no end code.
constexpr std::uint32_t kNoCode = 1'000'000;

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

std::string_view message(ProgramFault fault) {
  for (const auto& [key, text] : kMessages) {
    if (key == fault) return text;
  }
  return {};
}

void ProgramCheck::refuse(ProgramFault fault, const Place& place) {
  if (!refusal_) refusal_ = ProgramRefusal{.fault = fault, .line = place.line, .column = place.column};
}

void ProgramCheck::append(std::span<const char> text) {
  for (const char character : text) put(character);
}

void ProgramCheck::put(char character) {
  if (character == '\n') {
    odd_blocks_ += at_.column % 2;  // the column of the EOB is the number of characters
    end_block();
  } else if (character == '%') {
    put_percent();
  } else {
    if (!begun_ && syntax_.start_percent) refuse(ProgramFault::no_start_percent, at_);
    if (percent_) refuse(ProgramFault::text_after_percent, at_);
    begun_ = true;
    block_.any = true;
    if (in_comment_) {
      put_in_comment(character);
    } else {
      put_code(character);
    }
  }
  before_ = character;
  ++at_.offset;
  if (character == '\n') {
    ++at_.line;
    at_.column = 1;
  } else {
    ++at_.column;
  }
}

void ProgramCheck::put_percent() {
  if (in_comment_ || in_string_) refuse(ProgramFault::percent_in_comment, at_);
  end_word();
  if (!begun_) {
    block_.skipped_by_reader = true;
  } else {
    if (percent_) refuse(ProgramFault::percent_inside, *percent_);
    if (block_.any) refuse(ProgramFault::percent_not_block_start, at_);
    percent_ = at_;
    odd_blocks_at_percent_ = odd_blocks_;
  }
  begun_ = true;
  block_.any = true;
}

void ProgramCheck::put_in_comment(char character) {
  if (character == comment_close_) in_comment_ = false;
}

bool ProgramCheck::opens_comment(char character) {
  for (const CommentStyle& style : syntax_.comments) {
    if (style.open != 0 && style.open == character) {
      in_comment_ = true;
      comment_close_ = style.close;
      return true;
    }
  }
  return false;
}

void ProgramCheck::put_code(char character) {
  if (in_string_) {
    in_string_ = character != '"';
    return;
  }
  if (opens_comment(character)) return end_word();
  if (is_blank(character)) {
    if (word_ == Word::digits) end_word();
    return;
  }
  if (character == '/' && !block_.code) {
    block_.optional = true;
    return;
  }
  // An N word alone is not a code; one at the block's beginning is passed over.
  if (!block_.code && (character == 'N' || character == 'n') && !block_.label) {
    block_.label = true;
    return;
  }
  if (block_.label && !block_.code && is_digit(character)) return;
  block_.code = true;
  last_code_ = at_;
  if (syntax_.quoted_strings && character == '"') {
    in_string_ = true;
    return end_word();
  }
  put_in_word(character);
}

// An M word counts as an end code when it stands by itself: M30, M02, M2 - not M30.1, M2=3 or the end of a longer name,
// and not after a '/', which makes it optional.
void ProgramCheck::put_in_word(char character) {
  if (is_digit(character) && word_ != Word::none) {
    number_ = std::min(number_ * 10 + static_cast<std::uint32_t>(character - '0'), kNoCode);
    word_ = Word::digits;
    return;
  }
  const bool continues = character == '.' || character == '=' || character == '[' || character == '_' ||
                         (syntax_.long_names && is_letter(character));
  if (word_ == Word::digits && !continues) end_word();
  word_ = Word::none;
  const bool starts_word = !is_letter(before_) && before_ != '_' && before_ != '/' && before_ != '=';
  if ((character == 'M' || character == 'm') && starts_word) {
    word_ = Word::m_seen;
    number_ = 0;
  }
}

void ProgramCheck::end_word() {
  if (word_ == Word::digits && number_ != 0 &&
      std::ranges::find(syntax_.end_codes, number_) != syntax_.end_codes.end()) {
    block_.ends_program = true;
  }
  word_ = Word::none;
}

void ProgramCheck::end_block() {
  end_word();
  if (in_comment_ && comment_close_ != '\n') refuse(ProgramFault::comment_open, at_);
  in_comment_ = false;
  in_string_ = false;
  if (block_.code && !block_.skipped_by_reader) last_block_ends_program_ = block_.ends_program && !block_.optional;
  block_ = {};
  ++eobs_;
}

std::expected<ProgramFacts, ProgramRefusal> ProgramCheck::finish() {
  const bool inside_block = block_.any && !(percent_ && percent_->line == at_.line);
  const std::uint64_t eobs = eobs_;
  if (inside_block) end_block();
  if (!begun_) refuse(ProgramFault::empty, at_);
  if (syntax_.final_percent && !percent_) refuse(ProgramFault::no_final_percent, at_);
  if (inside_block) refuse(ProgramFault::no_final_eob, at_);
  if (syntax_.end_code && !last_block_ends_program_) refuse(ProgramFault::no_end_code, last_code_);
  if (refusal_) return std::unexpected(*refusal_);
  ProgramFacts facts;
  facts.text_bytes_ = at_.offset;
  facts.eobs_ = eobs;
  facts.program_bytes_ = percent_ ? percent_->offset + 1 : at_.offset;
  facts.program_eobs_ = percent_ ? percent_->line - 1 : eobs;
  facts.odd_blocks_ = odd_blocks_;
  facts.program_odd_blocks_ = percent_ ? odd_blocks_at_percent_ : odd_blocks_;
  return facts;
}

}  // namespace dripfeed::feed
