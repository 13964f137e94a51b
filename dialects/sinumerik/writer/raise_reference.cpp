// The approach of the reference point (G28) as that of a fixed point of the machine, where the profile says which fixed
// point lies there; G74 is homing and not that move. G28's intermediate point becomes a rapid in front:
//
//   G91 G28 Z0 M9         G91 / G75 Z1=0 FP=1 / M9
//   G90 G28 X5. Y6.       G90 / G0 X5 Y6 / G75 X1=0 Y1=0 FP=1 / G1
//
// G1 where it was in effect before.
#include <algorithm>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "dialects/facts/flow_graph.h"
#include "dialects/facts/resolved.h"
#include "dialects/passes/rewrite.h"
#include "dialects/sinumerik/writer/raise.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;

bool is_reference(const ir::Code& c) { return c.function == Function::reference_return; }

class ReferenceRaiser {
 public:
  explicit ReferenceRaiser(const Raising& raising)
      : raising_(raising),
        program_(raising.program),
        letters_are_increments_(!raising.is_own() && raising.from.semantics.incremental_letters_uvw),
        modes_(program_, raising.from),
        out_(program_) {}

  void run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (index_ = 0; index_ < count; ++index_) {
      out_.at(index_);
      statement_ = program_.statements[index_];
      const bool has_block = statement_.payload != ir::kNoIndex &&
                             (statement_.kind == StatementKind::block || statement_.kind == StatementKind::program_end);
      if (has_block)
        block(program_.blocks[statement_.payload]);
      else
        out_.keep();
    }
    out_.finish();
  }

 private:
  static Function motion_of(std::span<const ir::Code> codes, Function before) {
    for (const ir::Code& c : codes) {
      if (c.number != ir::ExpressionId::none && c.letter == 'G') return Function::none;
      if (c.group == ir::ModalGroup::motion) return c.function;
    }
    return before;
  }
  // … where the block's own point is gone to.
  [[nodiscard]] Function motion_here(const std::vector<ir::Code>& codes) const {
    const std::optional<facts::Setting> before = modes_.certain(facts::Mode::motion, index_);
    return motion_of(codes, before ? before->function : Function::none);
  }

  // By value: the arenas grow.
  void block(const ir::Block block) {
    const std::vector<ir::Code> codes(program_.codes_of(block).begin(), program_.codes_of(block).end());
    const auto found = std::ranges::find_if(codes, is_reference);
    if (found == codes.end()) return out_.keep();
    if (const std::string fault = fault_of(*found, codes, block); !fault.empty()) {
      raising_.cannot(fault, found->span);
      return without_reference(codes, block);
    }
    approach(codes, block);
  }

  // What keeps the block from being said, or nothing.
  [[nodiscard]] std::string fault_of(const ir::Code& code, const std::vector<ir::Code>& codes,
                                     const ir::Block& block) const {
    const std::string written(raising_.text_of(code.span));
    std::string name = written.empty() ? std::string(ir::name_of(code.function)) : written;
    if (code.argument != 1) return name;
    if (raising_.to.semantics.reference_fixed_point == 0)
      return name + ", while control.reference_fixed_point of the machine is not stated,";
    if (block.rest_level != 0) return "block skip inside a block";
    if (statement_.kind == StatementKind::program_end) return name + " in the block that ends the program";
    // Whether it acts before the approach or after it is the machine builder's matter.
    const bool changes = std::ranges::any_of(codes, [](const ir::Code& c) {
      return c.function == Function::tool_change || c.function == Function::machine_function ||
             c.number != ir::ExpressionId::none;
    });
    const auto words = program_.words_of(block);
    if (changes || std::ranges::find(words, Address::t, &ir::Word::address) != words.end())
      return name + " in the same block as a tool or an M function of the machine";
    if (std::ranges::none_of(words, [&](const ir::Word& w) { return axis(w).has_value(); }))
      return name + " without axes";
    const Function motion = motion_here(codes);
    if (has_intermediate_point(codes, block) && motion != Function::rapid && motion != Function::linear)
      return "the intermediate point of " + name + " where neither G0 nor G1 is known to be in effect";
    return {};
  }

  void without_reference(const std::vector<ir::Code>& codes, const ir::Block& block) {
    std::vector<ir::Code> others;
    std::ranges::remove_copy_if(codes, std::back_inserter(others), is_reference);
    const std::vector<ir::Word> words(program_.words_of(block).begin(), program_.words_of(block).end());
    out_.emit_block(others, words);
    out_.last().kind = statement_.kind;
  }

  void approach(const std::vector<ir::Code>& codes, const ir::Block& block) {
    const bool goes_there = has_intermediate_point(codes, block);
    std::vector<ir::Code> before;
    std::vector<ir::Code> after;
    for (const ir::Code& c : codes)
      if (!is_reference(c)) (acts_after(c) ? after : before).push_back(c);
    std::vector<ir::Word> words;
    std::vector<ir::Word> axes;
    for (const ir::Word& w : program_.words_of(block)) {
      if (!axis(w) || goes_there) words.push_back(w);
      if (axis(w)) axes.push_back(machine_axis(*axis(w)));
    }
    const Function motion = motion_here(codes);
    const bool returns = goes_there && motion != Function::rapid;
    if (returns) std::erase_if(before, [](const ir::Code& c) { return c.group == ir::ModalGroup::motion; });
    if (returns) before.push_back(motion_code(Function::rapid));
    if (!before.empty() || !words.empty()) out_.emit_block(before, words);
    ir::Word point = ir::word(Address::other, number(raising_.to.semantics.reference_fixed_point));
    point.name = program_.strings.add("FP");
    axes.push_back(point);
    ir::Code code;
    code.function = Function::reference_return;
    code.argument = 1;
    code.group = ir::ModalGroup::non_modal;
    code.name = program_.strings.add("G75");
    out_.emit_block({code}, axes);
    if (returns) after.push_back(motion_code(motion));
    if (!after.empty()) out_.emit_block(after, {});
  }

  static ir::Code motion_code(Function function) {
    ir::Code code;
    code.function = function;
    code.group = ir::ModalGroup::motion;
    return code;
  }
  static bool acts_after(const ir::Code& c) {
    return c.function == Function::program_stop || c.function == Function::optional_stop ||
           c.function == Function::coolant_off || c.function == Function::spindle_stop;
  }

  // G91 G28 Z0 and G28 W0 name the axis only.
  [[nodiscard]] bool has_intermediate_point(const std::vector<ir::Code>& codes, const ir::Block& block) const {
    return std::ranges::any_of(program_.words_of(block), [&](const ir::Word& w) {
      if (!axis(w)) return false;
      const ir::Expression& value = program_.at(w.value);
      return value.op != ir::Operator::constant || value.value != 0.0 || !is_increment(w, codes);
    });
  }
  [[nodiscard]] bool is_increment(const ir::Word& w, const std::vector<ir::Code>& codes) const {
    const ir::WordMode mode = in_axes(w).mode;
    if (mode != ir::WordMode::as_modal) return mode == ir::WordMode::incremental;
    const auto here = std::ranges::find(codes, ir::ModalGroup::distance, &ir::Code::group);
    if (here != codes.end()) return here->function == Function::incremental;
    const facts::Facts* before = modes_.before(index_);
    if (before == nullptr) return false;
    const facts::Known<facts::Setting>& distance = (*before)[facts::Mode::distance];
    return distance.agrees() && distance.value.function == Function::incremental;
  }

  // The word by the axis that its letter moves.
  [[nodiscard]] ir::Word in_axes(ir::Word w) const {
    if (letters_are_increments_) incremental_letter(w, raising_.from);
    return w;
  }
  [[nodiscard]] std::optional<Address> axis(const ir::Word& w) const {
    const Address address = in_axes(w).address;
    return w.value != ir::ExpressionId::none && ir::is_axis(address) ? std::optional(address) : std::nullopt;
  }
  // G75 wants the machine's own names (X1=).
  ir::Word machine_axis(Address axis) {
    ir::Word word = ir::word(Address::other, number(0));
    word.name = program_.strings.add(std::string(1, static_cast<char>('A' + static_cast<int>(axis))) + "1");
    return word;
  }
  ir::ExpressionId number(int value) { return program_.add_constant(value, {}, false); }

  const Raising& raising_;
  ir::Program& program_;
  bool letters_are_increments_;
  facts::Resolved modes_;
  passes::Rewrite out_;
  ir::Statement statement_;
  std::uint32_t index_ = 0;
};

}  // namespace

void raise_reference(const Raising& raising) {
  if (std::ranges::any_of(raising.program.codes, is_reference)) ReferenceRaiser(raising).run();
}

}  // namespace dripfeed::sinumerik
