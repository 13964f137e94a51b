// Block by block: which number it gets, then every place that names it, then both at once in the text.
#include "dialects/compile/renumber/renumber.h"

#include <algorithm>
#include <map>
#include <ranges>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/renumber/block_references.h"
#include "dialects/ir/repetition.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;
using ir::TokenKind;

constexpr std::uint32_t kHighest = 99'999;  // that each of the controls takes

std::string apply(std::string_view text, std::vector<text::Edit>& edits) {
  std::ranges::stable_sort(edits, {}, [](const text::Edit& one) { return one.replaced.begin; });
  std::string out;
  std::uint32_t at = 0;
  for (const text::Edit& one : edits) {
    out += text.substr(at, one.replaced.begin - at);
    out += one.text;
    at = one.replaced.end;
  }
  out += text.substr(at);
  return out;
}

// Which program of the text a statement is in, by that program's first statement.
std::uint32_t section_of(const ir::Program& program, std::uint32_t statement) {
  const auto after =
      std::ranges::upper_bound(program.sections, statement, {}, [](const ir::Section& one) { return one.first; });
  return after == program.sections.begin() ? 0 : std::prev(after)->first;
}

// By program and number: the first statement of the block.
using Targets = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;

Targets targets_of(const ir::Program& program) {
  Targets targets;
  for (const ir::Label& label : program.labels)
    if (label.name == ir::StringId::none)
      targets.try_emplace({section_of(program, label.statement), label.number}, label.statement);
  return targets;
}

// The numbers of one program of the text, before and after.
using NewNumbers = std::map<std::uint32_t, std::uint32_t>;

class Renumbering {
 public:
  explicit Renumbering(const RenumberRequest& request)
      : request_(request),
        text_(request.source.text()),
        read_(find_dialect(request.control.dialect)->read(request.source, request.control)),
        program_(read_.program) {}

  Renumbered make() {
    if (refuse_errors()) return std::move(out_);
    references_ = block_references(program_);
    for (const UnclearReference& one : references_.unclear) refuse(one.statement, one.why);
    if (!out_.refused.empty()) return std::move(out_);
    std::vector<ir::Section> sections = program_.sections;
    if (sections.empty())
      sections.push_back({.first = 0, .last = static_cast<std::uint32_t>(program_.statements.size())});
    for (const ir::Section& section : sections) number(section);
    if (!out_.refused.empty()) return std::move(out_);
    finish();
    return std::move(out_);
  }

 private:
  bool refuse_errors() {
    for (const text::Diagnostic& one : read_.diagnostics) {
      if (one.severity != text::Severity::error) continue;
      out_.refused.push_back(
          {request_.source.position(one.span.begin).line, "the line has an error: " + text::message_of(one)});
      return true;
    }
    return false;
  }

  void refuse(std::uint32_t statement, std::string why) {
    out_.refused.push_back({program_.statements[statement].line, std::move(why)});
  }

  void number(const ir::Section& section) {
    const auto is_here = [&](const auto& one) {
      return one.statement >= section.first && one.statement < section.last;
    };
    std::map<std::uint32_t, std::uint32_t> named;  // by number: how many blocks have it
    for (const ir::Label& label : program_.labels | std::views::filter(is_here))
      if (label.name == ir::StringId::none) ++named[label.number];
    std::set<std::uint32_t> referenced;
    for (const BlockReference& one : references_.known | std::views::filter(is_here)) {
      referenced.insert(one.number);
      if (!named.contains(one.number))
        refuse(one.statement, fmt::format("it names N{}, which no block has", one.number));
      else if (named[one.number] > 1)
        refuse(one.statement, fmt::format("it names N{}, which several blocks have", one.number));
    }
    if (!out_.refused.empty()) return;
    NewNumbers renamed;
    next_ = request_.first;
    for (std::uint32_t i = section.first; i < section.last; ++i)
      if (ir::begins_block(program_, i)) number_block(i, referenced, renamed);
    for (const BlockReference& one : references_.known | std::views::filter(is_here)) {
      edits_.push_back({one.span, fmt::format("{}", renamed.at(one.number))});
      ++out_.references;
    }
  }

