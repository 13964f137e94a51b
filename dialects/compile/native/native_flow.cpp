// One walk over the flow graph, which differs in where it begins, where it stops, and whether it leaves what it began
// in.
#include "dialects/compile/native/native_flow.h"

#include <algorithm>
#include <utility>

#include "dialects/facts/calls.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/ir/sections.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

bool calls(const ir::Program& program, const ir::Statement& s, ir::StringId name) {
  return name != ir::StringId::none && facts::is_call(s.kind) && program.calls[s.payload].name == name;
}

bool is_called(const ir::Program& program, const ir::Section& section) {
  return std::ranges::any_of(program.statements,
                             [&](const ir::Statement& s) { return calls(program, s, section.name); });
}

class Walk {
 public:
  Walk(const ir::Program& program, std::vector<bool> stops, bool goes_back)
      : program_(program),
        graph_(program),
        stops_(std::move(stops)),
        goes_back_(goes_back),
        reached_(program.statements.size() + 1, false) {}

  void reach(std::uint32_t statement) {
    if (reached_[statement]) return;
    reached_[statement] = true;
    work_.push_back(statement);
  }

  void leave(std::uint32_t i) {
    const std::vector<std::uint32_t> following = graph_.after(i);
    for (const std::uint32_t next : following) reach(next);
    enter_called(i);
    if (goes_back_ && (following.empty() || ir::returns(program_.statements[i].kind))) go_back(i);
    if (!may_go_anywhere(i)) return;
    const facts::StatementRange own = facts::section_of(program_, i);
    for (const ir::Label& label : program_.labels)
      if (label.statement >= own.first && label.statement < own.last) reach(label.statement);
  }

  std::vector<bool> run() {
    while (!work_.empty()) {
      const std::uint32_t i = work_.back();
      work_.pop_back();
      if (i < program_.statements.size() && !stops_[i]) leave(i);
    }
    return std::move(reached_);
  }

 private:
  void enter_called(std::uint32_t i) {
    for (const ir::Section& section : program_.sections)
      if (calls(program_, program_.statements[i], section.name)) reach(section.first);
  }

  void go_back(std::uint32_t i) {
    const facts::StatementRange own = facts::section_of(program_, i);
    const auto section = std::ranges::find(program_.sections, own.first, &ir::Section::first);
    if (section == program_.sections.end()) return;
    for (std::uint32_t call = 0; call < program_.statements.size(); ++call) {
      if (!calls(program_, program_.statements[call], section->name)) continue;
      for (const std::uint32_t next : std::vector(graph_.after(call))) reach(next);
    }
  }

  // To any label of its program.
  [[nodiscard]] bool may_go_anywhere(std::uint32_t i) const {
    const ir::Statement& s = program_.statements[i];
    if (s.kind == StatementKind::go_to) return program_.jumps[s.payload].computed != ir::ExpressionId::none;
    if (s.kind == StatementKind::call) return program_.calls[s.payload].name == ir::StringId::none;
    if (s.kind == StatementKind::native)
      return facts::jumps_anywhere(program_.strings.at(program_.natives[s.payload].name));
    return s.kind == StatementKind::repeat_section || s.kind == StatementKind::execute_text;
  }

  const ir::Program& program_;
  facts::FlowGraph graph_;
  std::vector<bool> stops_;
  bool goes_back_;
  std::vector<bool> reached_;
  std::vector<std::uint32_t> work_;
};

}  // namespace

ir::Section main_section(const ir::Program& program) {
  const auto main =
      std::ranges::find_if(program.sections, [&](const ir::Section& one) { return !is_called(program, one); });
  return main != program.sections.end() ? *main : ir::section_at(program, 0);
}

std::vector<bool> reached_without(const ir::Program& program, std::uint32_t setting) {
  std::vector<bool> stops(program.statements.size(), false);
  stops[setting] = true;
  Walk walk(program, std::move(stops), false);
  walk.reach(main_section(program).first);
  for (const ir::Section& section : program.sections)
    if (!is_called(program, section)) walk.reach(section.first);
  return walk.run();
}

std::vector<bool> reached_from(const ir::Program& program, std::uint32_t start, const std::vector<bool>& stops) {
  Walk walk(program, stops, false);
  walk.reach(start);
  return walk.run();
}

std::vector<bool> reached_after(const ir::Program& program, const std::vector<std::uint32_t>& from,
                                const std::vector<bool>& stops) {
  Walk walk(program, stops, true);
  for (const std::uint32_t one : from) walk.leave(one);
  return walk.run();
}

std::vector<bool> shares_locals(const ir::Program& program, std::uint32_t statement) {
  const auto group_of = [&](std::uint32_t at) { return facts::section_of(program, at).first; };
  std::vector<std::uint32_t> groups = {group_of(statement)};
  for (std::size_t done = 0; done < groups.size(); ++done) {
    const auto add = [&](std::uint32_t first) {
      if (std::ranges::find(groups, first) == groups.end()) groups.push_back(first);
    };
    for (std::uint32_t i = 0; i < program.statements.size(); ++i) {
      const ir::Statement& s = program.statements[i];
      if (!facts::is_call(s.kind) || program.calls[s.payload].kind != ir::CallKind::subprogram) continue;
      for (const ir::Section& section : program.sections) {
        if (!calls(program, s, section.name)) continue;
        if (group_of(i) == groups[done]) add(section.first);
        if (section.first == groups[done]) add(group_of(i));
      }
    }
  }
  std::vector<bool> out(program.statements.size());
  for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = std::ranges::find(groups, group_of(i)) != groups.end();
  return out;
}

}  // namespace dripfeed::compile
