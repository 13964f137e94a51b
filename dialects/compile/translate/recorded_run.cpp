// Blocks come one by one and motions in batches, so both are kept with their ordinals and joined at the end.
#include "dialects/compile/translate/recorded_run.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "dialects/ir/called_cycle.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;

class Shapes {
 public:
  explicit Shapes(const ir::Program& program) : program_(program) {}

  std::vector<LineRange> run() {
    for (const ir::Statement& s : program_.statements) {
      if (s.kind == ir::StatementKind::block) of_block(program_.blocks[s.payload]);
      if (s.kind == ir::StatementKind::call) of_call(program_.calls[s.payload]);
    }
    return std::move(out_);
  }

 private:
  void of_block(const ir::Block& block) {
    if (std::ranges::find(program_.codes_of(block), Function::repetitive_cycle, &ir::Code::function) ==
        program_.codes_of(block).end())
      return;
    add(line_of(number(block, Address::p)), line_of(number(block, Address::q)));
  }

  // "BEGIN:END"
  void of_call(const ir::Call& call) {
    if (!ir::runs_contour(call)) return;
    const ir::ExpressionId id = ir::value_of(program_, call, ir::CycleValue::contour);
    if (id == ir::ExpressionId::none || program_.at(id).op != ir::Operator::string) return;
    const std::string_view name = program_.strings.at(program_.at(id).string);
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos) return;
    add(line_of(name.substr(0, colon)), line_of(name.substr(colon + 1)));
  }

  [[nodiscard]] std::optional<std::uint32_t> number(const ir::Block& block, Address address) const {
    const auto words = program_.words_of(block);
    const auto word = std::ranges::find(words, address, &ir::Word::address);
    if (word == words.end() || word->value == ir::ExpressionId::none) return std::nullopt;
    const ir::Expression& e = program_.at(word->value);
    if (e.op != ir::Operator::constant || !(e.value >= 0.0 && e.value < 1e9)) return std::nullopt;
    return static_cast<std::uint32_t>(e.value);
  }

  [[nodiscard]] std::uint32_t line_of(std::optional<std::uint32_t> number) const {
    const auto label = std::ranges::find_if(program_.labels, [&](const ir::Label& l) {
      return number && l.name == ir::StringId::none && l.number == *number;
    });
    return label == program_.labels.end() ? 0 : program_.statements[label->statement].line;
  }
  [[nodiscard]] std::uint32_t line_of(std::string_view name) const {
    const auto label = std::ranges::find_if(program_.labels, [&](const ir::Label& l) {
      return l.name != ir::StringId::none && text::upper_case(program_.strings.at(l.name)) == text::upper_case(name);
    });
    return label == program_.labels.end() ? 0 : program_.statements[label->statement].line;
  }

  void add(std::uint32_t first, std::uint32_t last) {
    const auto same = [&](const LineRange& r) { return r.first == first && r.last == last; };
    if (first != 0 && last >= first && std::ranges::none_of(out_, same)) out_.push_back({first, last});
  }

  const ir::Program& program_;
  std::vector<LineRange> out_;
};

class Recorder final : public ir::MotionSink, public interpreter::BlockObserver {
 public:
  Recorder(const std::vector<LineRange>& shapes, const std::vector<std::uint32_t>& owners)
      : shapes_(shapes), owners_(owners), plain_(shapes.size()) {}

  void block(const ir::Place& place, std::span<const interpreter::VariableChange>) override {
    // The blocks of a cycle that the control brings along have the line of its call.
    const bool goes_on = in_owner_ && place.line == line_;
    if (place.program == 0 && !goes_on && !belongs_to_owner(place.line)) {
      line_ = place.line;
      in_owner_ = std::ranges::find(owners_, line_) != owners_.end();
      begun_.push_back({line_, place.ordinal});
    }
  }
  void consume(std::span<const ir::Motion> motions) override {
    if (motions_.size() + motions.size() <= kKeptMotions)
      motions_.insert(motions_.end(), motions.begin(), motions.end());
    else
      is_whole_ = false;
  }

  RecordedRun take(interpreter::RunResult result) {
    RecordedRun out;
    out.is_whole = is_whole_;
    std::size_t at = 0;
    for (std::size_t i = 0; i < begun_.size(); ++i) {
      Visit visit{.line = begun_[i].line, .first_motion = at, .motion_count = 0};
      const bool is_last = i + 1 == begun_.size();
      while (at < motions_.size() && (is_last || motions_[at].place.ordinal < begun_[i + 1].ordinal)) ++at;
      visit.motion_count = at - visit.first_motion;
      out.visits.push_back(visit);
    }
    out.motions = std::move(motions_);
    out.plain_shapes = std::move(plain_);
    out.result = std::move(result);
    return out;
  }

 private:
  struct Begun {
    std::uint32_t line;
    std::uint64_t ordinal;
  };

  bool belongs_to_owner(std::uint32_t line) {
    bool in_shape = false;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      if (!shapes_[i].has(line)) continue;
      in_shape = true;
      if (!in_owner_) plain_[i] = true;
    }
    return in_shape && in_owner_;
  }

  const std::vector<LineRange>& shapes_;
  const std::vector<std::uint32_t>& owners_;
  std::vector<bool> plain_;
  std::uint32_t line_ = 0;
  bool in_owner_ = false;
  bool is_whole_ = true;
  std::vector<Begun> begun_;
  std::vector<ir::Motion> motions_;
};

}  // namespace

std::vector<LineRange> shapes_of(const ir::Program& program) { return Shapes(program).run(); }

std::set<std::uint8_t> skip_levels(const ir::Program& program) {
  std::set<std::uint8_t> out;
  for (const ir::Statement& s : program.statements) {
    out.insert(s.skip_level);
    if (s.kind == ir::StatementKind::block) out.insert(program.blocks[s.payload].rest_level);
  }
  out.erase(0);
  return out;
}

RecordedRun record(const ir::Program& program, const ir::Control& control, interpreter::ProgramFinder& finder,
                   const interpreter::RunOptions& options, const std::vector<LineRange>& shapes,
                   const std::vector<std::uint32_t>& owners) {
  Recorder recorder(shapes, owners);
  interpreter::RunOptions own = options;
  own.observer = &recorder;
  interpreter::RunResult result = interpreter::run(program, control, finder, recorder, own);
  return recorder.take(std::move(result));
}

}  // namespace dripfeed::compile
