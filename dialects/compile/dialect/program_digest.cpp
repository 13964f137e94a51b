// Block by block, over the reader's tokens. The blocks of a toolpath say little that anyone looks for and are most of
// a long text: beyond its beginning they are left out.
#include "dialects/compile/dialect/program_digest.h"

#include <algorithm>
#include <set>
#include <span>

#include <fmt/format.h>

#include "dialects/facts/calls.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;
using ir::TokenKind;

constexpr std::size_t kAllUpTo_bytes = std::size_t{64} * 1024;
constexpr std::size_t kMost_bytes = std::size_t{256} * 1024;
constexpr std::size_t kMostCalls = 1000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Length of the well-formed character that begins there; 0 where there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80U ? 1 : first < 0xC2U ? 0 : first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
  if (length == 0 || first > 0xF4U || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  const bool too_long = (first == 0xE0U && byte(1) < 0xA0U) || (first == 0xF0U && byte(1) < 0x90U);
  const bool none = (first == 0xEDU && byte(1) > 0x9FU) || (first == 0xF4U && byte(1) > 0x8FU);
  return too_long || none ? 0 : length;
}

class Digest {
 public:
  explicit Digest(const ir::ReadResult& read) : program_(read.program), text_(read.program.source.text()) {
    for (const text::Diagnostic& d : read.diagnostics)
      if (d.severity == text::Severity::error && out_.not_read.empty())
        out_.not_read = fmt::format("line {}: {}", program_.source.position(d.span.begin).line, text::message_of(d));
  }

  ProgramDigest run() {
    add_names();
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count;) {
      std::uint32_t last = i + 1;
      while (last < count && program_.statements[last].tokens.first == program_.statements[last].tokens.last) ++last;
      add_block(i, last);
      i = last;
    }
    out_.words = as_utf8(out_.words);
    out_.comments = as_utf8(out_.comments);
    return std::move(out_);
  }

 private:
  void add_names() {
    if (!program_.name.empty()) out_.names.push_back(program_.name);
    for (const ir::Section& section : program_.sections) {
      std::string name(program_.strings.at(section.name));
      if (!name.empty() && std::ranges::find(out_.names, name) == out_.names.end())
        out_.names.push_back(std::move(name));
    }
  }

  void add_block(std::uint32_t first, std::uint32_t last) {
    const ir::TokenRange range = program_.statements[first].tokens;
    const auto statements = std::span(program_.statements).subspan(first, last - first);
    for (const ir::Statement& s : statements) add_call(s);
    std::string words;
    bool apart = false;
    for (std::uint32_t i = range.first; i < range.last; ++i) {
      const ir::Token& token = program_.tokens[i];
      const std::string_view written = token.span.in(text_);
      if (token.kind == TokenKind::comment) {
        if (out_.comments.size() < kAllUpTo_bytes) out_.comments.append(written).append("\n");
        continue;
      }
      apart = apart || token.kind == TokenKind::white || token.kind == TokenKind::address;
      if (token.kind == TokenKind::white || token.kind == TokenKind::eob || token.kind == TokenKind::tape_mark)
        continue;
      if (apart && !words.empty()) words += ' ';
      words += written;
      apart = false;
    }
    if (words.empty()) return;
    const bool is_kept = out_.words.size() + words.size() < kAllUpTo_bytes ||
                         (!only_moves(statements) && out_.words.size() + words.size() < kMost_bytes);
    out_.is_cut = out_.is_cut || !is_kept;
    if (is_kept) out_.words.append(words).append("\n");
  }

  [[nodiscard]] bool only_moves(std::span<const ir::Statement> statements) const {
    if (statements.size() != 1 || statements.front().kind != StatementKind::block) return false;
    const ir::Block& block = program_.blocks[statements.front().payload];
    const auto moves = [](const ir::Code& c) { return c.group == ir::ModalGroup::motion; };
    const auto places = [](const ir::Word& w) {
      return ir::is_axis(w.address) || (w.address >= ir::Address::i && w.address <= ir::Address::k) ||
             w.address == ir::Address::f || w.address == ir::Address::r || w.address == ir::Address::arc_radius;
    };
    return std::ranges::all_of(program_.codes_of(block), moves) &&
           std::ranges::all_of(program_.words_of(block), places);
  }

  void add_call(const ir::Statement& s) {
    if (s.kind == StatementKind::execute_text) ++out_.computed_calls;
    if (s.kind != StatementKind::call && s.kind != StatementKind::modal_call) return;
    const ir::Call& call = program_.calls[s.payload];
    if (call.name == ir::StringId::none) {
      if (call.number != ir::ExpressionId::none || call.computed != ir::ExpressionId::none) ++out_.computed_calls;
      return;
    }
    if (facts::is_standard_cycle(program_, s)) return;
    DigestCall one{.name = call_key(program_.strings.at(call.name)), .kind = call.kind, .line = s.line};
    if (!reported_.insert(one.name + static_cast<char>('0' + static_cast<int>(one.kind))).second) return;
    if (out_.calls.size() < kMostCalls)
      out_.calls.push_back(std::move(one));
    else if (out_.not_read.empty())
      out_.not_read = fmt::format("line {}: it calls more than {} programs", s.line, kMostCalls);
  }

  const ir::Program& program_;
  std::string_view text_;
  std::set<std::string> reported_;
  ProgramDigest out_;
};

// "groove.spf", "O12.nc": an ending that files have.
std::string_view without_ending(std::string_view name) {
  constexpr std::size_t kLongestEnding = 4;
  const std::size_t point = name.rfind('.');
  if (point == std::string_view::npos || point == 0 || name.size() - point - 1 > kLongestEnding) return name;
  return name.substr(0, point);
}

}  // namespace

std::string call_key(std::string_view name) {
  std::string key = text::upper_case(without_ending(ir::program_name_of_path(name)));
  const std::string_view digits = key.starts_with('O') ? std::string_view(key).substr(1) : std::string_view(key);
  if (digits.empty() || !std::ranges::all_of(digits, is_digit)) return key;
  return "O" + std::string(digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1)));
}

std::string as_utf8(std::string_view bytes) {
  std::string out;
  out.reserve(bytes.size());
  while (!bytes.empty()) {
    const std::size_t length = character_length(bytes);
    if (length > 0) {
      if (bytes.front() != '\0') out.append(bytes.substr(0, length));
      bytes.remove_prefix(length);
      continue;
    }
    const auto byte = static_cast<unsigned char>(bytes.front());
    out += static_cast<char>(0xC0U | (byte >> 6U));
    out += static_cast<char>(0x80U | (byte & 0x3FU));
    bytes.remove_prefix(1);
  }
  return out;
}

ProgramDigest digest_of(const ir::ReadResult& read) { return Digest(read).run(); }

}  // namespace dripfeed::compile
