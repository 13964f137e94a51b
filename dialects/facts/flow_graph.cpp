// One case a kind of statement. Labels are in the order of the text, so that a jump's target is searched from where it
// stands.
#include "dialects/facts/flow_graph.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "dialects/ir/called_cycle.h"
#include "dialects/ir/repetition.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::facts {

namespace {

using ir::StatementKind;

}  // namespace

StatementRange section_of(const ir::Program& program, std::uint32_t statement) {
  const auto after = std::ranges::upper_bound(program.sections, statement, {}, &ir::Section::first);
  if (after != program.sections.begin()) return {std::prev(after)->first, std::prev(after)->last};
  return {0, static_cast<std::uint32_t>(program.statements.size())};
}

std::uint32_t target_of(const ir::Program& program, std::uint32_t jump_statement) {
  const ir::Jump& jump = program.jumps[program.statements[jump_statement].payload];
  const StatementRange own = section_of(program, jump_statement);
  if (jump.restart) return own.first;
  if (jump.computed != ir::ExpressionId::none) return ir::kNoIndex;
  const auto matches = [&jump](const ir::Label& label) {
    return jump.label != ir::StringId::none ? label.name == jump.label
                                            : label.name == ir::StringId::none && label.number == jump.number;
  };
  const auto begin = std::ranges::lower_bound(program.labels, own.first, {}, &ir::Label::statement);
  const auto labels = std::ranges::subrange(
      begin, std::ranges::lower_bound(begin, program.labels.end(), own.last, {}, &ir::Label::statement));
  const auto after = std::ranges::partition_point(
      labels, [jump_statement](const ir::Label& label) { return label.statement <= jump_statement; });
  if (jump.search == ir::JumpSearch::backward) {
    const auto top = std::make_reverse_iterator(labels.begin());
    const auto found = std::find_if(std::make_reverse_iterator(after), top, matches);
    return found == top ? ir::kNoIndex : found->statement;
  }
  const auto found = std::find_if(after, labels.end(), matches);
  if (found != labels.end()) return found->statement;
  if (jump.search == ir::JumpSearch::forward) return ir::kNoIndex;
  const auto from_top = std::find_if(labels.begin(), after, matches);
  return from_top == after ? ir::kNoIndex : from_top->statement;
}

std::vector<bool> jump_targets(const ir::Program& program) {
  std::vector<bool> found(program.statements.size(), false);
  for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
    if (program.statements[i].kind != StatementKind::go_to) continue;
    if (program.jumps[program.statements[i].payload].computed != ir::ExpressionId::none)
      for (const ir::Label& label : program.labels) found[label.statement] = true;
    const std::uint32_t target = target_of(program, i);
    if (target != ir::kNoIndex) found[target] = true;
  }
  return found;
}

bool jumps_anywhere(std::string_view native) {
  constexpr std::string_view kNames[] = {"CALL", "SETINT", "SYNTAX ERROR"};
  return std::ranges::find(kNames, native) != std::end(kNames);
}

namespace {

// The name of a contour; nullptr where the call has none.
const ir::Expression* contour_of(const ir::Program& program, const ir::Call& call) {
  if (!ir::runs_contour(call)) return nullptr;
  const ir::ExpressionId name = ir::value_of(program, call, ir::CycleValue::contour);
  return name == ir::ExpressionId::none ? nullptr : &program.at(name);
}

// A contour "BEGIN:END" is the blocks between its labels: where they begin, kNoIndex for other contours.
std::uint32_t contour_begin(const ir::Program& program, std::uint32_t call) {
  const ir::Expression* contour = contour_of(program, program.calls[program.statements[call].payload]);
  if (contour == nullptr || contour->op != ir::Operator::string) return ir::kNoIndex;
  const std::string_view name = program.strings.at(contour->string);
  if (!name.contains(':')) return ir::kNoIndex;
  const StatementRange own = section_of(program, call);
  const auto block = ir::labelled_block(program, {.first = own.first, .last = own.last},
                                        text::upper_case(name.substr(0, name.find(':'))));
  return block ? block->first : ir::kNoIndex;
}

// A part of the program itself, from a block of it on.
bool calls_itself(const ir::Call& call) {
  return call.name == ir::StringId::none && call.number == ir::ExpressionId::none &&
         call.computed == ir::ExpressionId::none;
}

bool names_computed_blocks(const ir::Program& program, const ir::Call& call) {
  const ir::Expression* contour = contour_of(program, call);
  return contour != nullptr && contour->op != ir::Operator::string;
}

}  // namespace

FlowGraph::FlowGraph(const ir::Program& program) : program_(program) {}

