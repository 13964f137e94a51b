// Builds small programs by hand, a statement a line, so that tests need no reader: the program's lines are 1, 2, 3 …
// in the order of the calls.
#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "dialects/ir/ir.h"

namespace dripfeed::test {

class ProgramBuilder {
 public:
  using Id = ir::ExpressionId;

  explicit ProgramBuilder(std::string_view name = "MAIN") { program_.name = name; }

  // --- expressions
  Id number(double value, bool has_point = true) { return program_.add_constant(value, {}, has_point); }
  Id vacant() {
    ir::Expression e;
    e.op = ir::Operator::vacant;
    return program_.add(e);
  }
  Id text(std::string_view value) {
    ir::Expression e;
    e.op = ir::Operator::string;
    e.string = program_.strings.add(value);
    return program_.add(e);
  }
  Id apply(ir::Operator op, Id a, Id b = Id::none, Id c = Id::none) {
    ir::Expression e;
    e.op = op;
    e.a = a;
    e.b = b;
    e.c = c;
    return program_.add(e);
  }
  static ir::Variable hash(std::uint32_t number) { return {.bank = ir::Bank::hash, .number = number, .span = {}}; }
  static ir::Variable r(std::uint32_t number) { return {.bank = ir::Bank::r, .number = number, .span = {}}; }
  static ir::Variable indirect(ir::Bank bank, Id index) { return {.bank = bank, .index = index, .span = {}}; }
  static ir::Variable named(ir::SymbolId symbol, Id index = Id::none, Id index2 = Id::none) {
    return {.bank = ir::Bank::named, .symbol = symbol, .index = index, .index2 = index2, .span = {}};
  }
  static ir::Variable system(std::uint32_t row, Id index = Id::none) {
    return {.bank = ir::Bank::system, .number = row, .index = index, .span = {}};
  }
  Id read(const ir::Variable& variable) { return program_.add_variable(variable); }

  // --- declarations
  ir::SymbolId declare(std::string_view name, ir::ValueType type = ir::ValueType::real, std::uint16_t rows = 0,
                       std::uint16_t columns = 0) {
    ir::Symbol symbol;
    symbol.name = program_.strings.add(name);
    symbol.type = type;
    symbol.dimension1 = rows;
    symbol.dimension2 = columns;
    return program_.add(symbol);
  }
  ir::Symbol& symbol(ir::SymbolId id) { return program_.symbols[static_cast<std::uint32_t>(id)]; }

  // --- blocks
  struct CodeText {
    ir::Function function;
    int argument = 0;
    ir::ModalGroup group = ir::ModalGroup::none;
    std::string_view name = {};
    Id number = Id::none;  // computed
    char letter = 'G';
  };
  struct WordText {
    WordText(ir::Address a, double v, ir::WordMode m = ir::WordMode::as_modal) : address(a), constant(v), mode(m) {}
    WordText(ir::Address a, Id v, ir::WordMode m = ir::WordMode::as_modal) : address(a), value(v), mode(m) {}
    ir::Address address;
    double constant = 0.0;
    Id value = Id::none;
    ir::WordMode mode = ir::WordMode::as_modal;
    std::uint8_t extension = 0;
    std::string_view name = {};
  };
  void block(std::initializer_list<CodeText> codes, std::initializer_list<WordText> words = {}) {
    block(std::vector(codes), std::vector(words));
  }
  void block(const std::vector<CodeText>& codes, const std::vector<WordText>& words) {
    ir::Block block{.first_code = size_of(program_.codes), .first_word = size_of(program_.words)};
    for (const CodeText& text : codes) {
      ir::Code code;
      code.function = text.function;
      code.argument = static_cast<std::int16_t>(text.argument);
      code.group = text.group;
      code.letter = text.letter;
      code.number = text.number;
      if (!text.name.empty()) code.name = program_.strings.add(text.name);
      program_.codes.push_back(code);
    }
    for (const WordText& text : words) {
      ir::Word word;
      word.address = text.address;
      word.extension = text.extension;
      word.mode = text.mode;
      word.value = text.value != Id::none ? text.value : number(text.constant);
      if (!text.name.empty()) word.name = program_.strings.add(text.name);
      program_.words.push_back(word);
    }
    block.code_count = size_of(program_.codes) - block.first_code;
    block.word_count = size_of(program_.words) - block.first_word;
    statement(ir::StatementKind::block, program_.blocks, block);
  }

