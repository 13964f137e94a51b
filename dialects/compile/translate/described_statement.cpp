// One mark a field, so that no two fields run into each other.
#include "dialects/compile/translate/described_statement.h"

#include <bit>
#include <iterator>

#include <fmt/format.h>

#include "dialects/ir/called_cycle.h"
#include "dialects/passes/walk.h"

namespace dripfeed::compile {

namespace {

class Description {
 public:
  explicit Description(const ir::Program& program) : program_(program) {}

  std::string of(const ir::Statement& s) {
    add("{} {}", static_cast<int>(s.kind), s.skip_level);
    if (s.payload == ir::kNoIndex) return std::move(out_);
    own_fields(s);
    passes::for_each_root(
        program_, s, [this](ir::ExpressionId id) { expression(id); }, [this](ir::VariableId id) { variable(id); });
    return std::move(out_);
  }

 private:
  template <class... Fields>
  void add(fmt::format_string<Fields...> form, Fields&&... fields) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<Fields>(fields)...);
    out_ += ';';
  }
  void name(ir::StringId id) { add("\"{}\"", program_.strings.at(id)); }

  void own_fields(const ir::Statement& s) {
    switch (s.kind) {
      case ir::StatementKind::block: return block(program_.blocks[s.payload]);
      case ir::StatementKind::call:
      case ir::StatementKind::modal_call: return call(program_.calls[s.payload]);
      case ir::StatementKind::output: return output(program_.outputs[s.payload]);
      case ir::StatementKind::native: return name(program_.natives[s.payload].name);
      default: return;
    }
  }

  void block(const ir::Block& b) {
    add("/{}", b.rest_level);
    for (const ir::Code& c : program_.codes_of(b)) {
      add("{} {} {} {}", static_cast<int>(c.function), c.argument, static_cast<int>(c.group), c.letter);
      name(c.name);
      add("{} {}", c.number == ir::ExpressionId::none, ir::in_rest(b, c.span));
    }
    for (const ir::Word& w : program_.words_of(b)) {
      add("{} {} {}", static_cast<int>(w.address), w.extension, static_cast<int>(w.mode));
      name(w.name);
      add("{} {} {}", w.value == ir::ExpressionId::none, w.axis == ir::ExpressionId::none, ir::in_rest(b, w.span));
    }
  }

  void call(const ir::Call& c) {
    add("{} {} {}", static_cast<int>(c.kind), c.in_other_language, c.cycle == nullptr ? "" : c.cycle->name);
    name(c.name);
    for (const ir::Argument& a : program_.arguments_of(c))
      add("{} {}", static_cast<int>(a.letter), a.value == ir::ExpressionId::none);
  }

  void output(const ir::Output& o) {
    add("{}", static_cast<int>(o.kind));
    for (std::uint32_t i = 0; i < o.part_count; ++i) {
      const ir::OutputPart& part = program_.output_parts[o.first_part + i];
      name(part.text);
      add("{} {} {}", part.whole_digits, part.decimals, part.value == ir::ExpressionId::none);
    }
  }

  // Operands first, so that the order of the operators is the tree.
  void expression(ir::ExpressionId id) {
    passes::for_each_node(program_, id, [this](ir::ExpressionId node) {
      const ir::Expression& e = program_.at(node);
      add("{} {} {}", static_cast<int>(e.op), e.has_point, std::bit_cast<std::uint64_t>(e.value));
      if (e.op == ir::Operator::variable) variable(e.variable);
      if (e.op == ir::Operator::string) name(e.string);
    });
    out_ += '|';
  }

  void variable(ir::VariableId id) {
    const ir::Variable& v = program_.at(id);
    add("{} {}", static_cast<int>(v.bank), v.number);
    if (v.symbol != ir::SymbolId::none) name(program_.at(v.symbol).name);
    name(v.name);
    for (const ir::ExpressionId index : {v.index, v.index2, v.index3}) add("{}", index == ir::ExpressionId::none);
  }

  const ir::Program& program_;
  std::string out_;
};

}  // namespace

std::string described_statement(const ir::Program& program, std::uint32_t statement) {
  return Description(program).of(program.statements[statement]);
}

}  // namespace dripfeed::compile