std::vector<std::uint32_t> FlowGraph::entries() const {
  const bool open = std::ranges::any_of(program_.statements, [this](const ir::Statement& s) {
    if (s.kind == StatementKind::repeat_section || s.kind == StatementKind::execute_text) return true;
    if (s.kind == StatementKind::call) {
      const ir::Call& call = program_.calls[s.payload];
      return calls_itself(call) || names_computed_blocks(program_, call);
    }
    return s.kind == StatementKind::native && jumps_anywhere(program_.strings.at(program_.natives[s.payload].name));
  });
  return entries_of(open || jumps_to_computed());
}

std::vector<std::uint32_t> FlowGraph::entries_for_good() const { return entries_of(jumps_to_computed()); }

std::vector<std::uint32_t> FlowGraph::entries_of(bool with_labels) const {
  std::vector<std::uint32_t> found = {0};
  for (const ir::Section& section : program_.sections)
    if (section.first != 0) found.push_back(section.first);
  if (with_labels)
    for (const ir::Label& label : program_.labels) found.push_back(label.statement);
  return found;
}

bool FlowGraph::jumps_to_computed() const {
  return std::ranges::any_of(program_.statements, [this](const ir::Statement& s) {
    return s.kind == StatementKind::go_to && program_.jumps[s.payload].computed != ir::ExpressionId::none;
  });
}

// 1 true, 0 false, -1 not known before it runs
int FlowGraph::constant_condition(ir::ExpressionId condition) const {
  if (condition == ir::ExpressionId::none) return 1;
  const ir::Expression& e = program_.at(condition);
  return e.op == ir::Operator::constant ? (e.value != 0.0 ? 1 : 0) : -1;
}

std::uint32_t FlowGraph::partner_of(const ir::Statement& s) const { return program_.structures[s.payload].partner; }

// Into the body when the condition may be true, after the partner when it may be false.
void FlowGraph::opener(std::uint32_t i, int enter) {
  const std::uint32_t partner = partner_of(program_.statements[i]);
  if (enter != 0 || partner == ir::kNoIndex) after_.push_back(i + 1);
  if (enter != 1 && partner != ir::kNoIndex) after_.push_back(partner + 1);
}

void FlowGraph::jump(std::uint32_t i) {
  const ir::Jump& jump = program_.jumps[program_.statements[i].payload];
  const std::uint32_t target = target_of(program_, i);
  const int taken = constant_condition(jump.condition);
  if (target != ir::kNoIndex && taken != 0) after_.push_back(target);
  if (taken != 1 || target == ir::kNoIndex) after_.push_back(i + 1);
}

const std::vector<std::uint32_t>& FlowGraph::after(std::uint32_t i) {
  after_.clear();
  if (i >= program_.statements.size()) return after_;
  const ir::Statement& s = program_.statements[i];
  switch (s.kind) {
    case StatementKind::go_to: jump(i); break;
    case StatementKind::if_begin:
    case StatementKind::while_begin: opener(i, constant_condition(program_.structures[s.payload].condition)); break;
    case StatementKind::for_begin: opener(i, -1); break;
    case StatementKind::else_begin: after_.push_back(partner_of(s) == ir::kNoIndex ? i + 1 : partner_of(s) + 1); break;
    case StatementKind::while_end:
    case StatementKind::for_end:
    case StatementKind::loop_end: after_.push_back(partner_of(s) == ir::kNoIndex ? i + 1 : partner_of(s)); break;
    case StatementKind::repeat_end: {
      const int done = constant_condition(program_.structures[s.payload].condition);
      if (done != 1 && partner_of(s) != ir::kNoIndex) after_.push_back(partner_of(s));
      if (done != 0) after_.push_back(i + 1);
      break;
    }
    case StatementKind::subprogram_return:
    case StatementKind::return_to:
    case StatementKind::program_end: break;
    case StatementKind::native:
      if (program_.strings.at(program_.natives[s.payload].name) != "RET") after_.push_back(i + 1);
      break;
    case StatementKind::call:
      after_.push_back(i + 1);
      if (const std::uint32_t contour = contour_begin(program_, i); contour != ir::kNoIndex) after_.push_back(contour);
      break;
    case StatementKind::empty:
    case StatementKind::block:
    case StatementKind::assign:
    case StatementKind::if_end:
    case StatementKind::repeat_begin:
    case StatementKind::loop_begin:
    case StatementKind::define:
    case StatementKind::procedure:
    case StatementKind::declaration:
    case StatementKind::modal_call:
    case StatementKind::modal_call_end:
    case StatementKind::output:
    case StatementKind::message:
    case StatementKind::alarm:
    case StatementKind::repeat_section:
    case StatementKind::execute_text: after_.push_back(i + 1); break;
  }
  // The operator's switch leaves a jump or an end out.
  if (s.skip_level != 0 && !ir::is_structure(s.kind) && std::ranges::find(after_, i + 1) == after_.end())
    after_.push_back(i + 1);
  const std::uint32_t end = section_of(program_, i).last;
  if (end < program_.statements.size()) std::erase(after_, end);
  return after_;
}

}  // namespace dripfeed::facts