  // --- other statements
  void assign(const ir::Variable& target, Id value) {
    statement(ir::StatementKind::assign, program_.assigns, ir::Assign{program_.add(target), value});
  }
  void structure(ir::StatementKind kind, const ir::Structure& structure = {}) {
    statement(kind, program_.structures, structure);
  }
  void when(ir::StatementKind kind, Id condition) { structure(kind, {.condition = condition}); }
  void for_begin(const ir::Variable& counter, Id first, Id last) {
    structure(ir::StatementKind::for_begin, {.counter = program_.add(counter), .first = first, .last = last});
  }
  void jump(const ir::Jump& jump) { statement(ir::StatementKind::go_to, program_.jumps, jump); }
  void go_to(std::uint32_t number, Id condition = Id::none) { jump({.condition = condition, .number = number}); }
  void go_to(std::string_view label, ir::JumpSearch search, Id condition = Id::none, bool tolerant = false) {
    jump({.condition = condition, .search = search, .tolerant = tolerant, .label = program_.strings.add(label)});
  }
  // The next statement starts at that block number or label.
  void label(std::uint32_t number) {
    program_.labels.push_back({.number = number, .statement = size_of(program_.statements), .span = {}});
  }
  void label(std::string_view name) {
    program_.labels.push_back(
        {.name = program_.strings.add(name), .statement = size_of(program_.statements), .span = {}});
  }
  void call(ir::CallKind kind, std::string_view name, std::initializer_list<ir::Argument> arguments = {},
            Id repeats = Id::none, Id number = Id::none) {
    ir::Call call{.kind = kind, .number = number, .repeats = repeats, .first_argument = size_of(program_.arguments)};
    if (!name.empty()) call.name = program_.strings.add(name);
    program_.arguments.insert(program_.arguments.end(), arguments);
    call.argument_count = static_cast<std::uint32_t>(arguments.size());
    statement(ir::StatementKind::call, program_.calls, call);
  }
  // All symbols that are parameters, as declared so far.
  void procedure(bool saves_modal = false) {
    structure(ir::StatementKind::procedure,
              {.first_symbol = 0, .symbol_count = size_of(program_.symbols), .saves_modal = saves_modal});
  }
  void define(ir::SymbolId first, std::uint32_t count = 1) {
    structure(ir::StatementKind::define, {.first_symbol = static_cast<std::uint32_t>(first), .symbol_count = count});
  }
  void message(Id text) { statement(ir::StatementKind::message, program_.messages, ir::Message{.text = text}); }
  void alarm(Id number, Id text = Id::none) {
    statement(ir::StatementKind::alarm, program_.messages, ir::Message{.text = text, .number = number});
  }
  void native(std::string_view name, bool effects_known) {
    statement(ir::StatementKind::native, program_.natives, ir::Native{program_.strings.add(name), effects_known});
  }
  void back() { add(ir::StatementKind::subprogram_return); }
  void back_to(std::uint32_t number) {
    statement(ir::StatementKind::return_to, program_.jumps, ir::Jump{.number = number});
  }
  void end() { add(ir::StatementKind::program_end); }
  // A statement without a payload; the index of where it stands.
  std::uint32_t add(ir::StatementKind kind, std::uint32_t payload = ir::kNoIndex) {
    ir::Statement statement;
    statement.kind = kind;
    statement.payload = payload;
    statement.line = ++line_;
    program_.statements.push_back(statement);
    return size_of(program_.statements) - 1;
  }

  // Matches structures; what has no partner stays without.
  ir::Program& build() {
    ir::match_structures(program_);
    return program_;
  }
  ir::Program& program() { return program_; }

 private:
  template <class T>
  static std::uint32_t size_of(const std::vector<T>& arena) {
    return static_cast<std::uint32_t>(arena.size());
  }
  template <class T>
  void statement(ir::StatementKind kind, std::vector<T>& arena, const T& payload) {
    arena.push_back(payload);
    add(kind, size_of(arena) - 1);
  }

  ir::Program program_;
  std::uint32_t line_ = 0;
};

}  // namespace dripfeed::test