  void number_block(std::uint32_t statement, const std::set<std::uint32_t>& referenced, NewNumbers& renamed) {
    const ir::Label* label = label_of(statement);
    if (label == nullptr) {
      if (request_.numbering != Numbering::all || !may_have_number(statement)) return;
      insert(statement);
    } else if (request_.numbering == Numbering::none && !referenced.contains(label->number)) {
      remove(label->span);
      return;
    } else {
      renamed[label->number] = next_;
      edits_.push_back({digits_of(text_, label->span), fmt::format("{}", next_)});
    }
    if (next_ > kHighest)
      return refuse(statement, fmt::format("N{} would be more than {}: a smaller step is needed", next_, kHighest));
    ++out_.numbers;
    next_ += request_.step;
  }

  [[nodiscard]] const ir::Label* label_of(std::uint32_t statement) const {
    const auto first =
        std::ranges::lower_bound(program_.labels, statement, {}, [](const ir::Label& one) { return one.statement; });
    for (auto label = first; label != program_.labels.end() && label->statement == statement; ++label)
      if (label->name == ir::StringId::none) return &*label;
    return nullptr;
  }

  // A line without a block has none, nor has the head of a program.
  [[nodiscard]] bool may_have_number(std::uint32_t statement) const {
    const StatementKind kind = program_.statements[statement].kind;
    return kind != StatementKind::empty && kind != StatementKind::procedure && kind != StatementKind::declaration &&
           kind != StatementKind::define;
  }

  void insert(std::uint32_t statement) {
    const ir::TokenRange range = program_.statements[statement].tokens;
    for (std::uint32_t t = range.first; t < range.last; ++t) {
      const ir::Token& token = program_.tokens[t];
      if (token.kind == TokenKind::white || token.kind == TokenKind::skip) continue;
      edits_.push_back({{token.span.begin, token.span.begin}, fmt::format("N{} ", next_)});
      return;
    }
  }

  void remove(text::Span label) {
    while (label.end < text_.size() && text_[label.end] == ' ') ++label.end;
    edits_.push_back({label, {}});
  }

  void finish() {
    std::string made = apply(text_, edits_);
    const text::Source source(request_.source.name(), made);
    const ir::ReadResult read = find_dialect(request_.control.dialect)->read(source, request_.control);
    if (!is_same(read.program)) return out_.refused.push_back({0, "the text that would come out is another program"});
    out_.text = std::move(made);
    if (references_.calls_others)
      out_.assumptions.emplace_back("the programs that it calls name no block of it (M99 P, RET, GOTO of the caller)");
  }

  // Apart from block numbers and what names them; and what named a block names the same one.
  [[nodiscard]] bool is_same(const ir::Program& made) const {
    const auto codes = [](const ir::Code& one) { return std::tuple(one.function, one.argument, one.letter); };
    const auto words = [](const ir::Word& one) { return std::tuple(one.address, one.extension, one.mode); };
    const auto kinds = [](const ir::Statement& one) { return std::tuple(one.kind, one.skip_level, one.line); };
    return std::ranges::equal(made.statements, program_.statements, {}, kinds, kinds) &&
           std::ranges::equal(made.codes, program_.codes, {}, codes, codes) &&
           std::ranges::equal(made.words, program_.words, {}, words, words) && has_same_values(made) &&
           has_same_targets(made);
  }

  [[nodiscard]] bool has_same_values(const ir::Program& made) const {
    return std::ranges::equal(program_.expressions, made.expressions, [&](const auto& a, const auto& b) {
      return a.op == b.op && (a.op != ir::Operator::constant || a.value == b.value || is_reference(a.span));
    });
  }

  [[nodiscard]] bool is_reference(text::Span span) const {
    const auto found = std::ranges::lower_bound(references_.known, span.begin, {},
                                                [](const BlockReference& one) { return one.span.begin; });
    return found != references_.known.end() && found->span.end <= span.end;
  }

  [[nodiscard]] bool has_same_targets(const ir::Program& made) const {
    const BlockReferences again = block_references(made);
    const Targets before = targets_of(program_);
    const Targets after = targets_of(made);
    return std::ranges::equal(references_.known, again.known, [&](const auto& a, const auto& b) {
      const auto to = before.find({section_of(program_, a.statement), a.number});
      const auto now = after.find({section_of(made, b.statement), b.number});
      return a.statement == b.statement && to != before.end() && now != after.end() && to->second == now->second;
    });
  }

  const RenumberRequest& request_;
  std::string_view text_;
  ir::ReadResult read_;
  const ir::Program& program_;
  BlockReferences references_;
  std::vector<text::Edit> edits_;
  std::uint32_t next_ = 0;
  Renumbered out_;
};

}  // namespace

Renumbered renumber(const RenumberRequest& request) { return Renumbering(request).make(); }

}  // namespace dripfeed::compile
